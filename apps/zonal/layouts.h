#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "zonal/sphere/fineness.h"

namespace zonal {

/// A layout by its name, or "cube" for a stack of six faces.
std::optional<Layout> layout_or_alias(std::string_view name);
/// All of them, for messages.
std::string layout_names();

}  // namespace zonal
