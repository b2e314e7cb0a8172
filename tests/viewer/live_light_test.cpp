#include "apps/viewer/live_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "zonal/light/synthetic.h"
#include "zonal/view/light_turn.h"

namespace zonal {
namespace {

const ViewData& whole() {
  static const ViewData data = [] {
    const Projection panorama = {Layout::kEquirect};
    return view_data(testcard(panorama, image_size(Layout::kEquirect, 64)),
                     {.panorama_px = 64, .cube_px = 16, .chain_px = 32, .irradiance_px = 16, .reference_rows = 16});
  }();
  return data;
}

template <class List>
const auto& named(const List& list, std::string_view name) {
  return *std::ranges::find_if(list, [&](const auto& entry) { return entry.name == name; });
}

ViewState state_with(std::string_view technique, const Turn& turn) {
  ViewState state;
  state.technique = technique_named(technique);
  set_light_turn(state, turn);
  return state;
}

LiveLight turned_light(const ViewState& state) {
  return live_light(whole(), names_used(*state.technique, whole()), state);
}

TEST(SlowLiveLight, KnowsWhatATechniqueLooksAt) {
  const auto used = [&](std::string_view technique) { return names_used(*technique_named(technique), whole()); };
  const auto holds = [](const std::vector<std::string>& list, std::string_view name) {
    return std::ranges::find(list, name) != list.end();
  };
  EXPECT_TRUE(holds(used("split-sum"), "ggx_chain"));
  EXPECT_TRUE(holds(used("split-sum"), "dfg_table"));
  EXPECT_FALSE(holds(used("split-sum"), "phong_chain"));
  EXPECT_TRUE(holds(used("sh-bands"), "irradiance_map")) << "by its exact answer";
  EXPECT_TRUE(holds(used("sh-bands"), "sh"));
  for (const char* id :
       {"split-sum", "phong", "sh-bands", "irradiance-map", "ambient-cube", "blinn-newell", "cube-map"}) {
    EXPECT_TRUE(can_be_live(used(id), whole())) << id;
  }
  EXPECT_FALSE(can_be_live(used("sphere-map"), whole()));
}

TEST(SlowLiveLight, AQuarterTurnOfThePixelsIsAQuarterTurnOfTheCoefficients) {
  const LiveLight live = turned_light(state_with("sh-bands", {.yaw_deg = 90}));
  const std::vector<float>&before = named(whole().uniforms, "sh").values,
        &after = named(live.data.uniforms, "sh").values;
  ASSERT_EQ(before.size(), 108u);
  ASSERT_EQ(after.size(), 108u);
  // The card has edges, which a turned picture of 64 rows holds within a part of a texel: to a thousandth.
  // About Z by 90 degrees: y_1-1 takes what y_11 had, y_11 the negative of what y_1-1 had, y_10 stays.
  double scale = 0;
  for (const float x : before) scale = std::max(scale, std::abs(static_cast<double>(x)));
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(after[3 * 1 + c], before[3 * 3 + c], 2e-3 * scale);
    EXPECT_NEAR(after[3 * 3 + c], -before[3 * 1 + c], 2e-3 * scale);
    EXPECT_NEAR(after[3 * 2 + c], before[3 * 2 + c], 2e-3 * scale);
    EXPECT_NEAR(after[c], before[c], 2e-3 * scale);
  }
  EXPECT_EQ(live.world_from_light, turned(90));
  EXPECT_GT(live.times.all(), 0);
}

// Two ways to the same coefficients: the pixels turned and projected, the coefficients turned.
TEST(SlowLiveLight, PixelsTurnFreelyAsCoefficientsDo) {
  ViewState state = state_with("sh-bands", {.yaw_deg = 40, .pitch_deg = -65, .roll_deg = 110});
  state.set("turn_by", 1);
  const LiveLight live = turned_light(state);
  const std::vector<float>& pixels = named(live.data.uniforms, "sh").values;
  const std::vector<float> coefficients = turned_coefficients(named(whole().uniforms, "sh"), state);
  ASSERT_EQ(pixels.size(), coefficients.size());
  double scale = 0, moved = 0;
  for (const float x : coefficients) scale = std::max(scale, std::abs(static_cast<double>(x)));
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    // As for a quarter turn; the sixth band sees the edges of the card within a texel.
    EXPECT_NEAR(pixels[i], coefficients[i], 5e-3 * scale) << i;
    moved = std::max(moved, std::abs(1.0 * coefficients[i] - named(whole().uniforms, "sh").values[i]));
  }
  EXPECT_GT(moved, 0.05 * scale) << "or nothing was turned";
}

TEST(SlowLiveLight, WithoutATurnTheMapsAreThoseOfTheWholeView) {
  const LiveLight live = turned_light(state_with("irradiance-map", {}));
  const Image<Rgb>&before = named(whole().textures, "environment").levels[0],
        &after = named(live.data.textures, "environment").levels[0];
  EXPECT_EQ(before, after);
  // Both within the tolerance of a convolution (a thousandth of the mean), and of float coordinates; 16 and 32 px.
  const Image<Rgb>&coarse = named(whole().textures, "irradiance_map").levels[0],
        &fine = named(live.data.textures, "irradiance_map").levels[0];
  ASSERT_EQ(fine.width(), 2 * coarse.width());
  double coarse_sum = 0, fine_sum = 0;
  for (const Rgb& value : coarse.values()) coarse_sum += luminance(value);
  for (const Rgb& value : fine.values()) fine_sum += luminance(value);
  EXPECT_NEAR(fine_sum / 4, coarse_sum, 0.005 * coarse_sum);
}

TEST(SlowLiveLight, MakesOneLevelForTheSettings) {
  ViewState state = state_with("phong", {.yaw_deg = 30});
  state.set("shininess", 50);
  const LiveLight live = turned_light(state);
  EXPECT_EQ(named(live.data.textures, "phong_chain").levels.size(), 1u);
  EXPECT_EQ(named(live.data.uniforms, "phong_levels").values, std::vector<float>{1});
  EXPECT_EQ(named(live.data.uniforms, "phong_exponents").values[0], 50);
  EXPECT_EQ(named(live.data.uniforms, "chain_levels").values, std::vector<float>{1});
  // Every uniform is there once.
  for (const ViewUniform& uniform : whole().uniforms) {
    const auto same = [&](const ViewUniform& other) { return other.name == uniform.name; };
    EXPECT_EQ(std::ranges::count_if(live.data.uniforms, same), 1) << uniform.name;
  }
}

}  // namespace
}  // namespace zonal
