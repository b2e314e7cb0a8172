#pragma once

#include <vector>

#include "zonal/io/picture.h"

namespace zonal {

/// Decides whether a picture's integers are sRGB, and tells `picture` (srgb_decoded and a note where it was an
/// assumption). `file_says_linear`: the file itself declares linear samples.
bool decide_srgb(const LoadOptions&, bool file_says_linear, Picture& picture);

/// The linear value of every integer sample of `bits` (1 to 16) bits; the largest one is 1.
std::vector<float> linear_of_samples(int bits, bool srgb);

}  // namespace zonal
