#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "apps/zonal/call.h"
#include "zonal/image/exposures.h"
#include "zonal/io/exposure_time.h"

namespace zonal {

/// What a user says about the photographs of a bracket.
struct BracketOptions {
  std::vector<std::filesystem::path> paths;
  std::string times;   ///< a list of times, or a file with one; empty: what the files say
  std::string ignore;  ///< "R,G,B" in codes of 255: texels of this colour hold no data
  std::int64_t max_pixels = 0;
};

struct Bracket {
  Exposures exposures;         ///< arranged
  ExposureSettings reference;  ///< the settings at which the exposures' seconds are meant
  bool linear = false;         ///< the files hold linear floats
};

/// Reads the photographs and when they were exposed for how long.
Bracket read_bracket(const BracketOptions&, Call&);

}  // namespace zonal
