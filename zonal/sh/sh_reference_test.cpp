#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "zonal/sh/convention.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/irradiance.h"

namespace zonal {
namespace {

const std::filesystem::path kVectors = ZONAL_SOURCE_DIR "/../shared/reference/vectors";

nlohmann::json read_json(const char* name) {
  std::ifstream file(kVectors / name);
  return nlohmann::json::parse(file);
}

Vec3 vec3(const nlohmann::json& v) { return {v[0], v[1], v[2]}; }

TEST(ShReference, BasisAgreesWithFortyDigits) {
  if (!std::filesystem::exists(kVectors)) GTEST_SKIP() << "no reference vectors here";
  const nlohmann::json reference = read_json("sh_basis.json");
  constexpr int kBands = 11;
  int compared = 0;
  for (std::size_t d = 0; d < reference["directions"].size(); ++d) {
    Sh<double> y(kBands);
    basis(kBands, vec3(reference["directions"][d]), y.values());
    y = to_condon_shortley(y);
    for (std::size_t i = 0; i < y.size(); ++i, ++compared) {
      // The directions are unit to 1e-16 only, which a polynomial of degree 10 multiplies by up to 10 times its size
      // of 1.
      EXPECT_NEAR(y[i], reference["values"][d][i].get<double>(), 2e-14) << d << " " << i;
    }
  }
  EXPECT_EQ(compared, 50 * 121);
}

TEST(ShReference, IrradianceAgreesWithThePublishedFormulas) {
  if (!std::filesystem::exists(kVectors)) GTEST_SKIP() << "no reference vectors here";
  const nlohmann::json reference = read_json("irradiance_a10.json");
  Sh<double, 3> with_sign;
  for (int i = 0; i < 9; ++i) with_sign[i] = reference["L"][i];
  const Sh<double, 3> radiance = from_condon_shortley(with_sign);
  int compared = 0;
  for (std::size_t i = 0; i < reference["normals"].size(); ++i, ++compared) {
    const Vec3 n = vec3(reference["normals"][i]);
    EXPECT_NEAR(evaluate(irradiance(radiance), n), reference["E"][i].get<double>(), 1e-14);
    EXPECT_NEAR(evaluate(irradiance_over_pi(radiance), n), reference["E_over_pi"][i].get<double>(), 1e-14);
  }
  EXPECT_EQ(compared, 20);
}

}  // namespace
}  // namespace zonal
