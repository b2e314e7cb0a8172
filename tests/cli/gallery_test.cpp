#include <nlohmann/json.hpp>

#include "tests/cli/command.h"

namespace zonal {
namespace {

using CliGallery = Cli;
using SlowCliGallery = Cli;

TEST_F(SlowCliGallery, DrawsEveryFigureWithoutAnyFile) {
  const auto result = nlohmann::json::parse(good({"gallery", "-o", "out", "--json"}).out);
  ASSERT_EQ(result.at("figures").size(), 17u);
  int numbers = 0;
  for (const auto& figure : result["figures"]) {
    for (const auto& number : figure.at("numbers")) {
      EXPECT_TRUE(number.at("holds").get<bool>()) << figure.at("id") << ": " << number.at("what");
      ++numbers;
    }
  }
  EXPECT_GE(numbers, 65);
  EXPECT_TRUE(result.at("warnings").empty());

  for (const auto& file : result.at("files")) {
    EXPECT_EQ(std::filesystem::file_size(path(file.at("path").get<std::string>())), file.at("bytes"));
  }
  EXPECT_GE(result["files"].size(), 34u);
  EXPECT_EQ(files("out").size(), result["files"].size());
  EXPECT_LT(std::filesystem::file_size(path("out/index.html")), 6'000'000u);
  const std::string page = bytes_of(path("out/index.html"));
  EXPECT_NE(page.find("31 : −1"), std::string::npos);
  EXPECT_NE(page.find("built-in"), std::string::npos);
}

TEST_F(SlowCliGallery, ShowsAProbeOfAnyKindAndTurnsIt) {
  good({"testcard", "--to", "cube-cross", "--size", "16", "-o", "cross.png"});
  good({"gallery", "-o", "card", "--probe", "cross.png", "--from", "cube-cross", "--quiet"});
  EXPECT_NE(bytes_of(path("card/index.html")).find("cross.png"), std::string::npos);
  good({"gallery", "-o", "turned", "--probe", "cross.png", "--from", "cube-cross", "--rotate", "90", "--quiet"});
  EXPECT_NE(bytes_of(path("turned/index.html")), bytes_of(path("card/index.html")));
  EXPECT_EQ(bytes_of(path("turned/windows.svg")), bytes_of(path("card/windows.svg")));  // it needs no light
  EXPECT_EQ(files("turned").size(), files("card").size());
}

TEST_F(SlowCliGallery, ABlackProbeIsStillAGallery) {
  good({"sky", "furnace", "--radiance", "0", "--size", "8", "-o", "black.exr"});
  good({"gallery", "-o", "out", "--probe", "black.exr", "--quiet"});
  EXPECT_EQ(bytes_of(path("out/index.html")).find("not a number"), std::string::npos);
}

TEST_F(CliGallery, SaysWhatIsWrong) {
  bad(2, {"gallery"}, "--output");
  bad(2, {"gallery", "-o", "out", "--rotate", "90"}, "--probe");  // there is nothing to turn
  bad(3, {"gallery", "-o", "out", "--probe", "missing.exr"}, "missing.exr");
}

}  // namespace
}  // namespace zonal
