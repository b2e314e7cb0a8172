#pragma once

#include <string_view>

namespace zonal {

/// The version of library and programs; CMake reads it from this line.
inline constexpr std::string_view kVersion = "0.1.0";

}  // namespace zonal
