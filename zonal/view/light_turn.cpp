#include "zonal/view/light_turn.h"

#include <algorithm>
#include <cmath>

#include "zonal/base/check.h"
#include "zonal/sh/rotate.h"

namespace zonal {
namespace {

struct Angle {
  std::string_view control;
  double Turn::*value;
};
constexpr Angle kAngles[] = {
    {"light_yaw_deg", &Turn::yaw_deg}, {"light_pitch_deg", &Turn::pitch_deg}, {"light_roll_deg", &Turn::roll_deg}};
constexpr int kBands = 6;  // of the uniform sh

}  // namespace

bool turns_light(std::string_view control) {
  return std::ranges::find(kAngles, control, &Angle::control) != std::end(kAngles);
}

Turn light_turn(const ViewState& state) {
  Turn turn;
  for (const Angle& angle : kAngles) turn.*angle.value = state.value(angle.control);
  return turn;
}

void set_light_turn(ViewState& state, const Turn& turn) {
  for (const Angle& angle : kAngles) state.set(angle.control, turn.*angle.value);
}

Rotation world_from_light(const ViewState& state) { return turned(light_turn(state)); }

std::array<float, 9> light_from_world(const ViewState& state) {
  std::array<float, 9> columns;  // of the inverse: the rows
  auto to = columns.begin();
  for (const Vec3& row : world_from_light(state).rows) {
    for (const double x : {row.x, row.y, row.z}) *to++ = static_cast<float>(x);
  }
  return columns;
}

std::vector<float> turned_coefficients(const ViewUniform& sh, const ViewState& state) {
  if (state.value("turn_by") == 0) return sh.values;
  constexpr std::size_t kCount = coefficient_count(kBands);
  check(sh.values.size() == 3 * kCount, "the uniform sh has six bands");
  Sh<RgbD, kBands> radiance;
  for (std::size_t i = 0; i < kCount; ++i) {
    radiance[i] = {sh.values[3 * i], sh.values[3 * i + 1], sh.values[3 * i + 2]};
  }
  const Sh<RgbD, kBands> in_world = rotate(radiance, world_from_light(state));
  std::vector<float> turned;
  for (const RgbD& c : in_world.values()) {
    for (const double x : {c.r, c.g, c.b}) turned.push_back(static_cast<float>(x));
  }
  return turned;
}

std::vector<double> quarter_turn_blocks() {
  std::vector<double> blocks(static_cast<std::size_t>(rotation_entries(kBands)));
  rotation_blocks(turned(0, 0, 90), kBands, blocks);
  return blocks;
}

}  // namespace zonal
