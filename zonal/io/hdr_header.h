#pragma once

#include <string>
#include <vector>

#include "zonal/io/byte_reader.h"
#include "zonal/math/vec.h"

namespace zonal {

/// The text before the pixels of a Radiance picture.
struct HdrHeader {
  RgbD exposure = {1, 1, 1};      ///< all EXPOSURE and COLORCORR lines multiplied: radiance = pixel / exposure
  bool rows_are_columns = false;  ///< the file's scanlines run down the picture's columns
  bool x_reversed = false;        ///< "-X": the rightmost column comes first
  bool y_reversed = false;        ///< "+Y": the bottom row comes first
  int width = 0, height = 0;      ///< of the upright picture
  std::vector<std::string> notes;
};

/// Reads up to the first byte of pixels. Throws Error{kInput} for whatever is not a Radiance header of RGBE pixels.
HdrHeader read_hdr_header(ByteReader&);

}  // namespace zonal
