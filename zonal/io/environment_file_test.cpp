#include "zonal/io/environment_file.h"

#include <gtest/gtest.h>

#include "zonal/base/error.h"
#include "zonal/io/face_files.h"
#include "zonal/io/sample_files_test.h"

namespace zonal {
namespace {

namespace fs = std::filesystem;

template <class Work>
Error error_of(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "nothing was thrown";
  return Error(ErrorKind::kCancelled, "nothing");
}

Image<Rgb> flat(int width, int height, float value) { return Image<Rgb>(width, height, Rgb(value, value, value)); }

TEST(EnvironmentFile, APanoramaIsGuessedByItsShape) {
  const sample::TemporaryFolder folder;
  const Image<Rgb> image = sample::random_picture(32, 16, 1);
  save_picture(image, folder / "sky.pfm");
  const LoadedEnvironment loaded = load_environment(folder / "sky.pfm");
  EXPECT_EQ(loaded.environment.radiance, image);
  EXPECT_EQ(loaded.environment.projection.layout, Layout::kEquirect);
  EXPECT_NE(loaded.projection_reason, "");
  EXPECT_EQ(loaded.files, std::vector<fs::path>{folder / "sky.pfm"});
  EXPECT_EQ(loaded.format, "PFM");
  EXPECT_EQ(loaded.hash.size(), 24u);
  save_picture(flat(32, 16, 1), folder / "other.pfm");
  EXPECT_NE(load_environment(folder / "other.pfm").hash, loaded.hash);
}

TEST(EnvironmentFile, TheAskedProjectionOverrulesAndMustFit) {
  const sample::TemporaryFolder folder;
  save_picture(flat(32, 16, 1), folder / "sky.pfm");
  const LoadedEnvironment loaded = load_environment(folder / "sky.pfm", {.from = Projection{Layout::kDualParaboloid}});
  EXPECT_EQ(loaded.environment.projection.layout, Layout::kDualParaboloid);
  const Error error = error_of([&] { load_environment(folder / "sky.pfm", {.from = Projection{Layout::kCubeStack}}); });
  EXPECT_EQ(error.kind(), ErrorKind::kInput);
  EXPECT_NE(std::string(error.what()).find("sky.pfm"), std::string::npos) << error.what();
  EXPECT_NE(error.hint(), "");
}

TEST(EnvironmentFile, AShapeThatSaysNothingIsAQuestion) {
  const sample::TemporaryFolder folder;
  save_picture(flat(50, 31, 1), folder / "x.pfm");
  const Error error = error_of([&] { load_environment(folder / "x.pfm"); });
  EXPECT_EQ(error.kind(), ErrorKind::kInput);
  EXPECT_NE(error.hint().find("--from"), std::string::npos);
}

TEST(EnvironmentFile, AFolderOfSixFacesUnderEveryUsualName) {
  const std::vector<std::vector<std::string>> sets = {{"px", "nx", "py", "ny", "pz", "nz"},
                                                      {"posx", "negx", "posy", "negy", "posz", "negz"},
                                                      {"right", "left", "top", "bottom", "front", "back"},
                                                      {"RIGHT", "left", "Up", "down", "front", "back"},
                                                      {"sky_px", "sky_nx", "sky_py", "sky_ny", "sky_pz", "sky_nz"}};
  int folders = 0;
  for (const auto& names : sets) {
    const sample::TemporaryFolder folder;
    for (std::size_t f = 0; f < 6; ++f) {
      save_picture(flat(4, 4, static_cast<float>(f + 1)), folder / (names[f] + (f == 2 ? ".hdr" : ".pfm")));
    }
    write_file(folder / "px.txt", "not a picture");
    const LoadedEnvironment loaded = load_environment(folder.path());
    EXPECT_EQ(loaded.environment.projection, Projection{Layout::kCubeStack});
    ASSERT_EQ(loaded.environment.radiance.height(), 24);
    for (int f = 0; f < 6; ++f)
      EXPECT_EQ(loaded.environment.radiance(3, 4 * f).g, static_cast<float>(f + 1)) << names[0] << f;
    EXPECT_EQ(loaded.files.size(), 6u);
    ++folders;
  }
  EXPECT_EQ(folders, 5);
}

TEST(EnvironmentFile, IncompleteFoldersSayWhatIsMissing) {
  const sample::TemporaryFolder folder;
  EXPECT_NE(std::string(error_of([&] { load_environment(folder.path()); }).what()).find("no cube faces"),
            std::string::npos);
  for (const char* name : {"posx", "negx", "posy", "posz", "negz"})
    save_picture(flat(4, 4, 1), folder / (std::string(name) + ".pfm"));
  const Error missing = error_of([&] { load_environment(folder.path()); });
  EXPECT_EQ(missing.kind(), ErrorKind::kInput);
  EXPECT_NE(std::string(missing.what()).find("no negy"), std::string::npos) << missing.what();
  save_picture(flat(5, 5, 1), folder / "negy.pfm");
  EXPECT_NE(std::string(error_of([&] { load_environment(folder.path()); }).what()).find("5x5"), std::string::npos);
  save_picture(flat(4, 4, 1), folder / "negy.pfm");
  save_picture(flat(4, 4, 1), folder / "negy.exr");
  EXPECT_NE(std::string(error_of([&] { load_environment(folder.path()); }).what()).find("two files"),
            std::string::npos);
}

TEST(EnvironmentFile, FacesThatAreNotSquareAreRefused) {
  const sample::TemporaryFolder folder;
  for (const std::string_view name : kFaceNames) save_picture(flat(4, 3, 1), folder / (std::string(name) + ".pfm"));
  EXPECT_EQ(error_of([&] { load_environment(folder.path()); }).kind(), ErrorKind::kInput);
}

TEST(EnvironmentFile, SixPathsAndTwoPaths) {
  const sample::TemporaryFolder folder;
  std::vector<fs::path> paths;
  for (int f = 0; f < 6; ++f) {
    paths.push_back(folder / ("face" + std::to_string(f) + ".pfm"));
    save_picture(flat(4, 4, static_cast<float>(f)), paths.back());
  }
  const LoadedEnvironment cube = load_environment(paths);
  for (int f = 0; f < 6; ++f) EXPECT_EQ(cube.environment.radiance(0, 4 * f + 3).r, static_cast<float>(f));
  EXPECT_EQ(error_of([&] { load_environment(paths, {.from = Projection{Layout::kEquirect}}); }).kind(),
            ErrorKind::kUsage);

  const std::span two = std::span(paths).subspan(1, 2);
  EXPECT_EQ(error_of([&] { load_environment(two); }).kind(), ErrorKind::kUsage);  // only when asked
  const LoadedEnvironment dual = load_environment(two, {.from = Projection{Layout::kDualParaboloid}});
  ASSERT_EQ(dual.environment.radiance.width(), 8);
  ASSERT_EQ(dual.environment.radiance.height(), 4);
  for (int x = 0; x < 8; ++x) EXPECT_EQ(dual.environment.radiance(x, 2).r, x < 4 ? 1 : 2);
  EXPECT_EQ(error_of([&] { load_environment(std::span(paths).first(3)); }).kind(), ErrorKind::kUsage);
}

TEST(EnvironmentFile, ACubeGoesOutAsSixFilesAndComesBack) {
  const sample::TemporaryFolder folder;
  const Environment cube = {sample::random_picture(8, 48, 5), {Layout::kCubeStack}};
  save_environment(cube, folder / "sky_%s.exr");
  EXPECT_EQ(folder.file_count(), 6u);
  EXPECT_TRUE(fs::exists(folder / "sky_nz.exr"));
  EXPECT_EQ(load_environment(folder.path()).environment.radiance, cube.radiance);
  save_environment(cube, folder / "one.pfm");
  EXPECT_EQ(load_environment(folder / "one.pfm").environment.radiance, cube.radiance);
}

TEST(EnvironmentFile, SixFilesAreWrittenOnlyTogether) {
  const sample::TemporaryFolder folder;
  const Environment cube = {flat(4, 24, 1), {Layout::kCubeStack}};
  fs::create_directory(folder / "ny.pfm");  // in the way of the fourth face
  EXPECT_THROW(save_environment(cube, folder / "%s.pfm"), Error);
  EXPECT_EQ(folder.file_count(), 1u);
  const Environment panorama = {flat(8, 4, 1), {Layout::kEquirect}};
  EXPECT_EQ(error_of([&] { save_environment(panorama, folder / "%s.pfm"); }).kind(), ErrorKind::kUsage);
}

TEST(EnvironmentFile, IsCalledByTheNameOfItsFirstPath) {
  const auto name = [](std::vector<fs::path> paths) { return environment_name(paths); };
  EXPECT_EQ(name({"skies/dawn.hdr"}), "dawn.hdr");
  EXPECT_EQ(name({"skies/cube"}), "cube");
  EXPECT_EQ(name({"skies/cube/"}), "cube");
  EXPECT_EQ(name({"front.jpg", "back.jpg"}), "front.jpg and 1 more");
}

TEST(EnvironmentFile, ClippingIsSummedOverFaces) {
  const sample::TemporaryFolder folder;
  const Environment cube = {flat(2, 12, 2), {Layout::kCubeStack}};
  EXPECT_EQ(save_environment(cube, folder / "%s.png").clipped_pixels, 24);
}

}  // namespace
}  // namespace zonal
