#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "zonal/math/vec.h"

namespace zonal {

/// "1,2.5,-3" as numbers, `least` to `most` of them, all finite. Throws Error{kUsage} that names the option.
std::vector<double> numbers_in(std::string_view text, std::size_t least, std::size_t most, std::string_view option);

/// "0.5" (grey) or "0.2,0.3,0.4".
Rgb color_in(std::string_view text, std::string_view option);

}  // namespace zonal
