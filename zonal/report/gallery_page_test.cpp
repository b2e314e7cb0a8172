#include "zonal/report/gallery_page.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "zonal/io/file.h"
#include "zonal/io/picture.h"
#include "zonal/report/html_check.h"
#include "zonal/report/svg.h"

namespace zonal {
namespace {

namespace fs = std::filesystem;

/// A folder that is gone afterwards.
class GalleryPage : public testing::Test {
 protected:
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_ = fs::temp_directory_path() / ("zonal-gallery-page-" + std::to_string(::getpid()));
};

std::vector<GalleryFigure> two_figures() {
  const std::string svg = svg_frame(100, 50, "plot", "a line", svg_line(0, 0, 100, 50, 1));
  Image<Rgb> picture(4, 2, {0.5f, 0, 1});
  return {{.id = "first",
           .title = "First <figure>",
           .source = "a source",
           .pictures = {{.name = "line", .alt = "a line", .svg = svg}},
           .caption = "a caption & more",
           .numbers = {{"ratio", "17 : 1", 17, 17, 1e-13}, {"free", "", 0.25, 0.5, 1}}},
          {.id = "second",
           .title = "Second",
           .source = "another",
           .pictures = {{.name = "square", .alt = "a square", .picture = picture, .scale = 2},
                        {.name = "other", .alt = "a line", .svg = svg}},
           .caption = "no numbers"}};
}

TEST_F(GalleryPage, IsWellFormedAndSaysEverything) {
  const HtmlCheck check = HtmlReader::read(gallery_page_html(two_figures(), {"<probe>.exr", "Zonal 1"}));
  EXPECT_EQ(check.problems, std::vector<std::string>());
  EXPECT_EQ(check.tags.at("section"), 2);
  EXPECT_EQ(check.tags.at("img"), 1);
  EXPECT_EQ(check.tags.at("svg"), 2);
  EXPECT_EQ(check.tags.at("table"), 1);  // none for a figure without numbers
  for (const char* words : {"First <figure>", "a caption & more", "a source", "<probe>.exr", "Zonal 1", "17 : 1",
                            "not printed; expected 0.5", "2 of 2"})
    EXPECT_NE(check.text.find(words), std::string::npos) << words;
}

TEST_F(GalleryPage, MarksWhatDiffers) {
  std::vector<GalleryFigure> figures = two_figures();
  EXPECT_EQ(gallery_page_html(figures, {}).find("differs"), std::string::npos);
  figures[0].numbers[0].ours = 17.5;
  const std::string page = gallery_page_html(figures, {});
  EXPECT_NE(page.find("differs"), std::string::npos);
  EXPECT_NE(page.find("1 of 2"), std::string::npos);
  figures[0].numbers[0].ours = std::nan("");
  EXPECT_NE(gallery_page_html(figures, {}).find("differs"), std::string::npos);
}

TEST_F(GalleryPage, WritesEveryPictureBesideThePage) {
  OutputFolder folder(folder_);
  const std::vector<GalleryFile> files = write_gallery(two_figures(), {"probe", "Zonal"}, folder);
  EXPECT_FALSE(fs::exists(folder_ / "index.html"));  // not before it is committed
  folder.commit();
  ASSERT_EQ(files.size(), 4u);
  EXPECT_EQ(files[0].name, "index.html");
  EXPECT_EQ(files[1].name, "line.svg");
  EXPECT_EQ(files[2].name, "square.png");
  EXPECT_EQ(files[3].name, "other.svg");
  for (const GalleryFile& file : files) EXPECT_EQ(fs::file_size(folder_ / file.name), file.bytes) << file.name;
  const Picture back = load_picture(folder_ / "square.png");
  ASSERT_EQ(back.pixels.width(), 4);
  // Linear light went through the sRGB curve and eight bits: steps of 1/255 at a slope of 2.3 at most.
  EXPECT_NEAR(back.pixels(0, 0).r, 0.5, 0.005);
  EXPECT_EQ(back.pixels(0, 0).b, 1);
}

TEST_F(GalleryPage, RefusesTwoPicturesOfOneName) {
  std::vector<GalleryFigure> figures = two_figures();
  figures[1].pictures[1].name = "line";
  OutputFolder folder(folder_);
  EXPECT_THROW(write_gallery(figures, {}, folder), std::logic_error);
}

TEST_F(GalleryPage, RefusesADrawingWithoutASize) {
  std::vector<GalleryFigure> figures = two_figures();
  figures[0].pictures[0].svg = "<svg></svg>";
  EXPECT_THROW(gallery_page_html(figures, {}), std::logic_error);
}

}  // namespace
}  // namespace zonal
