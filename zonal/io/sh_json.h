#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "zonal/sh/sh.h"

namespace zonal {

/// What spherical-harmonic coefficients are the coefficients of: the radiance that arrives, the irradiance E on a
/// surface as a function of its normal, or E/pi, which a white matte surface reflects.
enum class ShQuantity { kRadiance, kIrradiance, kIrradianceOverPi };

std::string_view name_of(ShQuantity);  // "radiance", "irradiance", "irradiance/pi"
std::optional<ShQuantity> sh_quantity_named(std::string_view name);

/// Coefficients and what they mean, in the memory convention (sh/sh.h): the value of a coefficient file.
struct ShFile {
  ShQuantity quantity = ShQuantity::kRadiance;
  Sh<RgbD> coefficients;

  bool operator==(const ShFile&) const = default;
};

/// The same light as another quantity. Throws Error{kUsage} for radiance from irradiance with more than 3 bands: the
/// cosine has removed odd bands above l = 1 for good.
ShFile to_quantity(const ShFile&, ShQuantity);

/// {"format":"zonal-sh","version":1,"bands":3,"quantity":...,"basis":"real","condon_shortley":false,
/// "frame":"z-up-right-handed","coefficients":[[r,g,b],...]}, coefficient (l, m) at l(l+1)+m, in the shortest decimals
/// that read back as the same doubles. Throws Error{kInput} when a coefficient is not finite or there is none.
std::string sh_json_text(const ShFile&);

/// Reads that schema and no other: every field must be there, once, with a value that is known, and nothing else.
/// Coefficients of the Condon-Shortley basis are converted. At most 1024 bands. Throws Error{kInput} that names the
/// field.
ShFile parse_sh_json(std::string_view text);

}  // namespace zonal
