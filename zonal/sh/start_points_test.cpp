#include "zonal/sh/start_points.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "zonal/sh/zonal.h"
#include "zonal/sh/zonal_lights.h"

namespace zonal {
namespace {

constexpr std::array<int, 6> kStarts = {1, 3, 6, 10, 15, 22};  // for 1..6 bands (Sloan 2008)

/// The distance of the direction that is farthest from all points: at one of the two centres of some three of them.
double covering_radius(const std::vector<Vec3>& points) {
  if (points.size() < 3) return points.size() == 1 ? kPi : std::nan("");
  double widest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        const Vec3 normal = cross(points[j] - points[i], points[k] - points[i]);
        if (length(normal) < 1e-9) continue;
        for (const double sign : {1.0, -1.0}) {
          const Vec3 centre = sign * normalize(normal);
          double nearest = kPi;
          for (const Vec3 point : points) nearest = std::min(nearest, angle_between(centre, point));
          widest = std::max(widest, nearest);
        }
      }
    }
  }
  return widest;
}

/// From the peak of a delta function to its first zero; pi where it has none.
double first_zero(int bands) {
  const std::vector<double> delta = delta_zonal(bands);
  const int steps = 18000;
  for (int i = 1; i <= steps; ++i) {
    double low = kPi * (i - 1) / steps, high = kPi * i / steps;
    if (evaluate_zonal(delta, std::cos(high)) > 0) continue;
    for (int halving = 0; halving < 50; ++halving) {
      const double middle = (low + high) / 2;
      (evaluate_zonal(delta, std::cos(middle)) > 0 ? low : high) = middle;
    }
    return low;
  }
  return kPi;
}

TEST(StartPoints, HaveTheKnownLeastEnergies) {
  // Thomson's problem: known minima, to the digits they are published with.
  const std::array<std::pair<int, double>, 15> known = {{{2, 0.5},
                                                         {3, 1.732050808},
                                                         {4, 3.674234614},
                                                         {5, 6.474691495},
                                                         {6, 9.985281374},
                                                         {7, 14.452977414},
                                                         {8, 19.675287861},
                                                         {9, 25.759986531},
                                                         {10, 32.716949460},
                                                         {11, 40.596450510},
                                                         {12, 49.165253058},
                                                         {13, 58.853230612},
                                                         {14, 69.306363297},
                                                         {15, 80.670244114},
                                                         {22, 185.287536149}}};
  for (const auto& [count, energy] : known) {
    EXPECT_NEAR(repulsion_energy(repelled_directions(count)), energy, 1e-8) << count;
  }
}

TEST(StartPoints, CoverTheSphereAsStated) {
  const std::array<double, 6> radius = {180, 90, 54.74, 42.44, 35.28, 28.44};  // degrees
  const std::array<double, 6> zero = {180, 109.4712, 73.1482, 54.8780, 43.9059, 36.5892};
  for (std::size_t b = 0; b < 6; ++b) {
    const std::vector<Vec3> points = repelled_directions(kStarts[b]);
    ASSERT_EQ(points.size(), static_cast<std::size_t>(kStarts[b]));
    for (const Vec3 point : points) EXPECT_NEAR(length(point), 1, 1e-15);
    const double covered = covering_radius(points), to_zero = first_zero(static_cast<int>(b) + 1);
    EXPECT_NEAR(degrees(covered), radius[b], 0.006) << b;  // the figures have two decimals
    EXPECT_NEAR(degrees(to_zero), zero[b], 6e-5) << b;
    if (b == 0) continue;  // a constant has no zero
    EXPECT_GT(covered / to_zero, 0.745);
    EXPECT_LT(covered / to_zero, 0.825);
  }
}

TEST(StartPoints, AreForOneToTwoHundred) {
  EXPECT_THROW(repelled_directions(0), std::logic_error);
  EXPECT_THROW(repelled_directions(201), std::logic_error);
  EXPECT_EQ(repelled_directions(1).size(), 1u);
  EXPECT_NEAR(repulsion_energy(repelled_directions(200)), 18438.84, 10);  // at or a little above the least known
  EXPECT_EQ(repelled_directions(9), repelled_directions(9));
}

}  // namespace
}  // namespace zonal
