#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "zonal/sh/ambient_cube.h"
#include "zonal/sh/convention.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/shading_constants.h"
#include "zonal/sh/window.h"

namespace zonal {
namespace {

const std::filesystem::path kVectors = ZONAL_SOURCE_DIR "/../shared/reference/vectors";

nlohmann::json read_json(const char* name) {
  std::ifstream file(kVectors / name);
  return nlohmann::json::parse(file);
}

template <int N>
Sh<double, N> from_signed(const nlohmann::json& values) {
  Sh<double, N> sh;
  for (std::size_t i = 0; i < sh.size(); ++i) sh[i] = values.at(i);
  return from_condon_shortley(sh);
}

TEST(ShTricksReference, Windows) {
  if (!std::filesystem::exists(kVectors)) GTEST_SKIP() << "no reference vectors here";
  const nlohmann::json reference = read_json("windows.json");
  int compared = 0;
  const auto compare = [&](const Window& window, const nlohmann::json& expected) {
    const std::vector<double> factors = window_factors(window, static_cast<int>(expected.size()));
    for (std::size_t l = 0; l < expected.size(); ++l, ++compared) {
      EXPECT_NEAR(factors[l], expected[l].get<double>(), 1e-15) << l;
    }
  };
  compare(Window::lanczos(6), reference["lanczos_w6"]);
  compare(Window::hann(6), reference["hanning_w6"]);
  compare(Window::lanczos(9.8725), reference["lanczos_w9.8725"]);
  compare(Window::lanczos(9.8725, 2), reference["lanczos_squared_w9.8725"]);
  compare(Window::hann(12.0105), reference["hanning_w12.0105"]);
  EXPECT_EQ(compared, 7 + 7 + 6 + 6 + 6);

  Sh<double, 6> delta;
  basis(6, {0, 0, 1}, delta.values());
  const auto peak = [&](const Window& with) { return evaluate(window(delta, with), {0, 0, 1}); };
  const nlohmann::json& heights = reference["delta_peak"];
  EXPECT_NEAR(peak(Window::none()), heights["none"].get<double>(), 2e-15);
  EXPECT_NEAR(peak(Window::hann(12.0105)), heights["hanning_w12.0105"].get<double>(), 2e-15);
  EXPECT_NEAR(peak(Window::lanczos(9.8725)), heights["lanczos_w9.8725"].get<double>(), 2e-15);
  EXPECT_NEAR(peak(Window::lanczos(9.8725, 2)), heights["lanczos2_w9.8725"].get<double>(), 2e-15);
  EXPECT_NEAR(squared_laplacian(delta) / reference["squared_laplacian_delta6"].get<double>(), 1, 1e-14);

  int fractions = 0;
  for (const nlohmann::json& entry : reference["laplace"]) {
    const double fraction = entry["fraction"], weight = laplacian_weight(band_energies(delta), fraction);
    EXPECT_NEAR(weight / entry["lambda"].get<double>(), 1, 1e-13);
    const Sh<double, 6> windowed = window(delta, Window::laplacian_fraction(fraction));
    for (int l = 0; l < 6; ++l) EXPECT_NEAR(windowed(l, 0) / delta(l, 0), entry["window"][l].get<double>(), 1e-14);
    ++fractions;
  }
  EXPECT_EQ(fractions, 4);
}

TEST(ShTricksReference, AmbientCube) {
  if (!std::filesystem::exists(kVectors)) GTEST_SKIP() << "no reference vectors here";
  const nlohmann::json reference = read_json("ambient_cube.json");
  int compared = 0;
  for (std::size_t side = 0; side < 6; ++side) {
    AmbientCube<double> cube;
    cube.sides[side] = 1;
    const Sh<double, 3> sh = to_condon_shortley(sh_from_ambient_cube<3>(cube));
    for (std::size_t i = 0; i < 9; ++i, ++compared) {
      EXPECT_NEAR(sh[i], reference["cube_to_sh_9x6"][i][side].get<double>(), 1e-15);
      Sh<double, 3> one;
      one[i] = 1;
      EXPECT_NEAR(ambient_cube(from_condon_shortley(one)).sides[side],
                  reference["sh_to_cube_6x9"][side][i].get<double>(), 2e-15);
    }
    EXPECT_NEAR(ambient_cube(from_signed<3>(reference["example"]["sh"])).sides[side],
                reference["example"]["cube"][side].get<double>(), 4e-15);
  }
  EXPECT_EQ(compared, 54);
}

TEST(ShTricksReference, ShadingConstants) {
  if (!std::filesystem::exists(kVectors)) GTEST_SKIP() << "no reference vectors here";
  const nlohmann::json reference = read_json("irradiance_a10.json");
  const Sh<double, 3> radiance = from_signed<3>(reference["L"]);
  const auto constants = irradiance_over_pi_constants(RgbD(1, 0, 0) * radiance);
  const auto matrix = irradiance_matrix(radiance);
  int compared = 0;
  for (std::size_t i = 0; i < reference["normals"].size(); ++i, ++compared) {
    const nlohmann::json& n = reference["normals"][i];
    const Vec3 normal = {n[0], n[1], n[2]};
    EXPECT_NEAR(irradiance_over_pi(constants, normal).r, reference["E_over_pi"][i].get<double>(), 4e-15);
    EXPECT_NEAR(irradiance(matrix, normal), reference["E"][i].get<double>(), 1e-14);
  }
  EXPECT_EQ(compared, 20);

  // The constants themselves, seen through unit coefficients.
  const auto of = [](int l, int m) {
    Sh<double, 3> one;
    one(l, m) = 1;
    return one;
  };
  const auto vectors = [&](int l, int m) { return irradiance_over_pi_constants(RgbD(1, 0, 0) * of(l, m)); };
  const nlohmann::json &fc = reference["fC"], &k = reference["k1_k5"];
  EXPECT_NEAR(vectors(0, 0).linear[0][3], fc[0].get<double>(), 1e-16);
  EXPECT_NEAR(vectors(1, 1).linear[0][0], fc[1].get<double>(), 1e-16);
  EXPECT_NEAR(vectors(2, -2).quadratic[0][0], fc[2].get<double>(), 1e-16);
  EXPECT_NEAR(vectors(2, 0).linear[0][3], -fc[3].get<double>(), 1e-16);
  EXPECT_NEAR(vectors(2, 2).last[0], fc[4].get<double>(), 1e-16);
  EXPECT_NEAR(irradiance_matrix(of(2, 2)).rows[0][0], k[0].get<double>(), 2e-16);
  EXPECT_NEAR(irradiance_matrix(of(1, 1)).rows[0][3], k[1].get<double>(), 2e-16);
  EXPECT_NEAR(irradiance_matrix(of(2, 0)).rows[2][2], k[2].get<double>(), 2e-16);
  EXPECT_NEAR(irradiance_matrix(of(0, 0)).rows[3][3], k[3].get<double>(), 2e-16);
  EXPECT_NEAR(irradiance_matrix(of(2, 0)).rows[3][3], -k[4].get<double>(), 2e-16);
}

}  // namespace
}  // namespace zonal
