#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "apps/zonal/call.h"
#include "zonal/light/environment.h"

namespace zonal {

/// What a user says about a map to be written.
struct OutputOptions {
  std::filesystem::path path;
  std::optional<Layout> to;
  int size_px = 0;  ///< natural unit of the layout; 0: the verb's choice
  std::optional<LensModel> lens;
  std::optional<double> fov_deg;
  bool half = false;     ///< EXR: 16 bit floats
  bool png16 = false;    ///< PNG: 16 bits
  bool float32 = false;  ///< KTX2: 32 bit floats
};

/// The projection to write; `fallback` when the user said none.
Projection target_of(const OutputOptions&, Layout fallback);
/// Throws Error{kUsage} when the path cannot hold a map of this layout, before any work is done.
void check_output(const OutputOptions&, Layout);

/// Writes a map: by extension as a picture or KTX2; six files for cubes, when the path is a folder or holds "%s". Says
/// what was written, and what the format could not hold. `quantity` for the metadata, `what` for the user.
void write_map(const Environment&, const OutputOptions&, const std::string& quantity, const std::string& what, Call&);

/// "256x128".
std::string words_of(ImageSize);

}  // namespace zonal
