#include "apps/viewer/widget_places.h"

#include <imgui.h>

#include <utility>

namespace zonal {
namespace {

WidgetPlace::Box box(ImVec2 from, ImVec2 to) { return {from.x, from.y, to.x, to.y}; }

}  // namespace

void WidgetPlaces::note(std::string name, float width) {
  const ImDrawList& list = *ImGui::GetWindowDrawList();
  WidgetPlace place{.item = box(ImGui::GetItemRectMin(), ImGui::GetItemRectMax()),
                    .around = box(list.GetClipRectMin(), list.GetClipRectMax())};
  if (width > 0) place.item.right = place.item.left + width;
  const double x = place.item.x(), y = place.item.y();
  place.visible = x > place.around.left && x < place.around.right && y > place.around.top && y < place.around.bottom;
  places_.insert_or_assign(std::move(name), place);
}

std::optional<WidgetPlace> WidgetPlaces::find(std::string_view name) const {
  const auto found = places_.find(name);
  return found == places_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace zonal
