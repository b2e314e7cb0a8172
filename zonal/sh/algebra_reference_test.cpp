// Rotation, products and half spaces against published numbers. Those carry the Condon-Shortley sign: a coefficient or
// an index with odd m changes its sign on the way to ours.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "zonal/sh/convention.h"
#include "zonal/sh/gaunt.h"
#include "zonal/sh/half_space.h"
#include "zonal/sh/product.h"
#include "zonal/sh/product_matrix.h"
#include "zonal/sh/rotate.h"

namespace zonal {
namespace {

const std::filesystem::path kVectors = ZONAL_SOURCE_DIR "/../shared/reference/vectors";
constexpr double kTolerance = 1e-12;  // the files were computed in double by long sums

nlohmann::json read_json(const char* name) {
  std::ifstream file(kVectors / name);
  return nlohmann::json::parse(file);
}

template <int N>
Sh<double, N> read_sh(const nlohmann::json& values) {
  Sh<double, N> sh;
  EXPECT_EQ(values.size(), sh.size());
  for (std::size_t i = 0; i < sh.size(); ++i) sh[i] = values[i];
  return from_condon_shortley(sh);
}

struct Lm {
  int l, m;
  double sign;
};

Lm lm_of(int i) {
  const int l = static_cast<int>(std::sqrt(i)), m = i - l * (l + 1);
  return {l, m, m % 2 == 0 ? 1.0 : -1.0};
}

TEST(AlgebraReference, RotationMatrix) {
  if (!std::filesystem::exists(kVectors)) GTEST_SKIP() << "no reference vectors here";
  const nlohmann::json reference = read_json("conv_rot.json");
  Rotation r;
  for (int i = 0; i < 3; ++i) {
    const auto& row = reference["rotation_matrix_R (g(s)=f(R s))"][i];
    r.rows[i] = {row[0], row[1], row[2]};
  }
  // g(s) = f(R s) is what rotating by the transpose does.
  const ShRotation<6> turn(transpose(r));
  int compared = 0;
  for (int i = 0; i < 36; ++i) {
    for (int j = 0; j < 36; ++j, ++compared) {
      const Lm a = lm_of(i), b = lm_of(j);
      const double expected = reference["sh_rotation_matrix_order6 (g=M f)"][i][j];
      const double ours = a.l == b.l ? a.sign * b.sign * turn(a.l, a.m, b.m) : 0;
      EXPECT_NEAR(ours, expected, kTolerance) << i << " " << j;
    }
  }
  EXPECT_EQ(compared, 1296);
}

TEST(AlgebraReference, GauntIntegrals) {
  if (!std::filesystem::exists(kVectors)) GTEST_SKIP() << "no reference vectors here";
  const nlohmann::json reference = read_json("triple_product.json");
  std::map<std::array<int, 3>, double> expected;
  for (const auto& entry : reference["nonzero"]) expected[{entry[0], entry[1], entry[2]}] = entry[3];
  int compared = 0;
  for (const auto& [i, j, k, value] : gaunt_integrals(6)) {
    const auto entry = expected.find({i, j, k});
    ASSERT_NE(entry, expected.end()) << int{i} << " " << int{j} << " " << int{k};
    EXPECT_NEAR(lm_of(i).sign * lm_of(j).sign * lm_of(k).sign * value, entry->second, kTolerance);
    ++compared;
  }
  EXPECT_EQ(compared, 549);
  EXPECT_EQ(expected.size(), 549u);
  ASSERT_EQ(reference["counts"].size(), 6u);
  for (const auto& row : reference["counts"]) {
    EXPECT_EQ(gaunt_integrals(row["n"]).size(), row["nonzero_i_le_j_le_k"].get<std::size_t>());
  }
}

TEST(AlgebraReference, Products) {
  if (!std::filesystem::exists(kVectors)) GTEST_SKIP() << "no reference vectors here";
  const nlohmann::json example = read_json("triple_product.json")["example"];
  const Sh<double, 6> f = read_sh<6>(example["f"]), g = read_sh<6>(example["g"]);
  const Sh<double, 6> truncated = read_sh<6>(example["product_truncated_order6"]), p = product(f, g);
  const Sh<double, 6> by_matrix = ProductMatrix<6>(f).apply(g);
  const Sh<double, 11> full = read_sh<11>(example["product_full_order11"]), q = full_product(f, g);
  for (std::size_t i = 0; i < truncated.size(); ++i) {
    EXPECT_NEAR(p[i], truncated[i], kTolerance) << i;
    EXPECT_NEAR(by_matrix[i], truncated[i], kTolerance) << i;
  }
  for (std::size_t i = 0; i < full.size(); ++i) EXPECT_NEAR(q[i], full[i], kTolerance) << i;
}

TEST(AlgebraReference, HalfSpaceMatrices) {
  if (!std::filesystem::exists(kVectors)) GTEST_SKIP() << "no reference vectors here";
  const nlohmann::json reference = read_json("mult_matrices.json");
  const AxialProduct<6> h = half_space<6>(), c = clamped_cosine<6>();
  int compared = 0;
  // Both harmonics of an entry have the same m, so the sign cancels.
  const auto entry = [&](const AxialProduct<6>& matrix, int i, int j) {
    const Lm a = lm_of(i), b = lm_of(j);
    return a.m == b.m ? matrix(a.l, b.l, a.m) : 0;
  };
  for (int i = 0; i < 36; ++i) {
    for (int j = 0; j < 36; ++j, ++compared) {
      EXPECT_NEAR(entry(h, i, j), reference["hemi_full"][i][j].get<double>(), kTolerance) << i << " " << j;
      EXPECT_NEAR(entry(c, i, j), reference["cos_full"][i][j].get<double>(), kTolerance) << i << " " << j;
    }
  }
  EXPECT_EQ(compared, 1296);
  // The exact entries as published, and nothing besides them.
  int listed = 0, nonzero = 0;
  for (const auto& e : reference["hemi"]) {
    EXPECT_NEAR(entry(h, e[0], e[1]), e[2].get<double>(), kTolerance);
    ++listed;
  }
  for (const auto& e : reference["cos"]) {
    EXPECT_NEAR(entry(c, e[0], e[1]), e[2].get<double>(), kTolerance);
    ++listed;
  }
  for (int i = 0; i < 36; ++i) {
    for (int j = i; j < 36; ++j) nonzero += (std::abs(entry(h, i, j)) > 1e-9) + (std::abs(entry(c, i, j)) > 1e-9);
  }
  EXPECT_EQ(listed, 71 + 81);
  EXPECT_EQ(nonzero, 71 + 81);
}

}  // namespace
}  // namespace zonal
