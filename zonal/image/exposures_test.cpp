#include "zonal/image/exposures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "zonal/base/error.h"
#include "zonal/image/synthetic_bracket_test.h"

namespace zonal {
namespace {

/// A picture whose values count up from `first` in steps of `step`.
Image<Rgb> ramp(int width, int height, float step) {
  Image<Rgb> picture(width, height);
  float i = 0;
  for (Rgb& p : picture.values()) {
    p = {i * step, (i + 1) * step, (i + 2) * step};
    ++i;
  }
  return picture;
}

Exposure exposure_of(const Image<Rgb>& picture, double seconds, const char* name = "a") {
  return {name, seconds, CodedPicture(picture)};
}

template <class F>
Error thrown_by(const F& f) {
  try {
    f();
  } catch (const Error& e) {
    return e;
  }
  return {ErrorKind::kOutput, "nothing was thrown"};
}

TEST(CodedPicture, KeepsEveryValueInTheFewestBytes) {
  struct Case {
    float largest;
    int levels;
  };
  int compared = 0;
  for (const auto& [largest, levels] : {Case{255, 256}, Case{65535, 65536}, Case{1000, 0}}) {
    Image<Rgb> picture(16, 16);
    int i = 0;
    for (Rgb& p : picture.values()) {
      p = {static_cast<float>(i % 256) / largest, static_cast<float>(i * 37 % 256) / largest, 1};
      ++i;
    }
    const CodedPicture coded(picture);
    EXPECT_EQ(coded.levels(), levels);
    std::vector<Rgb> row(16);
    for (int y = 0; y < 16; ++y) {
      coded.row(y, row);
      for (int x = 0; x < 16; ++x, ++compared) EXPECT_EQ(row[x], picture(x, y));
    }
  }
  EXPECT_EQ(compared, 3 * 256);
}

TEST(CodedPicture, FloatsBelowZeroAndAboveOneStay) {
  Image<Rgb> picture(1, 1);
  picture(0, 0) = {-1, 7, 0.5f};
  std::vector<Rgb> row(1);
  CodedPicture(picture).row(0, row);
  EXPECT_EQ(row[0], picture(0, 0));
}

TEST(CodedPicture, RefusesWhatIsNotFinite) {
  Image<Rgb> picture(3, 1);
  picture(1, 0).g = std::numeric_limits<float>::quiet_NaN();
  picture(2, 0).b = std::numeric_limits<float>::infinity();
  const Error e = thrown_by([&] { CodedPicture{picture}; });
  EXPECT_EQ(e.kind(), ErrorKind::kInput);
  EXPECT_NE(std::string(e.what()).find("2 pixels"), std::string::npos) << e.what();
}

TEST(Arrange, SortsByExposure) {
  const Image<Rgb> picture(2, 2);
  Exposures bracket = {exposure_of(picture, 1), exposure_of(picture, 0.01), exposure_of(picture, 0.1)};
  arrange(bracket);
  EXPECT_EQ(bracket[0].seconds, 0.01);
  EXPECT_EQ(bracket[1].seconds, 0.1);
  EXPECT_EQ(bracket[2].seconds, 1);
}

TEST(Arrange, RefusesWhatIsNoBracket) {
  const Image<Rgb> picture(2, 2), wider(3, 2);
  struct Case {
    Exposures bracket;
    const char* says;
  };
  const double infinity = std::numeric_limits<double>::infinity();
  const Case cases[] = {
      {{}, "one exposure"},
      {{exposure_of(picture, 1)}, "one exposure"},
      {{exposure_of(picture, 1), exposure_of(wider, 2, "b")}, "b is 3x2"},
      {{exposure_of(picture, 1), exposure_of(picture, 1.005, "b")}, "same exposure"},
      {{exposure_of(picture, 1), exposure_of(picture, 0)}, "impossible"},
      {{exposure_of(picture, -1), exposure_of(picture, 1)}, "impossible"},
      {{exposure_of(picture, 1), exposure_of(picture, infinity)}, "impossible"},
      {{exposure_of(picture, 1), exposure_of(picture, std::nan(""))}, "impossible"},
  };
  int refused = 0;
  for (Case c : cases) {
    const Error e = thrown_by([&] { arrange(c.bracket); });
    EXPECT_EQ(e.kind(), ErrorKind::kInput);
    EXPECT_NE(std::string(e.what()).find(c.says), std::string::npos) << e.what();
    EXPECT_FALSE(e.hint().empty());
    ++refused;
  }
  EXPECT_EQ(refused, 8);
  Exposures near = {exposure_of(picture, 1), exposure_of(picture, 1.02)};
  EXPECT_NO_THROW(arrange(near));
}

TEST(ReadRow, ShiftsAndHasNoDataOutside) {
  const Image<Rgb> picture = ramp(5, 4, 1.0f / 255);
  int inside = 0, outside = 0;
  for (const Shift shift :
       {Shift{0, 0}, Shift{2, 1}, Shift{-2, -1}, Shift{0, 3}, Shift{9, 0}, Shift{-9, 0}, Shift{0, 9}}) {
    Exposure exposure = exposure_of(picture, 1);
    exposure.placement = {static_cast<double>(shift.dx), static_cast<double>(shift.dy)};
    std::vector<Rgb> row(5);
    for (int y = 0; y < 4; ++y) {
      read_row(exposure, y, row);
      for (int x = 0; x < 5; ++x) {
        const int u = x + shift.dx, v = y + shift.dy;
        if (u < 0 || u >= 5 || v < 0 || v >= 4) {
          EXPECT_TRUE(std::isnan(row[x].r) && std::isnan(row[x].g) && std::isnan(row[x].b));
          ++outside;
        } else {
          EXPECT_EQ(row[x], picture(u, v));
          ++inside;
        }
      }
    }
  }
  EXPECT_EQ(inside, 20 + 9 + 9 + 5);
  EXPECT_EQ(inside + outside, 7 * 20);
}

TEST(ReadRow, TakesTheTexelUnderAPlacedCentre) {
  const Image<Rgb> picture = ramp(5, 4, 1.0f / 255);
  Exposure exposure = exposure_of(picture, 1);
  exposure.placement = {0.4, 0.6, 0};
  std::vector<Rgb> row(5);
  read_row(exposure, 1, row);
  for (int x = 0; x < 5; ++x) EXPECT_EQ(row[x], picture(x, 2));
  exposure.placement.rotation_deg = 180;
  read_row(exposure, 1, row);
  for (int x = 1; x < 5; ++x) EXPECT_EQ(row[x], picture(4 - x, 3)) << x;  // (4.9 - x, 3.1)
  exposure.missing = Image<std::uint8_t>(5, 4);
  exposure.missing(1, 3) = 1;
  read_row(exposure, 1, row);
  EXPECT_TRUE(std::isnan(row[3].g));
  exposure.placement = {4.6, 0, 0};
  read_row(exposure, 1, row);
  for (int x = 0; x < 5; ++x) EXPECT_TRUE(std::isnan(row[x].g)) << x;
}

TEST(MarkMissing, FollowsTheShift) {
  Image<Rgb> picture(4, 1);
  picture(1, 0) = {0, 4.0f / 255, 250.0f / 255};
  Exposure exposure = exposure_of(picture, 1);
  EXPECT_EQ(mark_missing(exposure, {0, 0, 1}, 6.0f / 255), 1);
  std::vector<Rgb> row(4);
  read_row(exposure, 0, row);
  EXPECT_TRUE(std::isnan(row[1].b));
  EXPECT_EQ(row[2].b, 0);
  exposure.placement = {1, 0};
  read_row(exposure, 0, row);
  EXPECT_TRUE(std::isnan(row[0].b));
  EXPECT_EQ(row[1].b, 0);
  EXPECT_EQ(mark_missing(exposure, {0, 0, 1}, 4.0f / 255), 0);
}

}  // namespace
}  // namespace zonal
