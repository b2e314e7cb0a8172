#pragma once

#include <set>
#include <string>

namespace zonal {

/// All names in what main() of a shader calls, directly or not: helpers that are there for other shaders do not count.
/// So a picture is read from those textures alone that are among them.
std::set<std::string> names_reached(const std::string& shader);

}  // namespace zonal
