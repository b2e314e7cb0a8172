#include "zonal/light/survey_words.h"

namespace zonal {

std::string non_finite_words(const Survey& survey) {
  const std::int64_t bad = survey.nan_texels + survey.inf_texels;
  if (bad == 0) return "";
  return std::to_string(bad) + (bad == 1 ? " texel is" : " texels are") + " not finite (" +
         std::to_string(survey.nan_texels) + " NaN, " + std::to_string(survey.inf_texels) + " infinite)";
}

}  // namespace zonal
