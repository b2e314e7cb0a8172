#include "zonal/report/warnings.h"

#include <fmt/format.h>

#include <cstdint>

#include "zonal/report/text.h"

namespace zonal {
namespace {

/// "1 texel holds", "2 texels hold".
std::string texels_hold(std::int64_t texels) {
  return texels == 1 ? "1 texel holds" : fmt::format("{} texels hold", texels);
}

}  // namespace

std::vector<Warning> warnings_of(const Survey& survey) {
  std::vector<Warning> warnings;
  if (survey.nan_texels > 0) {
    warnings.push_back({fmt::format("{} NaN.", texels_hold(survey.nan_texels)),
                        "Left out of every sum; --fix fills in the mean of the neighbours."});
  }
  if (survey.inf_texels > 0) {
    warnings.push_back(
        {fmt::format("{} an infinite value.", texels_hold(survey.inf_texels)),
         "Left out of every sum, and a light may be missing with them; --fix fills in the mean of the neighbours."});
  }
  if (survey.negative_texels > 0) {
    warnings.push_back({fmt::format("{} negative radiance.", texels_hold(survey.negative_texels)),
                        fmt::format("Their energy is {} of the positive energy. It is kept; --fix raises it to zero.",
                                    percent(survey.negative_energy_share))});
  }
  if (survey.clipped_sun) {
    warnings.push_back({"The brightest light looks clipped.",
                        fmt::format("{} texels hold the same largest value: the ceiling of a sensor or of a file "
                                    "format. Shadows will be too soft and the "
                                    "light too weak. Take darker exposures, or replace the light.",
                                    survey.plateau_texels)});
  }
  if (!(survey.max_luminance > 0)) {
    warnings.push_back({"The map is black.", "No texel has a positive luminance."});
  }
  return warnings;
}

}  // namespace zonal
