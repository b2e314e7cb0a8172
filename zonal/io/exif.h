#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "zonal/io/byte_reader.h"

namespace zonal {

/// A PNG may hold a larger block than a JPEG's 64 kB; what a camera writes is far smaller than this.
inline constexpr std::uint32_t kLargestExif = 1 << 20;

/// The EXIF block of a file: "Exif", two zeros and a TIFF directory. From the APP1 of a JPEG or the eXIf chunk of a
/// PNG; empty for files without one, damaged before it, or with one over kLargestExif (which is not read), and for
/// other formats. Any bytes are safe; what is inside the block is not looked at.
std::vector<std::uint8_t> find_exif(ByteReader&);

/// The orientation (1 upright ... 8) that such a block states in its first directory; 0 where it states none
/// (EXIF 2.3, tag 0x0112). Any bytes are safe.
int exif_orientation(std::span<const std::uint8_t> app1);

}  // namespace zonal
