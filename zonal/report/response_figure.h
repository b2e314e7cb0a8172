#pragma once

#include <string>

#include "zonal/image/response.h"

namespace zonal {

/// A response as an SVG that stands alone: code against exposure, logarithmic; one line for each channel, or one for
/// all when they are the same.
std::string response_figure(const Response&);

}  // namespace zonal
