#pragma once

#include <span>
#include <string_view>

namespace zonal {

enum class ControlKind { kSlider, kChoice, kToggle };

/// Something a viewer lets people turn. Every control is a uniform of its own name in the shaders (a float for sliders,
/// an int for choices and toggles), a panel in the window and an input in the page: one table for all three.
struct Control {
  std::string_view name;   ///< of the uniform, of the field in a page's address
  std::string_view label;  ///< for people, with its unit
  ControlKind kind = ControlKind::kSlider;
  double least = 0, greatest = 1, initial = 0;
  double step = 0;  ///< of a slider; 0: continuous
  std::span<const std::string_view> choices = {};
};

/// Of every technique: exposure, tone curve, where the light is turned to, and what is compared with what.
std::span<const Control> common_controls();

/// All controls there are, the common ones first.
std::span<const Control> all_controls();

/// std::logic_error when there is none of this name.
const Control& control_named(std::string_view name);

}  // namespace zonal
