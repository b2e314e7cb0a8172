#pragma once

#include <string>
#include <string_view>

namespace zonal {

/// A 32-bit float as every shading language reads it: the shortest digits that give it back, with a point or an
/// exponent, then `suffix`. Throws Error{kInput} for what no float holds.
std::string shader_number(double value, std::string_view suffix = {});

}  // namespace zonal
