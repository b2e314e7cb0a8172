#pragma once

#include <string>

#include "zonal/light/survey.h"

namespace zonal {

/// "3 texels are not finite (1 NaN, 2 infinite)"; "" for a sound map.
std::string non_finite_words(const Survey&);

}  // namespace zonal
