#include "zonal/io/ambient_cube_json.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/io/json_fields.h"
#include "zonal/io/json_text.h"

namespace zonal {
namespace {

constexpr std::array<const char*, 6> kSideNames = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
constexpr int kVersion = 1;

constexpr const char* kSubject = "ambient cube";

}  // namespace

std::string_view ambient_cube_side_name(std::size_t side) {
  check(side < kSideNames.size(), "a cube has six sides");
  return kSideNames[side];
}

std::string ambient_cube_json_text(const AmbientCubeFile& file) {
  JsonValue::Object sides;
  for (std::size_t i = 0; i < kSideNames.size(); ++i) {
    const RgbD c = file.cube.sides[i];
    if (!std::isfinite(c.r) || !std::isfinite(c.g) || !std::isfinite(c.b)) {
      throw Error(ErrorKind::kInput, fmt::format("{}: side {} is not finite", kSubject, kSideNames[i]));
    }
    sides.emplace_back(kSideNames[i], JsonValue::Array{c.r, c.g, c.b});
  }
  return json_text(JsonValue::Object{{"format", "zonal-ambient-cube"},
                                     {"version", kVersion},
                                     {"quantity", name_of(file.quantity)},
                                     {"frame", "z-up-right-handed"},
                                     {"sides", std::move(sides)}});
}

AmbientCubeFile parse_ambient_cube_json(std::string_view text) {
  JsonFields fields = JsonFields::of_document(text, kSubject);
  fields.expect("format", "zonal-ambient-cube");
  fields.integer("version", kVersion, kVersion);
  const std::optional<ShQuantity> quantity = sh_quantity_named(fields.text("quantity"));
  if (!quantity) fields.wrong("quantity", "is unknown", "it is one of radiance, irradiance, irradiance/pi");
  fields.expect("frame", "z-up-right-handed");
  JsonFields sides = fields.object("sides");
  AmbientCubeFile file{*quantity, {}};
  for (std::size_t i = 0; i < kSideNames.size(); ++i) file.cube.sides[i] = sides.triple(kSideNames[i]);
  sides.end();
  fields.end();
  return file;
}

}  // namespace zonal
