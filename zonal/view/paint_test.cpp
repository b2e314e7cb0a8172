#include "zonal/view/paint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "zonal/io/shader_workshop_test.h"
#include "zonal/view/page_parts.h"

namespace zonal {
namespace {

constexpr int kPx = 32;
constexpr Brush kBrush = {.radius = 0.2, .light = {4, 2, 1}};

Image<Rgb> grey() { return Image<Rgb>(kPx, kPx, Rgb(0.5f, 0.5f, 0.5f)); }

TEST(Paint, ADabIsASoftDisc) {
  Stroke stroke(grey(), kBrush);
  stroke.move_to(0.5, 0.5);
  int changed = 0;
  for (int y = 0; y < kPx; ++y) {
    for (int x = 0; x < kPx; ++x) {
      const double away = std::hypot((x + 0.5) / kPx - 0.5, (y + 0.5) / kPx - 0.5);
      const double cover = std::pow(std::max(0.0, 1 - std::pow(away / 0.2, 2)), 2);
      EXPECT_NEAR(stroke.picture()(x, y).r, 0.5 + cover * 3.5, 1e-5);
      EXPECT_NEAR(stroke.picture()(x, y).b, 0.5 + cover * 0.5, 1e-5);
      changed += cover > 0;
    }
  }
  EXPECT_GT(changed, 100);
}

TEST(Paint, SlowAndFastHandsLeaveTheSame) {
  Stroke fast(grey(), kBrush), slow(grey(), kBrush);
  fast.move_to(0.1, 0.3);
  fast.move_to(0.9, 0.7);
  for (int i = 0; i <= 64; ++i) slow.move_to(0.1 + 0.8 * i / 64, 0.3 + 0.4 * i / 64);
  for (std::size_t i = 0; i < fast.picture().size(); ++i) {
    EXPECT_NEAR(fast.picture().values()[i].r, slow.picture().values()[i].r, 1e-5);
  }
  EXPECT_NEAR(fast.picture()(kPx / 2, kPx / 2).r, 4, 0.1) << "in its middle it is the brush's light";
}

TEST(Paint, BlackErases) {
  Stroke stroke(grey(), {.radius = 3, .light = {}});
  stroke.move_to(0.5, 0.5);
  for (const Rgb& value : stroke.picture().values()) EXPECT_LT(value.r, 0.1f);
  EXPECT_THROW(Stroke(grey(), {.radius = 0}), std::logic_error);
  EXPECT_THROW(Stroke(Image<Rgb>(3, 2), kBrush), std::logic_error);
}

// The page's own brush, run by itself.
TEST(SlowPaint, ThePagePaintsTheSame) {
  if (!has_program("node")) GTEST_SKIP() << "no node";
  constexpr std::array<std::array<double, 2>, 4> kPath = {{{0.2, 0.25}, {0.62, 0.5}, {0.62, 0.5}, {1.1, -0.05}}};
  Stroke stroke(grey(), kBrush);
  nlohmann::json path;
  for (const auto& [u, v] : kPath) {
    stroke.move_to(u, v);
    path.push_back({u, v});
  }
  const Workshop workshop("zonal_view_paint");
  const auto script = std::ranges::find(page_parts(), "paint", &PagePart::stem);
  ASSERT_NE(script, page_parts().end());
  std::ofstream(workshop / "paint.js") << script->text << "const stroke = new Stroke(new Float32Array(" << 3 * kPx * kPx
                                       << ").fill(0.5), {radius: 0.2, light: [4, 2, 1]});\nfor (const [u, v] of "
                                       << path
                                       << ") stroke.moveTo(u, v);\nconsole.log(JSON.stringify([...stroke.picture]));\n";
  ASSERT_EQ(std::system(("node " + (workshop / "paint.js") + " > " + (workshop / "log") + " 2>&1").c_str()), 0)
      << content(workshop / "log");
  const std::vector<float> theirs = nlohmann::json::parse(content(workshop / "log"));
  ASSERT_EQ(theirs.size(), 3u * kPx * kPx);
  int painted = 0;
  for (std::size_t i = 0; i < stroke.picture().size(); ++i) {
    const Rgb ours = stroke.picture().values()[i];
    EXPECT_NEAR(theirs[3 * i], ours.r, 1e-6);
    EXPECT_NEAR(theirs[3 * i + 2], ours.b, 1e-6);
    painted += ours.r > 0.51f;
  }
  EXPECT_GT(painted, 200);
}

}  // namespace
}  // namespace zonal
