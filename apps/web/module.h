#pragma once

#include <cstddef>
#include <span>

namespace zonal {

/// The library as a WebAssembly module, to be put into pages (ViewPageOptions).
std::span<const std::byte> web_module();

}  // namespace zonal
