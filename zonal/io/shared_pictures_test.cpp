#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "zonal/io/environment_file.h"
#include "zonal/io/picture.h"

namespace zonal {
namespace {

namespace fs = std::filesystem;

const fs::path kData = fs::path(ZONAL_SOURCE_DIR) / ".." / "shared" / "data";

/// A row of the table in the data folder's README: what an independent reader measured.
struct Row {
  std::string size;
  double max = 0, mean = 0;
};

std::map<std::string, Row> read_table() {
  std::map<std::string, Row> table;
  std::ifstream in(kData / "README.md");
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, '|');) {
      const std::size_t from = cell.find_first_not_of(' '), to = cell.find_last_not_of(' ');
      cells.push_back(from == std::string::npos ? "" : cell.substr(from, to - from + 1));
    }
    double max = 0, mean = 0;
    if (cells.size() > 4 && std::sscanf(cells[4].c_str(), "%lf / %lf", &max, &mean) == 2)
      table[cells[1]] = {cells[2], max, mean};
  }
  return table;
}

/// The table gives four digits: half a unit of the last one is at most 5e-4 of the value; the rest is for the order of
/// summation.
constexpr double kFourDigits = 5.1e-4;

bool is_picture(const fs::path& path) {
  static const std::set<std::string> extensions = {".exr", ".hdr", ".png", ".jpg", ".jpeg", ".JPG", ".tga"};
  return extensions.contains(path.extension().string());
}

TEST(SlowSharedPictures, EveryFileLoadsAndAgreesWithTheTable) {
  if (!fs::exists(kData)) GTEST_SKIP() << "no shared data beside this checkout";
  const std::map<std::string, Row> table = read_table();
  ASSERT_GT(table.size(), 100u);
  int loaded = 0, compared = 0, float_files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kData)) {
    if (!entry.is_regular_file() || !is_picture(entry.path())) continue;
    const std::string name = fs::relative(entry.path(), kData).string();
    // The table's figures of 8 bit files are of the codes themselves.
    const Picture picture = load_picture(entry.path(), {.encoding = Encoding::kLinear});
    ++loaded;
    const auto row = table.find(name);
    if (row == table.end()) continue;
    EXPECT_EQ(std::to_string(picture.pixels.width()) + "x" + std::to_string(picture.pixels.height()), row->second.size)
        << name;
    double max = 0, sum = 0;
    for (const Rgb& pixel : picture.pixels.values()) {
      const double y = luminance(RgbD(pixel));
      max = std::max(max, y);
      sum += y;
    }
    const double mean = sum / static_cast<double>(picture.pixels.size());
    EXPECT_NEAR(max, row->second.max, kFourDigits * row->second.max) << name;
    EXPECT_NEAR(mean, row->second.mean, kFourDigits * row->second.mean) << name;
    ++compared;
    float_files += picture.format == "OpenEXR" || picture.format == "Radiance HDR";
  }
  EXPECT_GE(float_files, 50);
  EXPECT_GE(compared, float_files + 50);
  EXPECT_GE(loaded, compared);
  RecordProperty("loaded", loaded);
  RecordProperty("compared", compared);
}

TEST(SharedPictures, FoldersOfFacesBecomeCubes) {
  if (!fs::exists(kData)) GTEST_SKIP() << "no shared data beside this checkout";
  const LoadedEnvironment hdr = load_environment(kData / "cube_faces_hdr" / "pisaHDR");
  EXPECT_EQ(hdr.environment.radiance.width(), 256);
  EXPECT_EQ(hdr.environment.radiance.height(), 6 * 256);
  EXPECT_FALSE(hdr.srgb_decoded);
  const LoadedEnvironment ldr = load_environment(kData / "cube_faces_ldr" / "games202_CornellBox");
  EXPECT_EQ(ldr.environment.radiance.width(), 128);
  EXPECT_TRUE(ldr.srgb_decoded);
  EXPECT_EQ(ldr.files.size(), 6u);
}

}  // namespace
}  // namespace zonal
