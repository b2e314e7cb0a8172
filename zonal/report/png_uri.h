#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "zonal/image/image.h"
#include "zonal/image/tonemap.h"

namespace zonal {

/// The picture as a lossless `data:image/png;base64,` address; the same pixels give the same bytes. The picture must
/// not be empty.
std::string png_data_uri(const Image<Rgb8>&);

/// RFC 4648, section 4, padded.
std::string base64(std::span<const std::byte> bytes);

}  // namespace zonal
