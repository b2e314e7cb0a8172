#include <imgui.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "apps/viewer/panels.h"

namespace zonal {
namespace {

constexpr float kReach = 14;  // of a handle, in units of the window before the screen's scale

/// The settings while a person changes them: `done` when the light shall follow.
struct Edit {
  bool active = false, done = false;

  void typed() {
    active |= ImGui::IsItemActive();
    done |= ImGui::IsItemDeactivatedAfterEdit();
  }
  void chosen(bool changed) { done |= changed; }
};

GpuTexture texture_of(const Image<Rgb8>& small) {
  Image<Rgb> shares(small.width(), small.height());
  for (std::size_t i = 0; i < small.size(); ++i) {
    const Rgb8& code = small.values()[i];
    shares.values()[i] = {static_cast<float>(code.r) / 255, static_cast<float>(code.g) / 255,
                          static_cast<float>(code.b) / 255};
  }
  return GpuTexture({.name = "photograph", .levels = {std::move(shares)}});
}

ImVec2 on_screen(const FisheyePanel& panel, PixelPoint p) {
  return {panel.left + static_cast<float>(p.x) * panel.scale, panel.top + static_cast<float>(p.y) * panel.scale};
}

void draw_circle(const FisheyePanel& panel, const PixelCircle& circle) {
  constexpr int kPieces = 96;
  constexpr ImU32 kLine = IM_COL32(255, 170, 60, 255), kShadow = IM_COL32(0, 0, 0, 160);
  std::vector<ImVec2> points;
  for (int i = 0; i < kPieces; ++i) {
    const double angle = 2 * kPi * i / kPieces;
    points.push_back(on_screen(panel, {circle.center_x + circle.radius_x * std::cos(angle),
                                       circle.center_y + circle.radius_y * std::sin(angle)}));
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const auto& [color, thickness] : {std::pair(kShadow, 4.0f), std::pair(kLine, 2.0f)}) {
    list.AddPolyline(points.data(), kPieces, color, ImDrawFlags_Closed, thickness);
  }
  for (const CircleHandle handle :
       {CircleHandle::kCenter, CircleHandle::kRight, CircleHandle::kLeft, CircleHandle::kTop, CircleHandle::kBottom}) {
    const ImVec2 at = on_screen(panel, place_of(circle, handle));
    list.AddCircleFilled(at, 6, kShadow);
    list.AddCircleFilled(at, panel.held == handle ? 5.0f : 4.0f, kLine);
  }
}

void show_cursor(CircleHandle handle) {
  if (handle == CircleHandle::kNone) return;
  const bool across = handle == CircleHandle::kLeft || handle == CircleHandle::kRight;
  ImGui::SetMouseCursor(handle == CircleHandle::kCenter ? ImGuiMouseCursor_ResizeAll
                        : across                        ? ImGuiMouseCursor_ResizeEW
                                                        : ImGuiMouseCursor_ResizeNS);
}

/// The photograph as wide as the panel, and the circle under the pointer.
void draw_picture(FisheyePanel& panel, ImageSize size, Edit& edit) {
  const float width = ImGui::GetContentRegionAvail().x;
  panel.scale = width / static_cast<float>(size.width);
  const ImVec2 extent = {width, panel.scale * static_cast<float>(size.height)}, corner = ImGui::GetCursorScreenPos();
  panel.left = corner.x, panel.top = corner.y;
  ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(panel.picture->id())), extent);
  PhotographSettings& edited = panel.edited;
  if (!edited.is_fisheye) return;

  ImGui::SetCursorScreenPos(corner);
  ImGui::InvisibleButton("circle", extent);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const PixelPoint at = {(mouse.x - corner.x) / panel.scale, (mouse.y - corner.y) / panel.scale};
  const CircleHandle under = handle_at(edited.circle, at, kReach * ImGui::GetFontSize() / 15 / panel.scale);
  if (ImGui::IsItemActivated()) {
    panel.held = under;
    panel.grabbed = at;
    panel.before = edited.circle;
  }
  if (ImGui::IsItemActive() && panel.held != CircleHandle::kNone) {
    edited.circle =
        dragged_circle(panel.before, panel.held, at.x - panel.grabbed.x, at.y - panel.grabbed.y, panel.is_round, size);
    edit.active = true;
  }
  if (ImGui::IsItemDeactivated()) {
    const bool moved = at.x != panel.grabbed.x || at.y != panel.grabbed.y;
    edit.done |= panel.held != CircleHandle::kNone && moved;
    panel.held = CircleHandle::kNone;
  }
  if (ImGui::IsItemHovered()) show_cursor(panel.held == CircleHandle::kNone ? under : panel.held);
  ImGui::PushClipRect(corner, {corner.x + extent.x, corner.y + extent.y}, true);
  draw_circle(panel, edited.circle);
  ImGui::PopClipRect();
}

/// Two numbers of the circle in a row.
void draw_numbers(const char* label, double& x, double& y, Edit& edit) {
  std::array<double, 2> numbers = {x, y};
  if (ImGui::InputScalarN(label, ImGuiDataType_Double, numbers.data(), 2, nullptr, nullptr, "%.1f")) {
    x = numbers[0], y = numbers[1];
  }
  edit.typed();
}

void draw_lens(PhotographSettings& edited, Edit& edit) {
  if (ImGui::BeginCombo("lens", std::string(name_of(edited.lens)).c_str())) {
    for (const LensModel model :
         {LensModel::kEquidistant, LensModel::kEquisolid, LensModel::kStereographic, LensModel::kOrthographic}) {
      const bool chosen = model == edited.lens;
      if (ImGui::Selectable(std::string(name_of(model)).c_str(), chosen) && !chosen) {
        edited.lens = model;
        edit.chosen(true);
      }
    }
    ImGui::EndCombo();
  }
  ImGui::InputDouble("sees, degrees", &edited.fov_deg, 0, 0, "%.1f");
  edit.typed();
}

void draw_ground(PhotographSettings& edited, Edit& edit) {
  edit.chosen(ImGui::Checkbox("ground as the mean of the rim", &edited.ground_is_rim));
  if (edited.ground_is_rim) return;
  ImGui::ColorEdit3("ground", &edited.ground.r,
                    ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR | ImGuiColorEditFlags_NoOptions);
  edit.typed();
}

}  // namespace

void draw_fisheye_panel(Viewer& viewer, FisheyePanel& panel) {
  if (!viewer.photograph()) {
    ImGui::TextDisabled("Drop a picture, or type its path below");
    return;
  }
  const Photograph& photograph = *viewer.photograph();
  if (panel.shown != photograph.small) {
    panel.picture.emplace(texture_of(*photograph.small));
    panel.shown = photograph.small;
    panel.held = CircleHandle::kNone;
    panel.is_edited = false;
    panel.is_round = photograph.said.circle.radius_x == photograph.said.circle.radius_y;
  }
  if (!panel.is_edited) panel.edited = photograph.said;
  PhotographSettings& edited = panel.edited;
  Edit edit;
  ImGui::TextWrapped("%s", photograph.name.c_str());
  edit.chosen(ImGui::Checkbox("this picture is a fisheye photograph", &edited.is_fisheye));
  draw_picture(panel, photograph.size(), edit);
  if (edited.is_fisheye) {
    ImGui::PushItemWidth(0.6f * ImGui::GetContentRegionAvail().x);
    draw_numbers("centre x, y", edited.circle.center_x, edited.circle.center_y, edit);
    draw_numbers("radius x, y", edited.circle.radius_x, edited.circle.radius_y, edit);
    ImGui::Checkbox("drag both radii", &panel.is_round);
    draw_lens(edited, edit);
    draw_ground(edited, edit);
    ImGui::PopItemWidth();
  }
  panel.is_edited = edit.active && !edit.done;
  if (!edit.done) return;
  edited.circle = limited_circle(edited.circle, photograph.size());
  viewer.set_photograph(edited);
}

}  // namespace zonal
