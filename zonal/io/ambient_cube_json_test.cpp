#include "zonal/io/ambient_cube_json.h"

#include <gtest/gtest.h>

#include <limits>

#include "zonal/base/error.h"

namespace zonal {
namespace {

AmbientCubeFile example() {
  AmbientCubeFile file{ShQuantity::kIrradianceOverPi, {}};
  for (std::size_t i = 0; i < 6; ++i) file.cube.sides[i] = {0.1 * static_cast<double>(i), 1.0 / 3, -2e-30};
  return file;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(AmbientCubeJson, ReadsBackTheSameBits) {
  const std::string text = ambient_cube_json_text(example());
  EXPECT_EQ(parse_ambient_cube_json(text), example());
  EXPECT_EQ(ambient_cube_json_text(parse_ambient_cube_json(text)), text);
  EXPECT_NE(text.find("\"-Z\": [0.5, 0.3333333333333333, -2e-30]"), std::string::npos) << text;
}

TEST(AmbientCubeJson, RefusesWhatIsNotTheSchema) {
  const std::string text = ambient_cube_json_text(example());
  const std::vector<std::pair<std::string, std::string>> changes = {
      {"{", "["},
      {"zonal-ambient-cube", "zonal-sh"},
      {"\"version\": 1", "\"version\": 2"},
      {"\"version\": 1", "\"version\": \"1\""},
      {"irradiance/pi", "colour"},
      {"\"irradiance/pi\"", "7"},
      {"z-up-right-handed", "y-up"},
      {"\"frame\"", "\"frames\""},
      {"\"+X\"", "\"+W\""},
      {"\"+X\"", "\"-X\""},                       // one twice, one missing
      {"\"+X\":", "\"+X\": [1, 2, 3], \"+X\":"},  // one twice, all there
      {"\"+X\":", "\"up\": [1, 2, 3], \"+X\":"},
      {"[0.1, 0.3333333333333333, -2e-30]", "[0.1, 0.3333333333333333]"},
      {"[0.1, 0.3333333333333333, -2e-30]", "[0.1, 0.3333333333333333, null]"},
      {"[0.1, 0.3333333333333333, -2e-30]", "[0.1, 0.3333333333333333, 1e999]"},
      {"[0.1, 0.3333333333333333, -2e-30]", "0.1"},
  };
  int refused = 0;
  for (const auto& [from, to] : changes) {
    try {
      parse_ambient_cube_json(replaced(text, from, to));
      ADD_FAILURE() << from << " -> " << to;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::kInput);
      ++refused;
    }
  }
  EXPECT_EQ(refused, 16);
  for (std::size_t length = 0; length + 2 < text.size(); length += 7) {  // the last bracket, and a newline
    EXPECT_THROW(parse_ambient_cube_json(std::string_view(text).substr(0, length)), Error) << length;
  }
}

TEST(AmbientCubeJson, DoesNotWriteWhatIsNotFinite) {
  AmbientCubeFile file = example();
  file.cube.sides[2].g = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(ambient_cube_json_text(file), Error);
}

}  // namespace
}  // namespace zonal
