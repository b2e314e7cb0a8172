#include "zonal/math/quadrature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "zonal/math/legendre.h"
#include "zonal/math/vec.h"

namespace zonal {
namespace {

/// The greatest error of the rule on P_0 .. P_{degrees-1}, whose integrals over [-1, 1] are 2, 0, 0, ...
double worst_legendre_error(const Quadrature& rule, int degrees) {
  std::vector<double> sums(degrees, 0.0), p(degrees);
  for (std::size_t i = 0; i < rule.size(); ++i) {
    legendre(rule.nodes[i], p);
    for (int l = 0; l < degrees; ++l) sums[l] += rule.weights[i] * p[l];
  }
  sums[0] -= 2;
  double worst = 0;
  for (const double sum : sums) worst = std::max(worst, std::abs(sum));
  return worst;
}

Quadrature fejer_rule(int rows) {
  Quadrature rule{{}, fejer_weights(rows)};
  for (int j = 0; j < rows; ++j) rule.nodes.push_back(std::cos(kPi * (j + 0.5) / rows));
  return rule;
}

TEST(GaussLegendre, KnowsTheSmallRules) {
  EXPECT_EQ(gauss_legendre(1).nodes[0], 0);
  EXPECT_DOUBLE_EQ(gauss_legendre(1).weights[0], 2);
  EXPECT_DOUBLE_EQ(gauss_legendre(2).nodes[1], std::sqrt(1.0 / 3));
  const Quadrature three = gauss_legendre(3);
  EXPECT_DOUBLE_EQ(three.nodes[0], -std::sqrt(0.6));
  EXPECT_EQ(three.nodes[1], 0);
  EXPECT_NEAR(three.weights[1], 8.0 / 9, 1e-15);
  EXPECT_NEAR(three.weights[2], 5.0 / 9, 1e-15);
}

TEST(GaussLegendre, IsExactBelowTwiceItsNodesAndNoFurther) {
  for (const int n : {1, 2, 3, 8, 33, 100}) {
    EXPECT_LT(worst_legendre_error(gauss_legendre(n), 2 * n), 1e-14) << n;
    EXPECT_GT(worst_legendre_error(gauss_legendre(n), 2 * n + 1), 1e-3 / n) << n;
  }
}

TEST(GaussLegendre, HoldsForThousandsOfNodes) {
  const Quadrature rule = gauss_legendre(2001);
  EXPECT_LT(worst_legendre_error(rule, 4002), 5e-14);  // 2001 rounded terms
  EXPECT_TRUE(std::ranges::is_sorted(rule.nodes));
  EXPECT_GT(rule.nodes.front(), -1);
}

TEST(GaussLegendre, MapsToAnyInterval) {
  const Quadrature rule = gauss_legendre(20, 0.5, 3);
  double sum = 0;
  for (std::size_t i = 0; i < rule.size(); ++i) sum += rule.weights[i] * std::exp(rule.nodes[i]);
  EXPECT_NEAR(sum, std::exp(3.0) - std::exp(0.5), 1e-13);
}

TEST(GaussLegendre, JoinsPanels) {
  const Quadrature rule = gauss_legendre_panels(12, {-1, 0.25, 2});
  ASSERT_EQ(rule.size(), 24u);
  double sum = 0;
  for (std::size_t i = 0; i < rule.size(); ++i) sum += rule.weights[i] * std::abs(rule.nodes[i] - 0.25);
  EXPECT_NEAR(sum, (1.25 * 1.25 + 1.75 * 1.75) / 2, 1e-14);  // the kink lies between the panels
}

TEST(Fejer, IntegratesEveryDegreeBelowItsRows) {
  for (const int rows : {1, 2, 3, 4, 7, 16, 65, 512}) {
    const Quadrature rule = fejer_rule(rows);
    EXPECT_LT(worst_legendre_error(rule, rows), 1e-14) << rows;
    // An even degree equal to the rows is the first that fails: cos(n theta) is zero at every node.
    const int first_wrong = rows % 2 == 0 ? rows : rows + 1;
    EXPECT_GT(worst_legendre_error(rule, first_wrong + 1), 0.05 / rows / rows) << rows;
  }
}

TEST(Fejer, WeightsArePositiveSymmetricAndSumToTwo) {
  for (const int rows : {2, 5, 64, 1023}) {
    const std::vector<double> weights = fejer_weights(rows);
    EXPECT_EQ(weights.size(), static_cast<std::size_t>(rows));
    EXPECT_GT(*std::ranges::min_element(weights), 0);
    EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 2, 1e-14);
    for (int j = 0; j < rows; ++j) EXPECT_EQ(weights[j], weights[rows - 1 - j]);
  }
}

}  // namespace
}  // namespace zonal
