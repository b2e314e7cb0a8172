#include "zonal/io/lights_json.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/io/json_fields.h"
#include "zonal/io/json_text.h"

namespace zonal {
namespace {

constexpr int kVersion = 1;
constexpr std::size_t kMaxLights = 65536;
constexpr const char* kSubject = "lights";
constexpr const char* kFormat = "zonal-lights";
constexpr const char* kFrame = "z-up-right-handed";
constexpr const char* kAzimuth = "from +X toward +Y";
// What is said twice may have been rounded by whoever wrote it, but not be something else.
constexpr double kAgree = 1e-6;

[[noreturn]] void fail(const std::string& what, std::string hint = {}) {
  throw Error(ErrorKind::kInput, fmt::format("{}: {}", kSubject, what), std::move(hint));
}

std::string light_name(std::size_t index) { return fmt::format("light {}: ", index); }

bool is_finite(RgbD c) { return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b); }

JsonValue rgb(RgbD c) { return JsonValue::Array{c.r, c.g, c.b}; }

/// Throws unless the light can be written and read.
void check_light(const FileLight& light, const std::string& name) {
  if (!(std::abs(length(light.direction) - 1) <= kAgree)) fail(name + "\"direction\" is not of length 1");
  if (!is_finite(light.irradiance)) fail(name + "\"irradiance\" is not finite");
  if (!(light.half_angle >= 0 && light.half_angle <= kPi)) fail(name + "\"half_angle_deg\" is not from 0 to 180");
  if (light.half_angle > 0 && !is_finite(disc_radiance(light.irradiance, light.half_angle)))
    fail(name + "\"half_angle_deg\" is too small for a finite radiance", "0 stands for a single direction");
  if (light.share && !std::isfinite(*light.share)) fail(name + "\"share\" is not finite");
}

JsonValue light_json(const FileLight& light) {
  const auto [x, y, z] = light.direction;
  const bool disc = light.half_angle > 0;
  return JsonValue::Object{{"direction", JsonValue::Array{x, y, z}},
                           {"azimuth_deg", azimuth_deg(light.direction)},
                           {"elevation_deg", elevation_deg(light.direction)},
                           {"half_angle_deg", degrees(light.half_angle)},
                           {"solid_angle_sr", disc_solid_angle(light.half_angle)},
                           {"irradiance", rgb(light.irradiance)},
                           {"radiance", disc ? rgb(disc_radiance(light.irradiance, light.half_angle)) : JsonValue()},
                           {"share", light.share ? JsonValue(*light.share) : JsonValue()}};
}

std::optional<RgbD> optional_triple(JsonFields& fields, const char* name) {
  if (fields.is_null(name)) return std::nullopt;
  return fields.triple(name);
}

bool agree(double a, double b) { return std::abs(a - b) <= kAgree * std::max(std::abs(a), std::abs(b)); }

Vec3 direction_of(double azimuth, double elevation) {
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

FileLight parse_light(JsonFields& fields, const std::string& name) {
  FileLight light;
  const RgbD direction = fields.triple("direction");
  light.direction = {direction.r, direction.g, direction.b};
  light.half_angle = radians(fields.number("half_angle_deg"));
  light.irradiance = fields.triple("irradiance");
  if (!fields.is_null("share")) light.share = fields.number("share");
  if (light.half_angle > kPi && light.half_angle < kPi * (1 + kAgree)) light.half_angle = kPi;  // 180 and a rounding
  check_light(light, name);

  const double azimuth = radians(fields.number("azimuth_deg")), elevation = radians(fields.number("elevation_deg"));
  if (!(length(direction_of(azimuth, elevation) - light.direction) <= 2 * kAgree))
    fields.wrong("direction", "points elsewhere than \"azimuth_deg\" and \"elevation_deg\"");
  if (!agree(fields.number("solid_angle_sr"), disc_solid_angle(light.half_angle)))
    fields.wrong("solid_angle_sr", "does not belong to \"half_angle_deg\"");
  const std::optional<RgbD> radiance = optional_triple(fields, "radiance");
  if (radiance.has_value() != (light.half_angle > 0))
    fields.wrong("radiance", "is null for a half angle of 0 and only so");
  if (radiance) {
    const RgbD derived = disc_radiance(light.irradiance, light.half_angle);
    if (!agree(radiance->r, derived.r) || !agree(radiance->g, derived.g) || !agree(radiance->b, derived.b))
      fields.wrong("radiance", "does not belong to \"irradiance\" and \"half_angle_deg\"");
  }
  fields.end();
  return light;
}

}  // namespace

double azimuth_deg(Vec3 toward) {
  if (toward.x == 0 && toward.y == 0) return 0;
  return degrees(std::atan2(toward.y + 0.0, toward.x));  // + 0.0: from minus zero half a turn would be -180
}

double elevation_deg(Vec3 toward) { return degrees(std::atan2(toward.z, std::hypot(toward.x, toward.y))); }

double disc_solid_angle(double half_angle) {
  const double half_sine = std::sin(half_angle / 2);
  return 4 * kPi * half_sine * half_sine;  // keeps its digits for the smallest angles
}

RgbD disc_radiance(RgbD irradiance, double half_angle) {
  check(half_angle > 0, "a disc of light needs a size");
  const double sine = half_angle < kPi / 2 ? std::sin(half_angle) : 1;
  return (1 / (kPi * sine * sine)) * irradiance;
}

std::string lights_json_text(const LightsFile& file) {
  if (file.ambient && !is_finite(*file.ambient)) fail("\"ambient_radiance\" is not finite");
  if (file.lights.size() > kMaxLights) fail(fmt::format("{} are more than a file may hold", file.lights.size()));
  JsonValue::Array lights;
  for (std::size_t i = 0; i < file.lights.size(); ++i) {
    check_light(file.lights[i], light_name(i));
    lights.push_back(light_json(file.lights[i]));
  }
  return json_text(JsonValue::Object{{"format", kFormat},
                                     {"version", kVersion},
                                     {"frame", kFrame},
                                     {"azimuth", kAzimuth},
                                     {"ambient_radiance", file.ambient ? rgb(*file.ambient) : JsonValue()},
                                     {"lights", std::move(lights)}});
}

LightsFile parse_lights_json(std::string_view text) {
  JsonFields fields = JsonFields::of_document(text, kSubject);
  fields.expect("format", kFormat);
  fields.integer("version", kVersion, kVersion);
  fields.expect("frame", kFrame);
  fields.expect("azimuth", kAzimuth);
  LightsFile file;
  file.ambient = optional_triple(fields, "ambient_radiance");
  for (JsonFields& light : fields.objects("lights", "light", kMaxLights)) {
    file.lights.push_back(parse_light(light, light_name(file.lights.size())));
  }
  fields.end();
  return file;
}

}  // namespace zonal
