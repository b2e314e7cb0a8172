#include "zonal/sh/rotate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "zonal/math/sphere_rule.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/irradiance.h"
#include "zonal/sh/rotate_kernel.h"

namespace zonal {
namespace {

const Rotation kTilt = Rotation::about(normalize({0.3, -0.8, 0.5}), 2.1);
const Rotation kOther = Rotation::about(normalize({-1, 0.2, 0.1}), -0.7);

std::vector<Rotation> rotations() {
  return {Rotation::identity(),
          kTilt,
          kOther,
          Rotation::about_z(0.9),
          Rotation::about_x(kPi),
          Rotation::about_y(kPi / 2),
          Rotation::about_y(1e-9),
          Rotation::about_x(kPi - 1e-9),
          Rotation::about_z(kPi / 2)};
}

template <class T, int N>
Sh<T, N> wavy(int bands) {
  Sh<T, N> sh(bands);
  for (std::size_t i = 0; i < sh.size(); ++i) sh[i] = static_cast<T>(std::sin(1.7 * static_cast<double>(i) + 0.4));
  return sh;
}

template <class A, class B>
double worst_difference(const A& a, const B& b) {
  EXPECT_EQ(a.size(), b.size());
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, static_cast<double>(std::abs(a[i] - b[i])));
  return worst;
}

/// rotate(f, R) at R d against f at d for N static bands and the same bands at run time.
template <int N, class T>
int compare_with_evaluation(const Rotation& r) {
  const Sh<T, N> sh = wavy<T, N>(N), turned = rotate(sh, r);
  const Sh<T> any = rotate(with_bands(sh, N), r);
  EXPECT_LT(worst_difference(turned, any), 16 * N * std::numeric_limits<T>::epsilon());  // sums of 2N terms
  int compared = 0;
  for (const Vec3 d : spiral_directions(20)) {
    // N^2 terms of size 1 with a rounding or two each.
    EXPECT_NEAR(evaluate(turned, r * d), evaluate(sh, d), 2 * N * N * std::numeric_limits<T>::epsilon());
    ++compared;
  }
  return compared;
}

TEST(Rotate, CarriesTheValueWithTheDirection) {
  int compared = 0;
  for (const Rotation& r : rotations()) {
    [&]<int... n>(std::integer_sequence<int, n...>) {
      ((compared += compare_with_evaluation<n + 1, double>(r) + compare_with_evaluation<n + 1, float>(r)), ...);
    }
    (std::make_integer_sequence<int, 6>());
  }
  EXPECT_EQ(compared, 9 * 6 * 2 * 20);
}

TEST(Rotate, AgreesWithEvaluationForFortyBands) {
  const Sh<double> sh = wavy<double, kDynamic>(40);
  int compared = 0;
  for (const Rotation& r : rotations()) {
    const Sh<double> turned = rotate(sh, r);
    for (const Vec3 d : spiral_directions(10)) {
      EXPECT_NEAR(evaluate(turned, r * d), evaluate(sh, d), 1e-11);  // 1600 terms up to 2.5, turned by rounded angles
      ++compared;
    }
  }
  EXPECT_EQ(compared, 90);
}

TEST(Rotate, MirrorsToo) {
  const Rotation mirror = kTilt * Rotation{{Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}}};
  const Sh<double, 6> sh = wavy<double, 6>(6), turned = rotate(sh, mirror);
  const Sh<double, 3> few = with_bands<3>(sh);
  for (const Vec3 d : spiral_directions(20)) {
    EXPECT_NEAR(evaluate(turned, mirror * d), evaluate(sh, d), 1e-14);
    EXPECT_NEAR(evaluate(rotate(few, mirror), mirror * d), evaluate(few, d), 1e-14);
  }
}

TEST(ShRotation, IsOrthogonalAndAHomomorphismForSixtyFourBands) {
  constexpr int kBands = 64;
  const ShRotation a(kTilt, kBands), b(kOther, kBands), ab(kTilt * kOther, kBands);
  double skew = 0, apart = 0;
  int compared = 0;
  for (int l = 0; l < kBands; ++l) {
    for (int m = -l; m <= l; ++m) {
      for (int n = -l; n <= l; ++n, ++compared) {
        double gram = 0, chained = 0;
        for (int k = -l; k <= l; ++k) {
          gram += a(l, m, k) * a(l, n, k);
          chained += a(l, m, k) * b(l, k, n);
        }
        skew = std::max(skew, std::abs(gram - (m == n)));
        apart = std::max(apart, std::abs(chained - ab(l, m, n)));
      }
    }
  }
  EXPECT_EQ(compared, rotation_entries(kBands));
  // Sums of 127 rounded terms, and a few roundings a band.
  EXPECT_LT(skew, 1e-13);
  EXPECT_LT(apart, 1e-13);
}

TEST(ShRotation, TurnsBack) {
  const Sh<double> sh = wavy<double, kDynamic>(20);
  const ShRotation turn(kTilt, 24);
  EXPECT_EQ(turn.bands(), 24);
  EXPECT_LT(worst_difference(turn.apply_inverse(turn.apply(sh)), sh), 1e-13);  // sums of 39 terms, twice
  EXPECT_LT(worst_difference(turn.apply_inverse(sh), rotate(sh, transpose(kTilt))), 1e-13);
}

TEST(ShRotation, CommutesWithConvolution) {
  const Sh<double> sh = wavy<double, kDynamic>(30);
  EXPECT_LT(worst_difference(rotate(irradiance(sh), kTilt), irradiance(rotate(sh, kTilt))), 1e-13);
}

TEST(Rotate, TurnsColorsByChannel) {
  Sh<Rgb, 5> sh;
  Sh<float, 5> green;
  for (std::size_t i = 0; i < sh.size(); ++i) {
    green[i] = std::cos(static_cast<float>(i));
    sh[i] = {1, green[i], -2 * green[i]};
  }
  const Sh<Rgb, 5> turned = rotate(sh, kTilt);
  const Sh<float, 5> expected = rotate(green, kTilt);
  for (std::size_t i = 0; i < sh.size(); ++i) {
    EXPECT_EQ(turned[i].g, expected[i]);
    EXPECT_FLOAT_EQ(turned[i].b, -2 * expected[i]);
  }
}

TEST(Rotate, AboutZTakesTheShortWay) {
  const Rotation r = Rotation::about_z(1.1);
  ASSERT_TRUE(is_about_z(r));
  EXPECT_FALSE(is_about_z(kTilt));
  EXPECT_FALSE(is_about_z(Rotation{{Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}}}));
  const Sh<double> sh = wavy<double, kDynamic>(30);
  EXPECT_LT(worst_difference(rotate(sh, r), ShRotation(r, 30).apply(sh)), 1e-13);  // cos 29 a by 29 products
}

/// Next to the poles of every decomposition, and with a mirror in front of them.
std::vector<Rotation> delicate_rotations() {
  std::vector<Rotation> all = rotations();
  for (const double angle : {1e-3, 1e-5, 1e-7, 1e-9, 1e-12, 1e-15, 1e-16, 1e-30, 1e-160}) {
    for (const Rotation& tip : {Rotation::about_x(angle), Rotation::about_y(-angle), Rotation::about_x(kPi - angle)}) {
      all.push_back(tip);
      all.push_back(Rotation::about_z(0.3) * tip * Rotation::about_z(2));
    }
  }
  const std::size_t proper = all.size();
  for (std::size_t i = 0; i < proper; ++i) all.push_back(all[i] * Rotation{{Vec3{1, 0, 0}, Vec3{0, -1, 0}, {0, 0, 1}}});
  return all;
}

/// The kernel against the matrices of the recurrence.
template <int N, class T, class Kernel>
double worst_of_kernel(Kernel kernel, int* compared) {
  double worst = 0;
  for (const Rotation& r : delicate_rotations()) {
    const ShRotation<N> exact(r);
    std::array<Sh<T, N>, 3> from, to;
    for (std::size_t f = 0; f < from.size(); ++f) {
      for (std::size_t i = 0; i < from[f].size(); ++i)
        from[f][i] = static_cast<T>(std::sin(1.7 * static_cast<double>(i + 40 * f) + 0.4));
    }
    static_assert(sizeof from == 3 * N * N * sizeof(T), "functions one behind the other");
    kernel(&r.rows[0].x, &from[0][0], &to[0][0], 3);
    for (std::size_t f = 0; f < from.size(); ++f, ++*compared) {
      worst = std::max(worst, worst_difference(cast<double>(to[f]), exact.apply(cast<double>(from[f]))));
    }
  }
  return worst;
}

TEST(Rotate, TurnsAgreeWithTheRecurrenceOnEveryInstructionSet) {
  int compared = 0;
  // An angle that is rounded once moves order m by m roundings: three turns of order 5 and two swaps of three terms, in
  // a band of norm 2.
  constexpr double kRoundings = 2 * (3 * 5 + 2 * 3);
  for (const Isa isa : available_isas()) {
    [&]<int... n>(std::integer_sequence<int, n...>) {
      (
          [&] {
            const auto& kernels = rotate_kernels(isa);
            EXPECT_LT((worst_of_kernel<n + 4, float>(kernels.in_float[n], &compared)), kRoundings * 6e-8);
            EXPECT_LT((worst_of_kernel<n + 4, double>(kernels.in_double[n], &compared)), kRoundings * 1.1e-16);
          }(),
          ...);
    }
    (std::make_integer_sequence<int, 3>());
  }
  EXPECT_EQ(compared, static_cast<int>(available_isas().size() * 3 * 2 * 3 * delicate_rotations().size()));
  EXPECT_EQ(delicate_rotations().size(), 2 * (9 + 9 * 3 * 2));
}

TEST(Rotate, RefusesWhatIsNoRotation) {
  const Sh<double, 4> sh;
  Rotation bad;
  bad.rows[1].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(rotate(sh, bad), std::logic_error);
  EXPECT_THROW(ShRotation(bad, 4), std::logic_error);
  EXPECT_THROW(rotate(sh, Rotation{{Vec3{2, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}), std::logic_error);
  EXPECT_THROW(ShRotation(kTilt, 0), std::logic_error);
  EXPECT_THROW(ShRotation(kTilt, 3).apply(sh), std::logic_error);
}

}  // namespace
}  // namespace zonal
