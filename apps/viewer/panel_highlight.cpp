#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "apps/viewer/panels.h"
#include "zonal/image/color.h"

namespace zonal {
namespace {

constexpr double kOwn = 2;  // of the choices of highlight_source

Brush brush_of(const PaintState& paint) {
  Brush brush{.radius = paint.radius, .light = {}};
  if (!paint.erases) brush.light = paint.brightness * srgb_decode(Rgb(paint.color[0], paint.color[1], paint.color[2]));
  return brush;
}

/// The sphere map as a disc; what a pointer does on it is painting.
void draw_disc(Viewer& viewer, PaintState& paint) {
  if (paint.shown_edition != viewer.highlight().edition()) {
    paint.shown_edition = viewer.highlight().edition();
    paint.shown.set(tonemap(viewer.highlight().picture(), {}));
  }
  const float size = std::min(ImGui::GetContentRegionAvail().x, 14 * ImGui::GetFontSize());
  const ImVec2 corner = ImGui::GetCursorScreenPos(), mouse = ImGui::GetIO().MousePos;
  ImGui::InvisibleButton("##paint", {size, size});
  const ImVec2 far = {corner.x + size, corner.y + size}, middle = {corner.x + size / 2, corner.y + size / 2};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddImageRounded(paint.shown.id(), corner, far, {0, 0}, {1, 1}, IM_COL32_WHITE, size / 2);
  list.AddCircle(middle, size / 2, ImGui::GetColorU32(ImGuiCol_TextDisabled));
  if (ImGui::IsItemActive()) {
    viewer.paint_highlight((mouse.x - corner.x) / size, (mouse.y - corner.y) / size, brush_of(paint));
  }
  if (ImGui::IsItemDeactivated()) viewer.end_highlight_stroke();
  if (!ImGui::IsItemHovered()) return;
  ImGui::SetMouseCursor(ImGuiMouseCursor_None);
  list.AddCircle(mouse, paint.radius * size, IM_COL32(255, 255, 255, 160));
}

}  // namespace

void draw_highlight_panel(Viewer& viewer, PaintState& paint) {
  const auto& names = viewer.state().technique->controls;
  if (std::ranges::find(names, "highlight_source") == names.end()) return;
  if (viewer.state().value("highlight_source") != kOwn) return;
  ImGui::TextWrapped("Paint on the disc: it is the object as the eye sees it.");
  draw_disc(viewer, paint);
  ImGui::SetNextItemWidth(-90);
  ImGui::SliderFloat("brush", &paint.radius, 0.02f, 0.5f, "%.2f", ImGuiSliderFlags_AlwaysClamp);
  ImGui::SetNextItemWidth(-90);
  ImGui::SliderFloat("brightness", &paint.brightness, 0.1f, 10, "%.1f", ImGuiSliderFlags_AlwaysClamp);
  ImGui::ColorEdit3("colour", paint.color, ImGuiColorEditFlags_NoInputs);
  ImGui::SameLine();
  ImGui::Checkbox("erase", &paint.erases);
  ImGui::SameLine();
  if (ImGui::Button("Clear")) viewer.replace_highlight(Image<Rgb>(kOwnHighlightPx, kOwnHighlightPx));
  ImGui::SetNextItemWidth(-1);
  constexpr ImGuiInputTextFlags kReturn = ImGuiInputTextFlags_EnterReturnsTrue;
  if (ImGui::InputTextWithHint("##highlight", "or the path of a picture", &paint.path, kReturn) &&
      !paint.path.empty()) {
    viewer.open_highlight(paint.path);
  }
}

}  // namespace zonal
