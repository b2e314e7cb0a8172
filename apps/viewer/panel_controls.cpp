#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "apps/viewer/panels.h"
#include "apps/viewer/plain_text.h"
#include "zonal/view/light_turn.h"

namespace zonal {
namespace {

/// The turn of the light with one of its angles as given. It is more than a number: the light turns for real.
Turn turn_with(ViewState state, std::string_view control, double angle_deg) {
  state.set(control, angle_deg);
  return light_turn(state);
}

void draw_slider(Viewer& viewer, PanelState& panel, const Control& control, const char* label) {
  auto value = static_cast<float>(viewer.state().value(control.name));
  const bool whole = control.step >= 1 && control.step == std::floor(control.step);
  const bool changed =
      ImGui::SliderFloat(label, &value, static_cast<float>(control.least), static_cast<float>(control.greatest),
                         whole ? "%.0f" : "%.2f", ImGuiSliderFlags_AlwaysClamp);
  const bool released = ImGui::IsItemDeactivated();
  panel.places.note(std::string(control.name), ImGui::CalcItemWidth());
  if (changed) {
    double stepped = value;
    if (control.step > 0) stepped = control.least + control.step * std::round((value - control.least) / control.step);
    stepped = std::clamp(stepped, control.least, control.greatest);
    if (turns_light(control.name)) {
      viewer.drag_light(turn_with(viewer.state(), control.name, stepped));
    } else {
      viewer.set_control(control.name, stepped);
    }
  }
  if (released && turns_light(control.name)) viewer.release_light();
}

void draw_choice(Viewer& viewer, PanelState& panel, const Control& control, const char* label) {
  const auto chosen = static_cast<std::size_t>(viewer.state().value(control.name));
  if (!ImGui::BeginCombo(label, shown(control.choices[chosen]).c_str())) {
    panel.places.note(std::string(control.name), ImGui::CalcItemWidth());
    return;
  }
  for (std::size_t i = 0; i < control.choices.size(); ++i) {
    if (ImGui::Selectable(shown(control.choices[i]).c_str(), i == chosen)) {
      viewer.set_control(control.name, static_cast<double>(i));
    }
    panel.places.note(fmt::format("{}/{}", control.name, i));
  }
  ImGui::EndCombo();
}

void draw_control(Viewer& viewer, PanelState& panel, const Control& control) {
  const std::string label = shown(control.label) + "##" + std::string(control.name);
  ImGui::PushItemWidth(0.4f * ImGui::GetContentRegionAvail().x);
  switch (control.kind) {
    case ControlKind::kSlider:
      draw_slider(viewer, panel, control, label.c_str());
      break;
    case ControlKind::kChoice:
      draw_choice(viewer, panel, control, label.c_str());
      break;
    case ControlKind::kToggle:
      bool on = viewer.state().value(control.name) != 0;
      if (ImGui::Checkbox(label.c_str(), &on)) viewer.set_control(control.name, on ? 1 : 0);
      panel.places.note(std::string(control.name));
      break;
  }
  ImGui::PopItemWidth();
}

}  // namespace

void draw_control_panel(Viewer& viewer, PanelState& panel) {
  for (const std::string_view name : viewer.state().technique->controls) {
    draw_control(viewer, panel, control_named(name));
  }
  if (!viewer.state().technique->controls.empty()) ImGui::Separator();
  for (const Control& control : common_controls()) draw_control(viewer, panel, control);
}

}  // namespace zonal
