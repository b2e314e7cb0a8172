#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <vector>

#include "apps/viewer/panels.h"
#include "apps/viewer/plain_text.h"

namespace zonal {
namespace {

/// In the order of their first technique.
std::vector<std::string_view> groups() {
  std::vector<std::string_view> list;
  for (const Technique& technique : all_techniques()) {
    if (std::ranges::find(list, technique.group) == list.end()) list.push_back(technique.group);
  }
  return list;
}

}  // namespace

void draw_technique_panel(Viewer& viewer, PanelState& panel) {
  ImGui::SetNextItemWidth(-1);
  const bool open =
      ImGui::BeginCombo("##technique", shown(viewer.state().technique->title).c_str(), ImGuiComboFlags_HeightLargest);
  if (!open) panel.places.note("technique");
  if (open) {
    for (const std::string_view group : groups()) {
      ImGui::TextDisabled("%s", shown(group).c_str());
      ImGui::Indent();
      for (const Technique& technique : all_techniques()) {
        if (technique.group != group) continue;
        ImGui::PushID(technique.id.data(), technique.id.data() + technique.id.size());
        const bool chosen = &technique == viewer.state().technique;
        if (ImGui::Selectable(shown(technique.title).c_str(), chosen)) viewer.set_technique(technique);
        panel.places.note(fmt::format("technique/{}", technique.id));
        ImGui::PopID();
      }
      ImGui::Unindent();
    }
    ImGui::EndCombo();
  }
  const Technique& chosen = *viewer.state().technique;
  ImGui::TextWrapped("%s", shown(chosen.explanation).c_str());
  ImGui::Spacing();
  ImGui::TextWrapped("%s", shown(chosen.formula).c_str());
  ImGui::Spacing();
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  ImGui::TextWrapped("%s", shown(chosen.source).c_str());
  ImGui::PopStyleColor();
}

}  // namespace zonal
