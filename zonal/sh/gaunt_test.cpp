#include "zonal/sh/gaunt.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "zonal/math/sphere_rule.h"
#include "zonal/sh/eval.h"

namespace zonal {
namespace {

TEST(Gaunt, CountsAreThePublishedOnes) {
  const std::vector<std::size_t> symmetric = {1, 4, 25, 77, 238, 549}, ordered = {1, 10, 83, 353, 1158, 2907};
  for (int bands = 1; bands <= 6; ++bands) {
    std::size_t orders = 0;
    for (const auto& [i, j, k, value] : gaunt_integrals(bands)) {
      ASSERT_LE(i, j);
      ASSERT_LE(j, k);
      ASSERT_LT(k, coefficient_count(bands));
      orders += i == k ? 1 : i == j || j == k ? 3 : 6;
    }
    EXPECT_EQ(gaunt_integrals(bands).size(), symmetric[bands - 1]);
    EXPECT_EQ(orders, ordered[bands - 1]);
  }
  EXPECT_THROW(gaunt_integrals(0), std::logic_error);
  EXPECT_THROW(gaunt_integrals(7), std::logic_error);
}

TEST(Gaunt, AgreesWithIntegrationOverTheSphere) {
  std::map<std::tuple<int, int, int>, double> listed;
  for (const auto& [i, j, k, value] : gaunt_integrals(6)) listed[{i, j, k}] = value;
  // Degree 15 needs the rule for products of two functions of 9 bands.
  std::vector<std::array<double, 36>> y;
  std::vector<double> weights;
  for (const auto& [direction, weight] : sphere_rule(9)) {
    basis_unrolled<6, double>(direction.x, direction.y, direction.z, y.emplace_back().data());
    weights.push_back(weight);
  }
  int compared = 0, zero = 0;
  double worst = 0;
  for (int k = 0; k < 36; ++k) {
    for (int j = 0; j <= k; ++j) {
      for (int i = 0; i <= j; ++i, ++compared) {
        double integral = 0;
        for (std::size_t d = 0; d < y.size(); ++d) integral += weights[d] * y[d][i] * y[d][j] * y[d][k];
        const auto entry = listed.find({i, j, k});
        zero += entry == listed.end();
        worst = std::max(worst, std::abs(integral - (entry == listed.end() ? 0 : entry->second)));
      }
    }
  }
  EXPECT_EQ(compared, 36 * 37 * 38 / 6);
  EXPECT_EQ(zero, compared - 549);
  EXPECT_LT(worst, 2e-14);  // 162 rounded terms of size 1/10
}

}  // namespace
}  // namespace zonal
