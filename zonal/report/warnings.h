#pragma once

#include <string>
#include <vector>

#include "zonal/light/survey.h"

namespace zonal {

/// Something doubtful about the data, for a person to judge. Nothing was repaired.
struct Warning {
  std::string what;    ///< one short sentence
  std::string detail;  ///< figures, consequences, what to do
};

/// What the survey gives reason to say: non-finite texels, negative radiance, a clipped sun, darkness. Empty for sound
/// data.
std::vector<Warning> warnings_of(const Survey&);

}  // namespace zonal
