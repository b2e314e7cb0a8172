#include "apps/zonal/light_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/zonal/choices.h"
#include "apps/zonal/numbers.h"
#include "zonal/base/error.h"
#include "zonal/light/model.h"
#include "zonal/light/model_daylight.h"
#include "zonal/light/model_polygon.h"
#include "zonal/light/normalise.h"

namespace zonal {
namespace {

constexpr Vec3 kUp = {0, 0, 1};

/// A light as its shape in a colour, so that a colour can be what the normalised light is multiplied by. Lights of
/// several colours are their own shape, and white.
struct Shaped {
  Sh<RgbD> shape;
  RgbD color = {1, 1, 1};
  Vec3 facing = kUp;  ///< normal of the surface that is turned toward it
};

Vec3 vector_in(const std::string& text, const char* option) {
  const std::vector<double> v = numbers_in(text, 3, 3, option);
  return {v[0], v[1], v[2]};
}

/// In double, so that 0.1 stays 0.1 in a file of coefficients. White if nothing is said.
RgbD white_or(const std::string& text, const char* option) {
  if (text.empty()) return {1, 1, 1};
  color_in(text, option);  // one number or three, in the words of every verb
  const std::vector<double> v = numbers_in(text, 1, 3, option);
  return v.size() == 1 ? RgbD{v[0], v[0], v[0]} : RgbD{v[0], v[1], v[2]};
}

Vec3 direction_in(const LightOptions& o) {
  if (!o.toward.empty()) {
    if (o.azimuth_deg || o.elevation_deg) {
      throw Error(ErrorKind::kUsage, "--toward and --azimuth, --elevation both say where the light is",
                  "leave out one of them");
    }
    return vector_in(o.toward, "--toward");
  }
  if (!o.azimuth_deg && !o.elevation_deg) return kUp;
  const double azimuth = radians(o.azimuth_deg.value_or(0)), elevation = radians(o.elevation_deg.value_or(0));
  const double level = std::cos(elevation);
  return {level * std::cos(azimuth), level * std::sin(azimuth), std::sin(elevation)};
}

double half_angle_in(const LightOptions& o) {
  if (!o.half_angle_deg) {
    throw Error(ErrorKind::kUsage, fmt::format("a {} needs --half-angle", o.shape), "in degrees, as in --half-angle 5");
  }
  // 180 degrees must not round to more than pi.
  return *o.half_angle_deg <= 180 ? std::min(radians(*o.half_angle_deg), kPi) : radians(*o.half_angle_deg);
}

Shaped directional(const LightOptions& o, const Run&) {
  const Vec3 toward = direction_in(o);
  return {directional_sh(toward, {1, 1, 1}, o.bands), white_or(o.irradiance, "--irradiance"), toward};
}

Shaped cone(const LightOptions& o, const Run&) {
  const Vec3 toward = direction_in(o);
  return {cone_sh(toward, half_angle_in(o), {1, 1, 1}, o.bands), white_or(o.radiance, "--radiance"), toward};
}

Shaped smooth_cone(const LightOptions& o, const Run&) {
  const Vec3 toward = direction_in(o);
  return {smooth_cone_sh(toward, half_angle_in(o), {1, 1, 1}, o.bands), white_or(o.radiance, "--radiance"), toward};
}

Shaped sphere(const LightOptions& o, const Run&) {
  if (o.center.empty() || !o.radius) {
    throw Error(ErrorKind::kUsage, "a sphere needs --center and --radius",
                "as in --center 0,0,3 --radius 1, the lit point being the origin");
  }
  const Vec3 center = vector_in(o.center, "--center");
  return {sphere_sh(center, *o.radius, {1, 1, 1}, o.bands), white_or(o.radiance, "--radiance"),
          center == Vec3{} ? kUp : center};  // around its centre it is the same everywhere
}

Shaped hemisphere(const LightOptions& o, const Run&) {
  const Vec3 up = direction_in(o);
  const RgbD ground = o.ground.empty() ? RgbD{} : white_or(o.ground, "--ground");
  return {hemisphere_sh(up, white_or(o.radiance, "--radiance"), ground, o.bands), {1, 1, 1}, up};
}

Shaped polygon(const LightOptions& o, const Run&) {
  std::vector<Vec3> vertices;
  for (const std::string& vertex : o.vertices) vertices.push_back(vector_in(vertex, "--vertex"));
  if (vertices.size() < 3) {
    throw Error(ErrorKind::kUsage, "a polygon needs --vertex three times or more",
                "as in --vertex -1,-1,2 --vertex 1,-1,2 --vertex 0,1,2, the lit point being the origin");
  }
  // A surface is turned toward it when it faces its vector irradiance, which band 1 holds.
  const Sh<RgbD> vector = polygon_sh(vertices, {1, 1, 1}, 2);
  return {polygon_sh(vertices, {1, 1, 1}, o.bands),
          white_or(o.radiance, "--radiance"),
          {vector(1, 1).g, vector(1, -1).g, vector(1, 0).g}};
}

Shaped ambient(const LightOptions& o, const Run&) {
  return {ambient_sh({1, 1, 1}, o.bands), white_or(o.radiance, "--radiance"), kUp};
}

Shaped sky(const LightOptions& o, const Run& run) {
  DaylightOptions daylight;
  if (!o.toward.empty()) {
    const Vec3 toward = direction_in(o);
    daylight.azimuth_deg = degrees(std::atan2(toward.y, toward.x));
    daylight.elevation_deg = degrees(std::atan2(toward.z, std::hypot(toward.x, toward.y)));
  }
  if (o.elevation_deg) daylight.elevation_deg = *o.elevation_deg;
  if (o.azimuth_deg) daylight.azimuth_deg = *o.azimuth_deg;
  if (o.turbidity) daylight.turbidity = *o.turbidity;
  if (!o.albedo.empty()) daylight.ground_albedo = color_in(o.albedo, "--albedo");
  daylight.sun = !o.no_sun;
  return {daylight_sh(daylight, o.bands, run), {1, 1, 1}, kUp};
}

struct Shape {
  std::string_view name;
  Shaped (*make)(const LightOptions&, const Run&);
  std::string_view options;  ///< that it has, each before a space
};

constexpr Shape kShapes[] = {
    {"directional", directional, "--toward --azimuth --elevation --irradiance "},
    {"cone", cone, "--toward --azimuth --elevation --half-angle --radiance "},
    {"smooth-cone", smooth_cone, "--toward --azimuth --elevation --half-angle --radiance "},
    {"sphere", sphere, "--center --radius --radiance "},
    {"hemisphere", hemisphere, "--toward --azimuth --elevation --radiance --ground "},
    {"polygon", polygon, "--vertex --radiance "},
    {"ambient", ambient, "--radiance "},
    {"sky", sky, "--toward --azimuth --elevation --turbidity --albedo --no-sun "},
};

void check_options(const LightOptions& o, const Shape& shape) {
  const std::pair<bool, std::string> given[] = {{!o.toward.empty(), "--toward"},
                                                {o.azimuth_deg.has_value(), "--azimuth"},
                                                {o.elevation_deg.has_value(), "--elevation"},
                                                {o.half_angle_deg.has_value(), "--half-angle"},
                                                {!o.center.empty(), "--center"},
                                                {o.radius.has_value(), "--radius"},
                                                {!o.vertices.empty(), "--vertex"},
                                                {!o.irradiance.empty(), "--irradiance"},
                                                {!o.radiance.empty(), "--radiance"},
                                                {!o.ground.empty(), "--ground"},
                                                {o.turbidity.has_value(), "--turbidity"},
                                                {!o.albedo.empty(), "--albedo"},
                                                {o.no_sun, "--no-sun"}};
  for (const auto& [is_given, option] : given) {
    if (!is_given || shape.options.find(option + " ") != std::string_view::npos) continue;
    throw Error(ErrorKind::kUsage, fmt::format("the light {} has no {}", shape.name, option),
                fmt::format("it has {}", shape.options.substr(0, shape.options.size() - 1)));
  }
}

}  // namespace

std::string light_shape_names() {
  return names_of(kShapes, [](const Shape& s) { return std::string(s.name); });
}

Light light_of(const LightOptions& options, const Run& run) {
  const auto* shape = std::find_if(std::begin(kShapes), std::end(kShapes),
                                   [&](const Shape& candidate) { return candidate.name == options.shape; });
  if (shape == std::end(kShapes)) {
    throw Error(ErrorKind::kUsage, "there is no light '" + options.shape + "'", "say " + light_shape_names());
  }
  check_options(options, *shape);
  Shaped shaped = shape->make(options, run);
  Light light;
  if (options.normalise) {
    Sh<double> grey(options.bands);
    for (std::size_t i = 0; i < grey.size(); ++i) grey[i] = luminance(shaped.shape[i]);
    light.normalising_factor = normalising_factor(grey, shaped.facing);
  }
  for (RgbD& value : shaped.shape.values()) value = (light.normalising_factor * shaped.color) * value;
  light.radiance = std::move(shaped.shape);
  return light;
}

}  // namespace zonal
