#include "zonal/io/sh_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "zonal/base/error.h"
#include "zonal/io/json_fields.h"
#include "zonal/io/json_text.h"
#include "zonal/sh/convention.h"
#include "zonal/sh/irradiance.h"

namespace zonal {
namespace {

constexpr std::array<std::string_view, 3> kQuantityNames = {"radiance", "irradiance", "irradiance/pi"};
constexpr int kVersion = 1, kMaxBands = 1024;

constexpr const char* kSubject = "SH coefficients";

/// What the quantity has of the radiance of band l.
std::vector<double> factors_of(ShQuantity quantity, int bands) {
  if (quantity == ShQuantity::kRadiance) return std::vector<double>(static_cast<std::size_t>(bands), 1.0);
  std::vector<double> factors = cosine_factors(bands);
  if (quantity == ShQuantity::kIrradiance) {
    for (double& factor : factors) factor *= kPi;
  }
  return factors;
}

}  // namespace

std::string_view name_of(ShQuantity quantity) { return kQuantityNames[static_cast<std::size_t>(quantity)]; }

std::optional<ShQuantity> sh_quantity_named(std::string_view name) {
  for (std::size_t i = 0; i < kQuantityNames.size(); ++i) {
    if (kQuantityNames[i] == name) return static_cast<ShQuantity>(i);
  }
  return std::nullopt;
}

ShFile to_quantity(const ShFile& file, ShQuantity quantity) {
  if (file.quantity == quantity) return file;
  const int bands = file.coefficients.bands();
  if (quantity == ShQuantity::kRadiance && bands > 3) {
    throw Error(ErrorKind::kUsage, fmt::format("radiance cannot be had from irradiance with {} bands", bands),
                "the cosine has removed band 3: use 3 bands, or coefficients of the radiance");
  }
  const std::vector<double> have = factors_of(file.quantity, bands);
  std::vector<double> ratio = factors_of(quantity, bands);
  // Where both are irradiance the lost bands are zero in both: any ratio will do.
  for (std::size_t l = 0; l < ratio.size(); ++l) ratio[l] = have[l] == 0 ? 0 : ratio[l] / have[l];
  return {quantity, convolve(file.coefficients, ratio)};
}

std::string sh_json_text(const ShFile& file) {
  const auto fail = [](const std::string& what, std::string hint = {}) {
    throw Error(ErrorKind::kInput, fmt::format("{}: {}", kSubject, what), std::move(hint));
  };
  if (file.coefficients.size() == 0) fail("there are none");
  JsonValue::Array rows;
  for (std::size_t i = 0; i < file.coefficients.size(); ++i) {
    const RgbD c = file.coefficients[i];
    if (!std::isfinite(c.r) || !std::isfinite(c.g) || !std::isfinite(c.b)) {
      fail(fmt::format("coefficient {} is not finite", i), "the picture has NaN or infinite pixels: repair it first");
    }
    rows.emplace_back(JsonValue::Array{c.r, c.g, c.b});
  }
  return json_text(JsonValue::Object{{"format", "zonal-sh"},
                                     {"version", kVersion},
                                     {"bands", file.coefficients.bands()},
                                     {"quantity", name_of(file.quantity)},
                                     {"basis", "real"},
                                     {"condon_shortley", false},
                                     {"frame", "z-up-right-handed"},
                                     {"coefficients", std::move(rows)}});
}

ShFile parse_sh_json(std::string_view text) {
  JsonFields fields = JsonFields::of_document(text, kSubject);
  fields.expect("format", "zonal-sh");
  fields.integer("version", kVersion, kVersion);
  Sh<RgbD> coefficients(fields.integer("bands", 1, kMaxBands));
  const std::string quantity_name = fields.text("quantity");
  const std::optional<ShQuantity> quantity = sh_quantity_named(quantity_name);
  if (!quantity) {
    fields.wrong("quantity", fmt::format("is \"{}\"", quantity_name),
                 "it is one of radiance, irradiance, irradiance/pi");
  }
  fields.expect("basis", "real");
  const bool is_signed = fields.boolean("condon_shortley");
  fields.expect("frame", "z-up-right-handed");
  const std::vector<RgbD> rows = fields.triples("coefficients", "coefficient");
  if (rows.size() != coefficients.size()) {
    fields.fail(fmt::format("{} bands have {} coefficients, this has {}", coefficients.bands(), coefficients.size(),
                            rows.size()));
  }
  fields.end();
  std::ranges::copy(rows, coefficients.values().begin());
  if (is_signed) coefficients = from_condon_shortley(coefficients);
  return {*quantity, std::move(coefficients)};
}

}  // namespace zonal
