#include "zonal/image/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "zonal/base/error.h"

namespace zonal {
namespace {

TEST(Compare, EqualPictures) {
  const Image<Rgb> a(3, 2, Rgb{1, 2, 3});
  const Comparison c = compare(a, a);
  EXPECT_EQ(c.texels, 6);
  EXPECT_EQ(c.rmse, 0);
  EXPECT_EQ(c.relative_rmse, 0);
  EXPECT_EQ(c.max_error, 0);
  EXPECT_TRUE(std::isinf(c.psnr_db));
}

TEST(Compare, HandComputed) {
  Image<Rgb> a(2, 1, Rgb{1, 1, 1});
  const Image<Rgb> b(2, 1, Rgb{1, 1, 1});
  a(1, 0) = {1, 1, 4};  // one of six channels is off by 3
  const Comparison c = compare(a, b);
  EXPECT_DOUBLE_EQ(c.rmse, std::sqrt(9.0 / 6));
  EXPECT_DOUBLE_EQ(c.relative_rmse, std::sqrt(9.0 / 6));
  EXPECT_DOUBLE_EQ(c.mean_error, 0.5);
  EXPECT_DOUBLE_EQ(c.max_error, 3);
  EXPECT_DOUBLE_EQ(c.max_relative_error, 3);
  EXPECT_DOUBLE_EQ(c.psnr_db, 20 * std::log10(1 / std::sqrt(9.0 / 6)));
  EXPECT_EQ(c.worst_x, 1);
  EXPECT_EQ(c.worst_y, 0);
}

TEST(Compare, WeightsCountTexelsAsManyTimes) {
  Image<Rgb> a(2, 1), b(2, 1), a3(4, 1), b3(4, 1);
  a(0, 0) = {1, 0, 0};
  b(1, 0) = {0, 2, 0};
  for (int x = 0; x < 3; ++x) a3(x, 0) = a(0, 0);
  b3(3, 0) = b(1, 0);
  const Comparison weighted = compare(a, b, std::vector<double>{3, 1});
  const Comparison repeated = compare(a3, b3);
  EXPECT_DOUBLE_EQ(weighted.rmse, repeated.rmse);
  EXPECT_DOUBLE_EQ(weighted.mean_error, repeated.mean_error);
  EXPECT_DOUBLE_EQ(weighted.relative_rmse, repeated.relative_rmse);
  EXPECT_EQ(compare(a, b, std::vector<double>{0, 1}).texels, 1);
}

TEST(Compare, CountsWhatIsNotFinite) {
  Image<Rgb> a(2, 2, Rgb{1, 1, 1});
  const Image<Rgb> b = a;
  a(0, 1).g = std::numeric_limits<float>::quiet_NaN();
  a(1, 1).b = std::numeric_limits<float>::infinity();
  const Comparison c = compare(a, b);
  EXPECT_EQ(c.texels, 2);
  EXPECT_EQ(c.not_finite, 2);
  EXPECT_EQ(c.rmse, 0);
}

TEST(Compare, AgainstBlack) {
  const Image<Rgb> light(1, 1, Rgb{1, 1, 1}), black(1, 1);
  EXPECT_TRUE(std::isinf(compare(light, black).relative_rmse));
  EXPECT_EQ(compare(black, black).relative_rmse, 0);
}

TEST(Compare, RefusesDifferentSizes) {
  try {
    compare(Image<Rgb>(2, 1), Image<Rgb>(1, 2));
    FAIL() << "accepted";
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::kInput);
    EXPECT_NE(std::string(e.what()).find("2x1"), std::string::npos);
  }
}

TEST(Difference, LargestChannel) {
  Image<Rgb> a(2, 1), b(2, 1);
  a(0, 0) = {1, -5, 2};
  b(1, 0).r = std::numeric_limits<float>::quiet_NaN();
  const Image<float> d = difference(a, b);
  EXPECT_FLOAT_EQ(d(0, 0), 5);
  EXPECT_TRUE(std::isnan(d(1, 0)));
}

}  // namespace
}  // namespace zonal
