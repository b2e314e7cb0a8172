#include <imgui.h>
#include <imgui_stdlib.h>

#include "apps/viewer/panels.h"
#include "apps/viewer/plain_text.h"

namespace zonal {
namespace {

/// A field for a path; true when Return was pressed in it.
bool path_field(PanelState& panel, const char* name, const char* hint, std::string& path) {
  ImGui::SetNextItemWidth(-1);
  const std::string label = std::string("##") + name;
  const bool entered = ImGui::InputTextWithHint(label.c_str(), hint, &path, ImGuiInputTextFlags_EnterReturnsTrue);
  panel.places.note(name);
  return entered && !path.empty();
}

void draw_times(const Viewer& viewer) {
  if (!viewer.live_times()) {
    ImGui::TextDisabled("Drag with the right button to turn the light");
    return;
  }
  const LiveTimes& times = *viewer.live_times();
  ImGui::Text("light turned anew in %.0f ms", times.all());
  ImGui::TextDisabled("pixels %.1f, harmonics %.1f,", times.turn, times.project);
  ImGui::TextDisabled("lights from these %.1f, filtered maps %.1f", times.derive, times.filter);
  if (!viewer.is_live_possible()) {
    ImGui::TextWrapped("This technique needs more maps than that: while you drag, its lookups are turned instead.");
  }
}

void draw_shapes(Viewer& viewer, PanelState& panel) {
  for (const std::string_view name : mesh_shape_names()) {
    if (ImGui::RadioButton(std::string(name).c_str(), viewer.state().mesh == name)) viewer.open_mesh(std::string(name));
    panel.places.note("mesh/" + std::string(name));
    ImGui::SameLine();
  }
  ImGui::NewLine();
}

}  // namespace

void draw_light_panel(Viewer& viewer, PanelState& panel) {
  ImGui::TextWrapped("%s", shown(viewer.light_name()).c_str());
  if (path_field(panel, "light path", "another image: drop it, or its path", panel.light_path))
    viewer.open({panel.light_path});
  draw_times(viewer);
  ImGui::Separator();
  ImGui::TextWrapped("%s", shown(viewer.mesh_name()).c_str());
  draw_shapes(viewer, panel);
  if (path_field(panel, "mesh path", "another mesh: drop it, or its path", panel.mesh_path))
    viewer.open_mesh(panel.mesh_path);
  bool y_up = viewer.mesh_up() == MeshUp::kY;
  if (ImGui::Checkbox("Y is up in every mesh file", &y_up)) viewer.set_mesh_up(y_up ? MeshUp::kY : MeshUp::kFormat);
  panel.places.note("mesh up");
}

}  // namespace zonal
