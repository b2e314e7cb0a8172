#pragma once

#include <string>

#include "zonal/image/image.h"
#include "zonal/image/tonemap.h"

namespace zonal {

/// The picture as a lossless `data:image/png;base64,` address; the same pixels give the same bytes. The picture must
/// not be empty.
std::string png_data_uri(const Image<Rgb8>&);

}  // namespace zonal
