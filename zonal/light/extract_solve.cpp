#include "zonal/light/extract_solve.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <vector>

namespace zonal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Indices = std::vector<Eigen::Index>;

constexpr double kDependent = 1e-12;  // the part of a column's square that must be its own

/// The least squares with some columns alone.
VectorXd solve_with(const MatrixXd& gram, const Indices& columns, const VectorXd& right) {
  const MatrixXd block = gram(columns, columns);
  const VectorXd sides = right(columns);
  return block.ldlt().solve(sides);
}

/// Whether column i is more than a combination of the columns `others`.
bool independent(const MatrixXd& gram, const Indices& others, Eigen::Index i) {
  double own = gram(i, i);
  if (!others.empty()) {
    const VectorXd shared = gram.col(i);
    own -= VectorXd(shared(others)).dot(solve_with(gram, others, shared));
  }
  return own > kDependent * gram(i, i);
}

/// The unknowns that are not held at zero, and what follows from that.
class ActiveSet {
 public:
  ActiveSet(const MatrixXd& gram, const VectorXd& right, double budget)
      : gram_(gram), right_(right), budget_(budget), x_(VectorXd::Zero(right.size())) {}

  const VectorXd& x() const { return x_; }

  /// Frees the unknown at zero that lowers the sum of squares fastest. False when none does: x is the answer.
  bool improve() {
    const VectorXd slope = right_ - gram_ * x_ - VectorXd::Constant(x_.size(), multiplier_);
    const double least = 1e-14 * right_.cwiseAbs().maxCoeff();
    if (!slack_free_ && -multiplier_ > least) {
      slack_free_ = true;
      settle();
      return true;
    }
    Eigen::Index best = -1;
    for (Eigen::Index i = 0; i < x_.size(); ++i) {
      if (slope(i) > least && !contains(free_, i) && !contains(useless_, i) && (best < 0 || slope(i) > slope(best)) &&
          independent(gram_, free_, i)) {
        best = i;
      }
    }
    if (best < 0) return false;
    const VectorXd before = x_;
    free_.push_back(best);
    settle();
    if (x_ == before) useless_.push_back(best);  // its slope was rounding
    return true;
  }

 private:
  static bool contains(const Indices& set, Eigen::Index i) { return std::find(set.begin(), set.end(), i) != set.end(); }
  double slack() const { return budget_ - x_.sum(); }

  /// Goes to the best x with the free unknowns, and holds those at zero that are met on the way.
  void settle() {
    // Each pass but the last holds one unknown or the slack.
    for (Eigen::Index pass = 0; pass < x_.size() + 2 && !free_.empty(); ++pass) {
      const VectorXd goal = best_with_free();
      const VectorXd now = x_(free_);
      double part = 1;
      for (Eigen::Index k = 0; k < goal.size(); ++k) {
        if (goal(k) <= 0) part = std::min(part, now(k) / (now(k) - goal(k)));
      }
      const double slack_goal = budget_ - goal.sum(), slack_now = slack();
      const bool slack_ends = slack_free_ && slack_goal < 0 && slack_now <= part * (slack_now - slack_goal);
      if (slack_ends) part = std::max(slack_now / (slack_now - slack_goal), 0.0);
      x_(free_) = now + part * (goal - now);
      if (slack_ends) {
        slack_free_ = false;
      } else if (part == 1 && goal.minCoeff() > 0) {
        return;
      } else {
        hold_what_is_zero(goal);
      }
    }
  }

  VectorXd best_with_free() {
    const auto n = static_cast<Eigen::Index>(free_.size());
    if (slack_free_) {
      multiplier_ = 0;
      return solve_with(gram_, free_, right_);
    }
    MatrixXd bordered = MatrixXd::Ones(n + 1, n + 1);  // Lagrange's equations for a sum of exactly `budget`
    bordered.topLeftCorner(n, n) = gram_(free_, free_);
    bordered(n, n) = 0;
    VectorXd sides(n + 1);
    sides << right_(free_), budget_;
    const VectorXd solved = bordered.partialPivLu().solve(sides);
    multiplier_ = solved(n);
    return solved.head(n);
  }

  void hold_what_is_zero(const VectorXd& goal) {
    Indices still_free;
    const double zero = 1e-15 * x_.maxCoeff();
    for (std::size_t k = 0; k < free_.size(); ++k) {
      const Eigen::Index i = free_[k];
      if (goal(static_cast<Eigen::Index>(k)) <= 0 && x_(i) <= zero) {
        x_(i) = 0;
      } else {
        still_free.push_back(i);
      }
    }
    free_ = still_free;
  }

  const MatrixXd& gram_;
  const VectorXd& right_;
  double budget_;
  VectorXd x_;
  Indices free_, useless_;
  bool slack_free_ = true;  // the sum is below the budget
  double multiplier_ = 0;   // of the budget, while the sum is held at it
};

}  // namespace

VectorXd least_squares(const MatrixXd& gram, const VectorXd& right) {
  Indices used;
  for (Eigen::Index i = 0; i < right.size(); ++i) {
    if (independent(gram, used, i)) used.push_back(i);
  }
  VectorXd x = VectorXd::Zero(right.size());
  if (!used.empty()) x(used) = solve_with(gram, used, right);
  return x;
}

VectorXd nonnegative_least_squares(const MatrixXd& gram, const VectorXd& right, double budget) {
  ActiveSet set(gram, right, budget);
  if (!(budget > 0) || right.size() == 0) return set.x();
  // Every step lowers the sum of squares, so no set of free unknowns returns; the limit is for rounding alone, and what
  // is reached by then is a valid x all the same.
  for (Eigen::Index step = 0; step < 10 * (right.size() + 1) && set.improve(); ++step) {
  }
  const double sum = set.x().sum();
  return sum > budget ? VectorXd(budget / sum * set.x()) : set.x();  // the equations hold it to rounding only
}

}  // namespace zonal
