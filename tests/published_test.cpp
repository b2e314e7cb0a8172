// Numbers that others published of real environments. The files are kept beside the checkout; without them the tests
// are skipped.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "zonal/io/half.h"
#include "zonal/zonal.h"

namespace zonal {
namespace {

namespace fs = std::filesystem;

const fs::path kShared = fs::path(ZONAL_SOURCE_DIR) / ".." / "shared";

#define SKIP_WITHOUT_DATA()                                  \
  if (!fs::exists(kShared / "reference")) {                  \
    GTEST_SKIP() << "no reference data beside the checkout"; \
  }

nlohmann::json reference(const char* name) {
  return nlohmann::json::parse(std::ifstream(kShared / "reference" / name));
}

// The frame of light probes and cube samplers: x to the right of the view, y up, z forward.
const Rotation kProbeFromWorld = {{Vec3{0, -1, 0}, Vec3{0, 0, 1}, Vec3{1, 0, 0}}};

/// A DDS cube of 16-bit floats, six faces one after the other, as in the one file that is tested.
Environment half_float_dds(const fs::path& path, int face_size) {
  std::ifstream in(path, std::ios::binary);
  std::vector<char> bytes((std::istreambuf_iterator<char>(in)), {});
  const std::size_t texels = 6UL * face_size * face_size;
  EXPECT_EQ(bytes.size(), 128 + texels * 8);
  std::vector<std::uint16_t> halves(texels * 4);
  std::memcpy(halves.data(), bytes.data() + 128, halves.size() * 2);
  std::vector<float> floats(halves.size());
  floats_from_halves(halves, floats);
  Environment cube{Image<Rgb>(face_size, 6 * face_size), {Layout::kCubeStack}};
  for (std::size_t i = 0; i < texels; ++i)
    cube.radiance.values()[i] = {floats[4 * i], floats[4 * i + 1], floats[4 * i + 2]};
  return cube;
}

Environment galileo() { return half_float_dds(kShared / "data/cube_dds/galileo_cross_rgba16f.dds", 256); }

/// The greatest difference of two tables relative to the size of the first.
double difference(const Sh<RgbD>& got, const nlohmann::json& rows, double scale) {
  double squares = 0, errors = 0;
  int compared = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const RgbD want{rows[i][0], rows[i][1], rows[i][2]};
    const RgbD error = scale * got[i] - want;
    squares += want.r * want.r + want.g * want.g + want.b * want.b;
    errors += error.r * error.r + error.g * error.g + error.b * error.b;
    ++compared;
  }
  EXPECT_EQ(compared, static_cast<int>(got.size()));
  return std::sqrt(errors / squares);
}

TEST(Published, GalileoInDirectXMath) {
  SKIP_WITHOUT_DATA();
  const auto table = reference("directxmath_sh_order6.json")["probes"]["galileo"]["coefficients_rgb"];
  const Sh<RgbD> sh = to_condon_shortley(transformed(project(galileo(), 6), kProbeFromWorld));
  // Their texel weights are those of texel centres: 2e-5.
  EXPECT_LT(difference(sh, table, 1), 5e-5);
}

TEST(Published, OrangeBookTables) {
  SKIP_WITHOUT_DATA();
  const auto tables = reference("orange_book_sh_tables.json")["tables"];
  const Sh<RgbD> tomb = transformed(project(galileo(), 3), kProbeFromWorld);
  EXPECT_LT(difference(tomb, tables["Galileo's tomb"], 0.2), 5e-3);
  const Environment beach = load_environment(kShared / "data/angular/beach_probe.hdr").environment;
  ASSERT_EQ(beach.projection.layout, Layout::kAngular);
  const Sh<RgbD> sunset = transformed(project(beach, 3), kProbeFromWorld);
  EXPECT_LT(difference(sunset, tables["Funston Beach Sunset"], 0.4), 5e-3);
}

double relative_difference(const Sh<RgbD>& a, const Sh<RgbD>& b) {
  double squares = 0, errors = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    squares += b[i].g * b[i].g;
    errors += (a[i].g - b[i].g) * (a[i].g - b[i].g);
  }
  return std::sqrt(errors / squares);
}

TEST(Published, TheSameSceneInTwoPicturesHasTheSameCoefficients) {
  SKIP_WITHOUT_DATA();
  const fs::path data = kShared / "data";
  const auto coefficients = [&](const char* path) { return project(load_environment(data / path).environment, 4); };
  // The cube looks a quarter turn to the side of the panoramas.
  const Sh<RgbD> cube = transformed(coefficients("cube_faces_hdr/pisaHDR"), turned(90));
  const Sh<RgbD> panorama = coefficients("equirect/pisa_latlong_256.hdr");
  EXPECT_LT(relative_difference(cube, panorama), 0.02);
  EXPECT_LT(relative_difference(coefficients("equirect/probulator_pisa.hdr"), panorama), 0.02);
  EXPECT_LT(
      relative_difference(coefficients("equirect/blender_sunset.exr"), coefficients("equirect/venice_sunset_1k.hdr")),
      0.02);
  // The museum was photographed 1.8 times as bright as the wells.
  Sh<RgbD> museum = coefficients("equirect/mitsuba_museum.exr");
  museum *= 1 / 1.79852;
  EXPECT_LT(relative_difference(museum, coefficients("equirect/probulator_wells.hdr")), 0.05);
}

TEST(Published, AMirrorBallUnwraps) {
  SKIP_WITHOUT_DATA();
  const fs::path data = kShared / "data/mirror_ball";
  EnvironmentLoadOptions as_ball;
  as_ball.from = Projection{Layout::kMirrorBall};
  const Environment ball = load_environment(data / "office_ball_calib.hdr", as_ball).environment;
  const Environment theirs = load_environment(data / "office_ball_unwrapped_equirect.hdr").environment;
  ResampleOptions options;
  options.world_from_source = turned(180);  // their left edge looks away from the camera
  const Environment ours = resample(ball, {Layout::kEquirect}, ImageSize{720, 360}, options);
  std::vector<double> ratios;
  double a_sum = 0, b_sum = 0, aa = 0, bb = 0, ab = 0;
  for (int y = 0; y < 360; ++y) {
    for (int x = 0; x < 720; ++x) {
      const double a = std::log(1e-3 + luminance(ours.radiance(x, y))),
                   b = std::log(1e-3 + luminance(theirs.radiance(x, y)));
      ratios.push_back(std::abs(a - b));
      a_sum += a, b_sum += b, aa += a * a, bb += b * b, ab += a * b;
    }
  }
  const auto n = static_cast<double>(ratios.size());
  const double correlation = (ab - a_sum * b_sum / n) / std::sqrt((aa - a_sum * a_sum / n) * (bb - b_sum * b_sum / n));
  std::nth_element(ratios.begin(), ratios.begin() + ratios.size() / 2, ratios.end());
  EXPECT_GT(correlation, 0.94);
  EXPECT_LT(ratios[ratios.size() / 2], 0.02);
}

TEST(SlowPublished, NegativePixelsKeepTheirEnergy) {
  SKIP_WITHOUT_DATA();
  int maps = 0;
  for (const auto& entry : fs::directory_iterator(kShared / "data/equirect")) {
    const Environment sky = load_environment(entry.path()).environment;
    const Survey facts = survey(sky);
    if (facts.negative_texels == 0) continue;
    const Sh<RgbD> sh = project(sky, 1);
    const double mean = sh[0].g / std::sqrt(4 * kPi);
    EXPECT_NEAR(facts.mean.g, mean, 1e-5 * std::abs(mean)) << entry.path();
    const Convolved blurred = convolve(sky, Lobe::ggx(0.3), {Layout::kEquirect}, {128, 64});
    EXPECT_NEAR(project(blurred.map, 1)[0].g / std::sqrt(4 * kPi), mean, 2e-3 * mean) << entry.path();
    EXPECT_EQ(blurred.report.zeroed_texels, 0) << entry.path();
    ++maps;
  }
  EXPECT_GE(maps, 15);
}

}  // namespace
}  // namespace zonal
