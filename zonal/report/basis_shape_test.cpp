#include "zonal/report/basis_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace zonal {
namespace {

constexpr int kSize = 60;
constexpr Rgb kPaper = {0.5f, 0.5f, 0.5f};

Sh<double> basis_function(int l, int m) {
  Sh<double> f(6);
  f(l, m) = 1;
  return f;
}

Image<Rgb> shape(int l, int m, BasisShapeOptions options = {}) {
  options.size_px = kSize;
  options.paper = kPaper;
  return basis_shape(basis_function(l, m), options);
}

bool is_red(Rgb c) { return c != kPaper && c.r > c.b; }
bool is_blue(Rgb c) { return c != kPaper && c.b > c.r; }

TEST(BasisShape, AConstantIsABall) {
  const Image<Rgb> ball = shape(0, 0);
  const double radius = 0.94 * kSize / 2;
  int inside = 0, outside = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double from_middle = std::hypot(x + 0.5 - kSize / 2.0, y + 0.5 - kSize / 2.0);
      if (from_middle < radius - 1) {
        EXPECT_TRUE(is_red(ball(x, y))) << x << ' ' << y;
        ++inside;
      } else if (from_middle > radius + 1) {
        EXPECT_NEAR(ball(x, y).r, kPaper.r, 1e-6);  // nine ninths of the paper
        ++outside;
      }
    }
  }
  EXPECT_GT(inside, 2000);
  EXPECT_GT(outside, 700);
}

TEST(BasisShape, PositiveIsRedAndUpIsUp) {
  const Image<Rgb> up = shape(1, 0);  // z
  int upper_red = 0, lower_blue = 0, wrong = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      if (y < kSize / 2 - 8) is_blue(up(x, y)) ? ++wrong : upper_red += is_red(up(x, y));
      if (y > kSize / 2 + 8) is_red(up(x, y)) ? ++wrong : lower_blue += is_blue(up(x, y));
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(upper_red, 200);
  EXPECT_GT(lower_blue, 200);
}

TEST(BasisShape, TheViewerStandsWhereItIsSaid) {
  // From +X on the horizon, y points to the right and x toward the viewer.
  const BasisShapeOptions from_x = {.azimuth_deg = 0, .elevation_deg = 0};
  const Image<Rgb> y = shape(1, -1, from_x), x = shape(1, 1, from_x);
  EXPECT_TRUE(is_red(y(kSize * 3 / 4, kSize / 2)));
  EXPECT_TRUE(is_blue(y(kSize / 4, kSize / 2)));
  EXPECT_TRUE(is_red(x(kSize / 2, kSize / 2)));
  // From above, z's red lobe hides the blue one.
  EXPECT_TRUE(is_red(shape(1, 0, {.elevation_deg = 89})(kSize / 2, kSize / 2)));
  EXPECT_TRUE(is_blue(shape(1, 0, {.elevation_deg = -89})(kSize / 2, kSize / 2)));
}

TEST(BasisShape, ZonalOutlinesAreSymmetricFromEverywhere) {
  int compared = 0, differing = 0;
  for (int l = 0; l < 6; ++l) {
    const Image<Rgb> picture = shape(l, 0, {.azimuth_deg = 17.0 * l});
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize / 2; ++x) {
        const Rgb left = picture(x, y), right = picture(kSize - 1 - x, y);
        // The light comes from the left, the colours of the sign do not.
        differing += is_red(left) != is_red(right) || is_blue(left) != is_blue(right);
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 6 * kSize * kSize / 2);
  // The mesh begins somewhere: a pixel here and there at an edge, where its facets fall otherwise.
  EXPECT_LE(differing, compared / 200);
}

TEST(BasisShape, MinusTheFunctionIsTheSameShapeInTheOtherColour) {
  const Sh<double> f = basis_function(3, 2);
  const Image<Rgb> plus = basis_shape(f, {.size_px = kSize, .paper = kPaper});
  const Image<Rgb> minus = basis_shape(-1.0 * f, {.size_px = kSize, .paper = kPaper});
  int compared = 0;
  for (std::size_t i = 0; i < plus.size(); ++i) {
    const Rgb a = plus.values()[i], b = minus.values()[i];
    EXPECT_EQ(a == kPaper, b == kPaper);
    // A lobe's pixel is clearly one or the other; the rest are edges.
    if (a.r < 3 * a.b && a.b < 3 * a.r) continue;
    EXPECT_EQ(is_red(a), is_blue(b));
    ++compared;
  }
  EXPECT_GT(compared, 500);
}

TEST(BasisShape, OneScaleComparesFunctions) {
  // At a common reach, the constant is sqrt(1/3) as large as the linear function.
  const double reach = std::sqrt(3 / (4 * kPi));
  const Image<Rgb> ball = shape(0, 0, {.reach = reach});
  int covered = 0;
  for (int x = 0; x < kSize; ++x) covered += ball(x, kSize / 2) != kPaper;
  EXPECT_NEAR(covered, 0.94 * kSize / std::sqrt(3.0), 2);
}

TEST(BasisShape, NothingIsNothing) {
  const Image<Rgb> empty = basis_shape(Sh<double>(2), {.size_px = 8});
  EXPECT_EQ(empty, Image<Rgb>(8, 8));
  Sh<double> broken(2);
  broken[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(basis_shape(broken), std::logic_error);
  EXPECT_THROW(basis_shape(Sh<double>(2), {.size_px = 0}), std::logic_error);
}

}  // namespace
}  // namespace zonal
