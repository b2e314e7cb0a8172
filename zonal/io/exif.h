#pragma once

#include <cstdint>
#include <span>

namespace zonal {

/// The orientation (1 upright ... 8) that an APP1 block of a JPEG states in its first directory; 0 where it states none
/// (EXIF 2.3, tag 0x0112). Any bytes are safe.
int exif_orientation(std::span<const std::uint8_t> app1);

}  // namespace zonal
