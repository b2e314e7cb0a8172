#include "zonal/io/lights_json.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/io/json_text.h"

namespace zonal {
namespace {

using nlohmann::json;

constexpr int kVersion = 1;
constexpr std::size_t kMaxLights = 65536;
constexpr const char* kFormat = "zonal-lights";
constexpr const char* kFrame = "z-up-right-handed";
constexpr const char* kAzimuth = "from +X toward +Y";
// What is said twice may have been rounded by whoever wrote it, but not be something else.
constexpr double kAgree = 1e-6;

[[noreturn]] void fail(const std::string& what, std::string hint = {}) {
  throw Error(ErrorKind::kInput, "lights: " + what, std::move(hint));
}

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

/// Parses and refuses a field that stands twice in its object: the library would keep the last one without a word.
json parse(std::string_view text) {
  std::vector<std::set<std::string>> seen;  // seen[depth] = the fields of the object that is open there
  std::string twice;
  const auto watch = [&](int depth, json::parse_event_t event, const json& parsed) {
    const auto d = static_cast<std::size_t>(depth);
    if (event == json::parse_event_t::object_start) {
      seen.resize(std::max(seen.size(), d + 2));
      seen[d + 1].clear();
    }
    if (event == json::parse_event_t::key && !seen.at(d).insert(parsed.get<std::string>()).second)
      twice = parsed.get<std::string>();
    return true;
  };
  json document;
  try {
    document = json::parse(text, watch);
  } catch (const json::exception&) {
    fail("this is not JSON");
  }
  if (!document.is_object()) fail("this is JSON, but not an object");
  if (!twice.empty()) fail(fmt::format("the field \"{}\" appears twice", twice));
  return document;
}

/// The fields of one object. Every one that is read is counted, so that none can stand there unread.
class Fields {
 public:
  Fields(const json& object, std::string name) : object_(object), name_(std::move(name)) {}

  const json& operator[](const char* name) {
    const auto found = object_.find(name);
    if (found == object_.end()) wrong(name, "is missing");
    ++read_;
    return *found;
  }
  [[noreturn]] void wrong(const char* name, const std::string& how) const {
    fail(fmt::format("{}\"{}\" {}", name_, name, how));
  }
  void expect_text(const char* name, const char* expected) {
    const json& value = (*this)[name];
    if (value != expected) wrong(name, fmt::format("must be \"{}\"", expected));
  }
  double number(const char* name) {
    const json& value = (*this)[name];
    if (!is_good(value)) wrong(name, "is not a finite number");
    return value.get<double>();
  }
  /// Three finite numbers.
  RgbD triple(const char* name) {
    const json& value = (*this)[name];
    if (!value.is_array() || value.size() != 3 || !is_good(value[0]) || !is_good(value[1]) || !is_good(value[2]))
      wrong(name, "is not three finite numbers");
    return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
  }
  bool is_null(const char* name) const {
    const auto found = object_.find(name);
    return found != object_.end() && found->is_null();
  }
  void end() const {
    if (object_.size() != read_) fail(name_ + "there are fields that version 1 does not have");
  }

 private:
  static bool is_good(const json& value) { return value.is_number() && std::isfinite(value.get<double>()); }

  const json& object_;
  std::string name_;
  std::size_t read_ = 0;
};

std::optional<RgbD> optional_triple(Fields& fields, const char* name) {
  if (!fields.is_null(name)) return fields.triple(name);
  (void)fields[name];
  return std::nullopt;
}

bool agree(double a, double b) { return std::abs(a - b) <= kAgree * std::max(std::abs(a), std::abs(b)); }

Vec3 direction_of(double azimuth, double elevation) {
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

FileLight parse_light(const json& object, std::size_t index) {
  const std::string name = fmt::format("light {}: ", index);
  if (!object.is_object()) fail(name + "is not an object");
  Fields fields(object, name);
  FileLight light;
  const RgbD direction = fields.triple("direction");
  light.direction = {direction.r, direction.g, direction.b};
  light.half_angle = radians(fields.number("half_angle_deg"));
  light.irradiance = fields.triple("irradiance");
  if (!fields.is_null("share")) {
    light.share = fields.number("share");
  } else {
    (void)fields["share"];
  }
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
    check_light(file.lights[i], fmt::format("light {}: ", i));
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
  const json document = parse(text);
  Fields fields(document, "");
  fields.expect_text("format", kFormat);
  const json& version = fields["version"];
  if (!version.is_number_integer() || version != kVersion) fields.wrong("version", fmt::format("must be {}", kVersion));
  fields.expect_text("frame", kFrame);
  fields.expect_text("azimuth", kAzimuth);
  LightsFile file;
  file.ambient = optional_triple(fields, "ambient_radiance");
  const json& lights = fields["lights"];
  if (!lights.is_array()) fields.wrong("lights", "is not an array");
  if (lights.size() > kMaxLights) fields.wrong("lights", "are more than a file may hold");
  fields.end();
  for (const json& light : lights) file.lights.push_back(parse_light(light, file.lights.size()));
  return file;
}

}  // namespace zonal
