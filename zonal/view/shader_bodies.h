#pragma once

#include <span>
#include <string_view>

namespace zonal {

/// A file of zonal/view/shaders, put into the program when it is built (cmake/embed.cmake).
struct ShaderBody {
  std::string_view stem, text;
};
std::span<const ShaderBody> shader_bodies();

}  // namespace zonal
