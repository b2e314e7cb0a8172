#include "apps/zonal/layouts.h"

namespace zonal {

std::optional<Layout> layout_or_alias(std::string_view name) {
  if (name == "cube") return Layout::kCubeStack;
  return layout_named(name);
}

std::string layout_names() {
  std::string names = "cube";
  for (const Layout layout : all_layouts()) names += ", " + std::string(name_of(layout));
  return names;
}

}  // namespace zonal
