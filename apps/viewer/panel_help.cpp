#include <imgui.h>

#include <algorithm>
#include <utility>

#include "apps/viewer/panels.h"
#include "apps/viewer/plain_text.h"

namespace zonal {
namespace {

constexpr std::pair<const char*, const char*> kHelp[] = {
    {"Left drag", "around the object"},
    {"Right drag", "turns the light: sideways about the vertical, up and down about the eye's horizontal axis"},
    {"Wheel, + and -", "nearer and farther"},
    {"Arrow keys", "around the object, five degrees at a time"},
    {"Drop files", "an image is the light, six images are the faces of a cube; an OBJ, PLY or glTF file is the object"},
    {"Ctrl and click", "on a slider: type its number"},
    {"Ctrl and Tab", "to the panels; there the arrow keys go from item to item, Space presses one"},
    {"F1", "shows this"},
    {"Escape", "closes this, else the messages, and gives the keys back to the picture"}};

}  // namespace

void draw_help_button(PanelState& panel, float right, float bottom) {
  ImGui::SetNextWindowPos({right, bottom}, ImGuiCond_Always, {1, 1});
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                      ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_AlwaysAutoResize;
  ImGui::Begin("help button", nullptr, kFlags);
  if (ImGui::Button("?")) panel.help = !panel.help;
  panel.places.note("help");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Mouse and keys (F1)");
  ImGui::End();
}

void draw_help(PanelState& panel, float width, float height) {
  if (!panel.help) return;
  const float wanted = 34 * ImGui::GetFontSize();
  ImGui::SetNextWindowPos({0.5f * width, 0.5f * height}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {width, height});
  ImGui::SetNextWindowSize({std::min(wanted, width), 0});
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse;
  ImGui::Begin("Mouse and keys", &panel.help, kFlags);
  if (ImGui::BeginTable("keys", 2)) {
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed);
    for (const auto& [what, does] : kHelp) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(what);
      ImGui::TableNextColumn();
      ImGui::TextWrapped("%s", does);
    }
    ImGui::EndTable();
  }
  if (ImGui::Button("Close")) panel.help = false;
  panel.places.note("help/close");
  ImGui::End();
}

}  // namespace zonal
