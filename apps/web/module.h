#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace zonal {

/// The library as a WebAssembly module, to be put into pages (ViewPageOptions).
std::span<const std::byte> web_module();
/// What the licences of its parts by others ask to be said beside it; plain ASCII.
std::string_view web_notices();

}  // namespace zonal
