#include "zonal/report/warnings.h"

#include <gtest/gtest.h>

#include <string>

namespace zonal {
namespace {

Survey sound() {
  Survey survey;
  survey.max_luminance = 1;
  return survey;
}

/// The one warning of a survey.
std::string only_warning(const Survey& survey) {
  const std::vector<Warning> warnings = warnings_of(survey);
  EXPECT_EQ(warnings.size(), 1u);
  return warnings.empty() ? "" : warnings[0].what + " " + warnings[0].detail;
}

TEST(Warnings, SoundDataHaveNone) { EXPECT_TRUE(warnings_of(sound()).empty()); }

TEST(Warnings, EachDoubtHasItsOwnWithItsFigures) {
  Survey survey = sound();
  survey.nan_texels = 1;
  EXPECT_NE(only_warning(survey).find("1 texel holds NaN"), std::string::npos);
  survey = sound();
  survey.inf_texels = 3;
  EXPECT_NE(only_warning(survey).find("3 texels hold an infinite value"), std::string::npos);
  survey = sound();
  survey.negative_texels = 17;
  survey.negative_energy_share = 0.0123;
  EXPECT_NE(only_warning(survey).find("17 texels hold negative"), std::string::npos);
  EXPECT_NE(only_warning(survey).find("1.23 %"), std::string::npos);
  survey = sound();
  survey.clipped_sun = true;
  survey.plateau_texels = 213;
  EXPECT_NE(only_warning(survey).find("213 texels"), std::string::npos);
  survey = sound();
  survey.max_luminance = 0;
  EXPECT_NE(only_warning(survey).find("black"), std::string::npos);
}

TEST(Warnings, TheyAddUp) {
  Survey survey;
  survey.nan_texels = survey.inf_texels = survey.negative_texels = 2;
  survey.clipped_sun = true;
  EXPECT_EQ(warnings_of(survey).size(), 5u);
}

}  // namespace
}  // namespace zonal
