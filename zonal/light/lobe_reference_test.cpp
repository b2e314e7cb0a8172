#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "zonal/light/lobe.h"
#include "zonal/sh/convention.h"
#include "zonal/sh/zonal.h"

namespace zonal {
namespace {

const std::filesystem::path kFile = ZONAL_SOURCE_DIR "/../shared/reference/vectors/prefilter.json";

nlohmann::json read_reference() {
  std::ifstream file(kFile);
  return nlohmann::json::parse(file);
}

Lobe lobe_of(const std::string& kind, double parameter) {
  if (kind.starts_with("ggx")) return Lobe::ggx(parameter);
  return kind.starts_with("phong") ? Lobe::phong(parameter) : Lobe::blinn_phong(parameter);
}

TEST(LobeReference, BandFactorsAgreeWithHighPrecision) {
  if (!std::filesystem::exists(kFile)) GTEST_SKIP() << "no reference vectors here";
  const nlohmann::json reference = read_reference();
  int compared = 0;
  for (const char* kind : {"ggx_nl", "phong", "blinn_phong_nl"}) {
    for (const nlohmann::json& entry : reference[kind]) {
      const double parameter = entry.contains("s") ? entry["s"] : entry["alpha"];
      const std::vector<double> expected = entry["lambda"], factors = band_factors(lobe_of(kind, parameter), 129);
      ASSERT_EQ(expected.size(), factors.size());
      for (int l = 0; l < 129; ++l, ++compared) {
        EXPECT_NEAR(factors[l], expected[l], 2e-15)
            << kind << " " << parameter << " " << l;  // the file is rounded to double
      }
    }
  }
  EXPECT_EQ(compared, (8 + 5 + 4) * 129);
}

TEST(LobeReference, TailsBeginAtThePublishedBands) {
  if (!std::filesystem::exists(kFile)) GTEST_SKIP() << "no reference vectors here";
  const nlohmann::json reference = read_reference();
  int compared = 0;
  for (const nlohmann::json& entry : reference["thresholds"]) {
    const double parameter = entry.contains("s") ? entry["s"] : entry["alpha"];
    const Lobe lobe = lobe_of(entry["kind"], parameter);
    for (const auto& [tolerance, bands] : entry["lambda_lt"].items()) {
      EXPECT_EQ(bands_for(lobe, std::stod(tolerance)), bands.get<int>()) << entry["kind"] << " " << parameter;
      ++compared;
    }
    // The same for z_l/z_0 = lambda_l sqrt(2l+1).
    const std::vector<double> zonal = zonal_from_factors(band_factors(lobe, 4000));
    for (const auto& [tolerance, bands] : entry["zh_lt"].items()) {
      int needed = 4000;
      while (std::abs(zonal[needed - 1]) < std::stod(tolerance) * zonal[0]) --needed;
      EXPECT_EQ(needed, bands.get<int>()) << entry["kind"] << " " << parameter;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 52 * 7);
}

TEST(LobeReference, FilteringAgreesWithDirectIntegrals) {
  if (!std::filesystem::exists(kFile)) GTEST_SKIP() << "no reference vectors here";
  const nlohmann::json example = read_reference()["example"];
  Sh<double> with_sign(example["order"].get<int>());
  for (std::size_t i = 0; i < with_sign.size(); ++i) with_sign[i] = example["L"][i];
  const Sh<double> filtered =
      convolve(from_condon_shortley(with_sign), band_factors(Lobe::ggx(0.3), with_sign.bands()));
  int compared = 0;
  for (std::size_t i = 0; i < example["normals"].size(); ++i, ++compared) {
    const nlohmann::json& n = example["normals"][i];
    EXPECT_NEAR(evaluate(filtered, {n[0], n[1], n[2]}), example["ggx_0.3"][i].get<double>(), 1e-13);
  }
  EXPECT_EQ(compared, 6);
}

}  // namespace
}  // namespace zonal
