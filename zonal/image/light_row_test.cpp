#include "zonal/image/light_row.h"

#include <gtest/gtest.h>

#include <cmath>

namespace zonal {
namespace {

/// A photograph in grey codes of 255.
Exposure grey_exposure(int width, int height, const std::vector<int>& codes, const Placement& placement) {
  Image<Rgb> picture(width, height);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const float value = static_cast<float>(codes[i]) / 255;
    picture.values()[i] = {value, value, value};
  }
  return {"", 1, CodedPicture(picture), placement};
}

CodeTable table(const Response& response, TrustedCodes trusted = {}) {
  return {response, CodeWeight::kHat, {trusted, trusted, trusted}, kCodes};
}

std::vector<LightTexel> row_of(const Exposure& exposure, const CodeTable& codes, int y) {
  std::vector<LightTexel> row(static_cast<std::size_t>(exposure.picture.width()));
  read_light(exposure, codes, y, row);
  return row;
}

TEST(LightRow, MixesLightAndNotCodes) {
  const CodeTable srgb = table(Response::srgb());
  const Exposure moved = grey_exposure(3, 1, {50, 200, 100}, {0.25, 0, 0});
  const CodeValue mixed = row_of(moved, srgb, 0)[0][1];
  const double a = Response::srgb()(1, 50 / 255.0), b = Response::srgb()(1, 200 / 255.0);
  EXPECT_NEAR(mixed.exposure, 0.75 * a + 0.25 * b, 1e-6);
  EXPECT_NEAR(mixed.log_exposure, std::log(0.75 * a + 0.25 * b), 1e-6);
  EXPECT_EQ(mixed.state, CodeState::kTrusted);
  EXPECT_FLOAT_EQ(mixed.weight, static_cast<float>(code_weight(CodeWeight::kHat, {}, 50 / 255.0)));
}

TEST(LightRow, InventsNoLight) {
  std::vector<int> codes;
  for (int i = 0; i < 400; ++i) codes.push_back(20 + i * 97 % 200);
  const Exposure turned = grey_exposure(20, 20, codes, {1.3, -0.6, 17});
  const CodeTable linear = table(Response::linear());
  const Placing placing(turned.placement, turned.picture.center());
  int inside = 0, outside = 0;
  for (int y = 0; y < 20; ++y) {
    const std::vector<LightTexel> row = row_of(turned, linear, y);
    for (int x = 0; x < 20; ++x) {
      const PicturePoint q = placing({x + 0.5, y + 0.5});
      const int u = static_cast<int>(std::floor(q.x - 0.5)), v = static_cast<int>(std::floor(q.y - 0.5));
      if (u < 0 || v < 0 || u > 18 || v > 18) {
        EXPECT_EQ(row[x][0].state, CodeState::kMissing);
        EXPECT_EQ(row[x][0].weight, 0);
        ++outside;
        continue;
      }
      const int around[] = {codes[20 * v + u], codes[20 * v + u + 1], codes[20 * v + u + 20], codes[20 * v + u + 21]};
      // Rounding of floats.
      EXPECT_GE(row[x][0].exposure, static_cast<float>(*std::min_element(around, around + 4)) / 255 - 1e-6f);
      EXPECT_LE(row[x][0].exposure, static_cast<float>(*std::max_element(around, around + 4)) / 255 + 1e-6f);
      ++inside;
    }
  }
  EXPECT_GT(inside, 250);
  EXPECT_GT(outside, 40);
  EXPECT_EQ(inside + outside, 400);
}

TEST(LightRow, IsNoBetterThanTheWorstNeighbour) {
  const CodeTable linear = table(Response::linear(), {10, 250});
  struct Case {
    int left, right;
    CodeState state;
  };
  int checked = 0;
  for (const auto& [left, right, state] :
       {Case{100, 252, CodeState::kSaturated}, Case{252, 100, CodeState::kSaturated}, Case{100, 8, CodeState::kBlack},
        Case{8, 252, CodeState::kSaturated}, Case{100, 110, CodeState::kTrusted}}) {
    const CodeValue value = row_of(grey_exposure(2, 1, {left, right}, {0.5, 0, 0}), linear, 0)[0][2];
    EXPECT_EQ(value.state, state) << left << ' ' << right;
    EXPECT_EQ(value.weight > 0, state == CodeState::kTrusted);
    EXPECT_NEAR(value.exposure, (left + right) / 2.0 / 255, 1e-6);
    ++checked;
  }
  EXPECT_EQ(checked, 5);
  Exposure missing = grey_exposure(2, 1, {100, 110}, {0.5, 0, 0});
  missing.missing = Image<std::uint8_t>(2, 1);
  missing.missing(1, 0) = 1;
  EXPECT_EQ(row_of(missing, linear, 0)[0][0].state, CodeState::kMissing);
}

TEST(LightRow, WholeTexelsKeepTheirCodes) {
  const CodeTable linear = table(Response::linear());
  const Exposure moved = grey_exposure(3, 2, {10, 20, 30, 40, 50, 60}, {1, 1, 0});
  const std::vector<LightTexel> row = row_of(moved, linear, 0);
  EXPECT_FLOAT_EQ(row[0][0].exposure, 50.0f / 255);
  EXPECT_FLOAT_EQ(row[1][0].exposure, 60.0f / 255);
  EXPECT_EQ(row[2][0].state, CodeState::kMissing);
}

}  // namespace
}  // namespace zonal
