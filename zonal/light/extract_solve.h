#pragma once

#include <Eigen/Core>

namespace zonal {

/// Least squares for the intensities of lights, from the normal equations: the x that makes x.Gx/2 - b.x least. A
/// column that the others explain but for 1e-12 of its square gets zero (of two equal lights the later one), so that a
/// singular G has an answer too. O(n^4), n the number of lights.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& gram, const Eigen::VectorXd& right);

/// The same among those x with no negative entry and a sum of at most `budget`; all zero where that is not positive. By
/// active sets: exact but for rounding, after finitely many steps (Lawson & Hanson 1974, ch. 23, with the budget's
/// slack as one more unknown).
Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& gram, const Eigen::VectorXd& right, double budget);

}  // namespace zonal
