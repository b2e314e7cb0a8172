#include <imgui.h>
#include <imgui_stdlib.h>

#include "apps/viewer/panels.h"
#include "apps/viewer/plain_text.h"

namespace zonal {

void draw_picture_panel(Viewer& viewer, PanelState& panel) {
  if (viewer.difference()) {
    ImGui::Text("difference to the exact answer: %.2g of it", viewer.difference()->rms);
    ImGui::TextDisabled("RMS over %d pixels of the object", static_cast<int>(viewer.difference()->pixels));
  } else {
    ImGui::TextDisabled("difference to the exact answer: ...");
    ImGui::TextDisabled(" ");
  }
  ImGui::TextDisabled("picture drawn in %.0f ms", viewer.picture().full_ms());
  ImGui::SetNextItemWidth(-100);
  ImGui::InputText("##screenshot", &panel.screenshot_path);
  panel.places.note("screenshot path");
  ImGui::SameLine();
  if (ImGui::Button("Screenshot", {-1, 0})) viewer.save_screenshot(panel.screenshot_path);
  panel.places.note("screenshot");
  // The settings follow what is done elsewhere, but not while someone writes them.
  if (!panel.settings_are_typed) panel.settings = state_text(viewer.state());
  ImGui::SetNextItemWidth(-1);
  const bool entered =
      ImGui::InputTextWithHint("##settings", "settings", &panel.settings, ImGuiInputTextFlags_EnterReturnsTrue);
  panel.settings_are_typed = ImGui::IsItemActive();
  panel.places.note("settings");
  if (entered) viewer.set_settings(panel.settings);
}

void draw_notices(Viewer& viewer, PanelState& panel, float left, float top, float width) {
  const std::vector<WorkProgress> works = viewer.progress();
  if (works.empty() && viewer.messages().empty()) return;
  ImGui::SetNextWindowPos({left, top});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::SetNextWindowBgAlpha(0.85f);
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing;
  ImGui::Begin("notices", nullptr, kFlags);
  for (const WorkProgress& work : works) {
    ImGui::TextWrapped("%s", shown(work.title).c_str());
    ImGui::ProgressBar(static_cast<float>(work.fraction), {-1, 0}, work.stage.c_str());
  }
  if (!works.empty()) {
    if (ImGui::Button("Cancel")) viewer.cancel();
    panel.places.note("cancel");
  }
  for (const ViewerMessage& message : viewer.messages()) {
    const ImVec4 color = message.failure ? ImVec4(1, 0.55f, 0.45f, 1) : ImGui::GetStyleColorVec4(ImGuiCol_Text);
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextWrapped("%s", shown(message.text).c_str());
    ImGui::PopStyleColor();
    if (message.hint.empty()) continue;
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("%s", shown(message.hint).c_str());
    ImGui::PopStyleColor();
  }
  if (!viewer.messages().empty()) {
    if (ImGui::Button("Dismiss")) viewer.dismiss_messages();
    panel.places.note("dismiss");
  }
  ImGui::End();
}

}  // namespace zonal
