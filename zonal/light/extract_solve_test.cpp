#include "zonal/light/extract_solve.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <random>

namespace zonal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Problem {
  MatrixXd columns, gram;
  VectorXd target, right;
};

Problem random_problem(int unknowns, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Problem p;
  p.columns = MatrixXd::NullaryExpr(12, unknowns, [&] { return normal(random); });
  p.target = VectorXd::NullaryExpr(12, [&] { return normal(random); });
  p.gram = p.columns.transpose() * p.columns;
  p.right = p.columns.transpose() * p.target;
  return p;
}

/// Karush, Kuhn and Tucker: feasible, and no feasible step goes downhill. Enough, as the problem is convex.
void expect_optimal(const Problem& p, const VectorXd& x, double budget) {
  const double tolerance = 1e-12 * p.right.cwiseAbs().maxCoeff();
  EXPECT_GE(x.minCoeff(), 0);
  EXPECT_LE(x.sum(), budget * (1 + 1e-14));
  const VectorXd slope = p.right - p.gram * x;
  const double highest = std::max(slope.maxCoeff(), 0.0);
  if (x.sum() < budget * (1 - 1e-12)) {
    EXPECT_LE(highest, tolerance);
  }
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (x(i) > 0) {
      EXPECT_NEAR(slope(i), highest, tolerance);  // else intensity would move to the steepest one
    }
  }
}

TEST(ExtractSolve, FindsTheConstrainedMinimum) {
  std::mt19937 random(1);
  int at_zero = 0, at_budget = 0, inside = 0;
  for (int unknowns = 1; unknowns <= 8; ++unknowns) {
    for (int trial = 0; trial < 200; ++trial) {
      const Problem p = random_problem(unknowns, random);
      const double budget = std::exponential_distribution<double>(2)(random);
      const VectorXd x = nonnegative_least_squares(p.gram, p.right, budget);
      expect_optimal(p, x, budget);
      at_zero += x.minCoeff() == 0;
      at_budget += x.sum() > budget * (1 - 1e-12);
      inside += x.minCoeff() > 0 && x.sum() < budget * (1 - 1e-12);
    }
  }
  EXPECT_GT(at_zero, 500);
  EXPECT_GT(at_budget, 200);
  EXPECT_GT(inside, 50);
}

TEST(ExtractSolve, LeavesTheFreeMinimumWhereItIsAllowed) {
  std::mt19937 random(2);
  int compared = 0;
  for (int trial = 0; trial < 50; ++trial) {
    Problem p = random_problem(4, random);
    const VectorXd wanted =
        VectorXd::NullaryExpr(4, [&] { return std::exponential_distribution<double>()(random) + 0.1; });
    p.right = p.gram * wanted;
    EXPECT_NEAR((least_squares(p.gram, p.right) - wanted).norm(), 0, 1e-11);
    EXPECT_NEAR((nonnegative_least_squares(p.gram, p.right, wanted.sum() + 1) - wanted).norm(), 0, 1e-11);
    ++compared;
  }
  EXPECT_EQ(compared, 50);
}

TEST(ExtractSolve, OfTwoEqualColumnsTheLaterGetsNothing) {
  std::mt19937 random(3);
  Problem p = random_problem(3, random);
  p.columns.col(2) = p.columns.col(0);
  p.target = 2 * p.columns.col(0) + 3 * p.columns.col(1);
  p.gram = p.columns.transpose() * p.columns;
  p.right = p.columns.transpose() * p.target;
  for (const VectorXd& x : {least_squares(p.gram, p.right), nonnegative_least_squares(p.gram, p.right, 100)}) {
    EXPECT_NEAR(x(0), 2, 1e-12);
    EXPECT_NEAR(x(1), 3, 1e-12);
    EXPECT_EQ(x(2), 0);
  }
}

TEST(ExtractSolve, NothingToGiveAndNothingToFit) {
  std::mt19937 random(4);
  const Problem p = random_problem(3, random);
  EXPECT_EQ(nonnegative_least_squares(p.gram, p.right, 0), VectorXd::Zero(3));
  EXPECT_EQ(nonnegative_least_squares(p.gram, p.right, -1), VectorXd::Zero(3));
  EXPECT_EQ(nonnegative_least_squares(p.gram, VectorXd::Zero(3), 1), VectorXd::Zero(3));
  EXPECT_EQ(nonnegative_least_squares(MatrixXd(0, 0), VectorXd(0), 1).size(), 0);
  EXPECT_EQ(least_squares(MatrixXd(0, 0), VectorXd(0)).size(), 0);
  EXPECT_EQ(least_squares(MatrixXd::Zero(2, 2), VectorXd::Zero(2)), VectorXd::Zero(2));
}

}  // namespace
}  // namespace zonal
