#include "zonal/gl/technique_reference_test.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "zonal/base/check.h"
#include "zonal/gl/fisheye_maps_reference_test.h"
#include "zonal/gl/reference_lookups_test.h"
#include "zonal/light/ambient_reflectance.h"
#include "zonal/light/brdf.h"
#include "zonal/light/dfg.h"
#include "zonal/light/extract.h"
#include "zonal/light/lobe_lean.h"
#include "zonal/light/model.h"
#include "zonal/light/project.h"
#include "zonal/light/reference.h"
#include "zonal/light/resample.h"
#include "zonal/light/synthetic.h"
#include "zonal/sh/ambient_cube.h"
#include "zonal/sh/irradiance.h"
#include "zonal/sh/rotate.h"
#include "zonal/sh/vector_irradiance.h"
#include "zonal/sh/window.h"
#include "zonal/sphere/mapping.h"
#include "zonal/view/homework_lights.h"
#include "zonal/view/own_highlight.h"
#include "zonal/view/paint.h"
#include "zonal/view/reflection_space.h"
#include "zonal/view/view_pictures.h"
#include "zonal/view/view_uniforms.h"

namespace zonal {
namespace {

/// The bump picture's normal in the frame of the surface's texture coordinates: u along the equator, v to the south.
Vec3 bent_normal_of_ball(const SurfacePoint& p, double depth) {
  static const Image<Rgb> picture = bump_picture(kBumpPx);
  const RgbD texel = bilinear(picture, 4 * p.u, 4 * p.v, true, true);
  const double x = 2 * texel.r - 1, y = 2 * texel.g - 1;
  const Vec3 bump = {depth * x, depth * y, std::sqrt(1 - x * x - y * y)};
  const double sine = std::hypot(p.normal.x, p.normal.y);
  const Vec3 east = normalize(cross({0, 0, 1}, p.normal)), south = cross(east, p.normal);
  // The gradients of u and v are as 1/(2 sin theta) to 1; the longer one counts as a unit.
  const double longest = std::max(1 / (2 * sine), 1.0);
  return normalize(bump.x / (2 * sine * longest) * east + bump.y / longest * south + bump.z * p.normal);
}

PointLight lambert(const Sh<RgbD>& radiance, const ViewState& state) {
  const ExtractedLights found = extract_lights(radiance, {.lights = 1, .refine = true});
  const double albedo = state.value("albedo"), alpha = alpha_from_roughness(state.value("roughness"));
  const int ambient = static_cast<int>(state.value("ambient_light"));
  const double f0 = state.value("f0"), shininess = state.value("shininess");
  const Brdf brdfs[] = {lambert_brdf({1, 1, 1}), phong_brdf(shininess), blinn_phong_brdf(shininess),
                        ggx_brdf(alpha, {f0, f0, f0})};
  const int kind = static_cast<int>(state.value("ambient_brdf"));
  const double scale = kind == 0 ? albedo : kind == 3 ? 1 : f0;  // the last knows Fresnel's term by itself
  return [=, brdf = brdfs[kind], in_light = into_light(state)](const SurfacePoint& p) {
    const ExtractedLight& light = found.lights.at(0);
    const RgbD direct = albedo / kPi * std::max(0.0, dot(in_light(p.normal), light.direction)) * light.irradiance;
    if (ambient == 0) return direct;
    if (ambient == 1) return direct + albedo * found.ambient;
    const double cosine = std::clamp(dot(p.normal, p.toward_eye), 1e-3, 1.0);
    const Reflectance part = ambient_reflectance(brdf, cosine, 1e-4);
    return direct + scale * part.value * found.ambient;
  };
}

PointLight sphere_map(const Environment& panorama, const ViewState& state) {
  const auto map = lookup(resample(panorama, {Layout::kSphereMap}, 2 * small_view_data().cube_px));
  if (state.value("viewpoint") == 1) return of_mirrored(state, map);
  const auto axes = camera_matrices(state.camera, 1).eye_from_world;
  const auto row = [axes](std::size_t i) { return Vec3{axes[i], axes[3 + i], axes[6 + i]}; };
  return [=](const SurfacePoint& p) {
    const Vec3 n = {dot(row(0), p.normal), dot(row(1), p.normal), dot(row(2), p.normal)};
    const Vec3 r = 2 * n.z * n - Vec3{0, 0, 1};  // right, up, toward the camera, which looks along +X of the map
    return map({-r.z, -r.x, r.y});
  };
}

/// A lamp of the sliders' size in the direction of the brightest light; as one point in its middle, or all of it.
PointLight lamp(const Sh<RgbD>& radiance, const ViewState& state, bool exact) {
  const ExtractedLight light = extract_lights(radiance, {.lights = 1, .refine = true}).lights.at(0);
  const double distance = state.value("lamp_distance"), radius = state.value("lamp_radius");
  const bool ball = state.value("lamp_shape") == 0;
  const RgbD glow = distance * distance / (kPi * radius * radius) * light.irradiance;
  const Vec3 center = distance * light.direction;
  const Vec3 side =
      normalize(cross(std::abs(light.direction.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}, light.direction));
  const Vec3 up = cross(light.direction, side);
  return [=, albedo = state.value("albedo"), in_light = into_light(state)](const SurfacePoint& p) {
    const Vec3 position = in_light(p.position), n = in_light(p.normal), to = center - position;
    const double away = length(to), cosine = std::max(0.0, dot(n, to) / away), area = kPi * radius * radius;
    double e = 0;
    if (!exact) {
      e = area / (away * away) * cosine * (ball ? 1 : std::max(0.0, dot(light.direction, to) / away));
    } else if (ball) {
      e = cone_irradiance(std::asin(radius / away), angle_between(n, normalize(to)));
    } else {  // small squares of the square, whatever of them is above the horizon
      constexpr int kParts = 150;
      const double half_width = 0.5 * std::sqrt(area);
      for (int i = 0; i < kParts; ++i) {
        for (int j = 0; j < kParts; ++j) {
          const double a = half_width * ((2 * i + 1.0) / kParts - 1), b = half_width * ((2 * j + 1.0) / kParts - 1);
          const Vec3 part = to + a * side + b * up;
          const double square = dot(part, part);
          e += std::max(0.0, dot(n, part)) * dot(light.direction, part) / (square * square) * area / (kParts * kParts);
        }
      }
    }
    return albedo / kPi * e * glow;
  };
}

/// A surface's GGX lobe over the texels of a small panorama, in double; and the same over a white one.
struct Glossy {
  RgbD lit, white;
};
Glossy glossy(const std::vector<LitTexel>& texels, const Brdf& brdf, Vec3 n, Vec3 v) {
  // The BRDF knows a surface whose normal is +Z, seen from the half plane y = 0.
  const double cosine = dot(n, v);
  const Vec3 beside = v - cosine * n, any = cross(n, std::abs(n.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0});
  const Vec3 x = normalize(length(beside) > 1e-9 ? beside : any), y = cross(n, x), viewer = {dot(v, x), 0, cosine};
  Glossy sum;
  for (const LitTexel& texel : texels) {
    const Vec3 l = {dot(texel.toward, x), dot(texel.toward, y), dot(texel.toward, n)};
    if (l.z <= 0 || cosine <= 0) continue;
    const RgbD weight = l.z * texel.solid_angle * brdf(l, viewer);
    sum.white += weight;
    sum.lit += weight * texel.radiance;
  }
  return sum;
}

RgbD over(RgbD a, RgbD b) { return {a.r / b.r, a.g / b.g, a.b / b.b}; }

/// The four maps around the eye's place in the square of eyes, each summed anew for this mean direction, at a roughness
/// that there are maps for.
PointLight reflection_space(const Environment& panorama, const ViewState& state) {
  const ReflectionSpaceOptions options;
  const std::vector<LitTexel> texels = texels_of(resample(panorama, {Layout::kEquirect}, options.environment_rows));
  const double alpha = alpha_from_roughness(state.value("roughness")), f0 = state.value("f0");
  const std::function<RgbD(Vec3)> split_sum = through(panorama, Lobe::ggx(alpha));
  const bool nearest = state.value("reflection_by") == 1;
  return [=, brdf = ggx_brdf(alpha), leaning = LobeLean(alpha), square = Mapping({Layout::kOctahedral}, {1, 1}),
          in_light = into_light(state)](const SurfacePoint& p) {
    const int last = options.views - 1;
    const PixelPoint place = *square.position(in_light(p.toward_eye));
    const Vec3 m = leaning.mean(in_light(p.toward_eye), in_light(p.normal));
    const double x = last * place.x, y = last * place.y;
    const int x0 = std::min(static_cast<int>(x), last - 1), y0 = std::min(static_cast<int>(y), last - 1);
    RgbD mean;
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i < 2; ++i) {
        double weight = (i == 1 ? x - x0 : 1 - (x - x0)) * (j == 1 ? y - y0 : 1 - (y - y0));
        if (nearest) weight = std::lround(x) == x0 + i && std::lround(y) == y0 + j ? 1 : 0;
        if (weight == 0) continue;
        const Vec3 v = *square.direction({(x0 + i) / (1.0 * last), (y0 + j) / (1.0 * last)});
        const Glossy sum = glossy(texels, brdf, leaning.normal(v, m), v);
        mean += weight / sum.white.g * sum.lit;
      }
    }
    const double cosine = std::clamp(dot(p.normal, p.toward_eye), 1e-3, 1.0);
    const SplitSum split = ggx_split_sum(cosine, alpha);
    const Glossy above = glossy(texels, brdf, m, m);
    return (f0 * split.scale + split.bias) * split_sum(m) * over(above.white.g * mean, above.lit);
  };
}

PointLight harmonics(const Sh<RgbD>& radiance, const ViewState& state) {
  const int bands = static_cast<int>(state.value("bands")), kind = static_cast<int>(state.value("window_kind"));
  const double strength = state.value("window_strength");
  Sh<RgbD> matte = with_bands(irradiance_over_pi(radiance), bands);
  if (kind == 1) matte = window(matte, Window::hann(3 / strength));
  if (kind == 2) matte = window(matte, Window::lanczos(3 / strength));
  if (kind == 3) matte = window(matte, Window::laplacian(0.05 * strength * strength * strength));
  // The coefficients are turned, where the shader turns the normal.
  matte = rotate(matte, light_rotation(state));
  return [matte, albedo = state.value("albedo")](const SurfacePoint& p) { return albedo * evaluate(matte, p.normal); };
}

}  // namespace

Environment lopsided_environment(int rows) {
  const ImageSize size = image_size(Layout::kEquirect, rows);
  Environment card = testcard({Layout::kEquirect}, size);
  const Vec3 lamp = normalize({0.6, -0.5, 0.4});
  const Environment slope = paint({Layout::kEquirect}, size, [&](Vec3 d) {
    const float base = static_cast<float>(0.5 + 0.2 * d.x + 0.15 * d.y - 0.1 * d.z);
    return dot(d, lamp) > 0.96 ? Rgb{12, 8, 4} : Rgb{base, base, 1.1f * base};
  });
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) card.radiance(x, y) += slope.radiance(x, y);
  }
  return card;
}

Image<Rgb> painted_highlight() {
  Stroke first(Image<Rgb>(kOwnHighlightPx, kOwnHighlightPx), {.radius = 0.2, .light = {3, 1, 0.2f}});
  first.move_to(0.2, 0.3);
  first.move_to(0.6, 0.2);
  Stroke second(first.picture(), {.radius = 0.1, .light = {0, 0.5f, 2}});
  second.move_to(0.4, 0.25);
  second.move_to(0.7, 0.8);
  return second.picture();
}

ViewDataOptions small_view_data() {
  return {.panorama_px = 64, .cube_px = 32, .chain_px = 64, .irradiance_px = 32, .sky_px = 16, .reference_rows = 16};
}

PointLight technique_reference(const Environment& panorama, const ViewState& state) {
  const std::string_view id = state.technique->id;
  const ViewDataOptions sizes = small_view_data();
  const Sh<RgbD> radiance = project(panorama, 6);
  const Sh<RgbD> matte = irradiance_over_pi(radiance);
  const double albedo = state.value("albedo");
  if (id == "lambert") return lambert(radiance, state);
  if (id == "blinn-newell") return of_mirrored(state, lookup(panorama));
  if (id == "sphere-map") return sphere_map(panorama, state);
  if (id == "cube-map") return of_mirrored(state, lookup(resample(panorama, {Layout::kCubeStack}, sizes.cube_px)));
  if (id == "dual-paraboloid") {
    return of_mirrored(state, lookup(resample(panorama, {Layout::kDualParaboloid}, 2 * sizes.cube_px)));
  }
  if (id == "bump") {
    const int map = static_cast<int>(state.value("bump_lookup"));
    const PointLight mirror =
        map == 0   ? of_mirrored(state, lookup(panorama))
        : map == 1 ? of_mirrored(state, lookup(resample(panorama, {Layout::kCubeStack}, sizes.cube_px)))
        : map == 2 ? of_mirrored(state, lookup(resample(panorama, {Layout::kDualParaboloid}, 2 * sizes.cube_px)))
                   : of_mirrored(state, lookup(resample(panorama, {Layout::kSphereMap}, 2 * sizes.cube_px)));
    return [mirror, depth = state.value("bump_depth")](SurfacePoint p) {
      p.normal = bent_normal_of_ball(p, depth);
      return mirror(p);
    };
  }
  if (id == "near-lamp") return lamp(radiance, state, false);
  if (id == "reflection-space") return reflection_space(panorama, state);
  if (id == "homework") {
    const auto light = homework_lights()[static_cast<std::size_t>(state.value("light_set")) - 1];
    double sum = 0;
    for (const HomeworkLight& one : homework_lights()) sum += luminance(RgbD(homework_radiance(one)(0, 0)));
    const double scale = luminance(radiance(0, 0)) / (sum / 10);
    return of_normal(
        state, [e = irradiance(homework_radiance(light)), scale](Vec3 n) { return scale * evaluate(e, n); },
        albedo / kPi);
  }
  if (id == "highlight-map") {
    const auto axes = camera_matrices(state.camera, 1).eye_from_world;
    const double source = state.value("highlight_source");
    const RgbD mean = mean_radiance(radiance);
    Image<Rgb> picture = source == 0   ? highlight_picture(64, mean)
                         : source == 1 ? drawn_highlight(64, mean)
                                       : painted_highlight();
    if (source == 2) {
      for (Rgb& value : picture.values()) value = static_cast<float>(kOwnHighlight * luminance(mean)) * value;
    }
    const PointLight base = of_normal(state, through(panorama, Lobe::cosine()), albedo);
    return [=, strength = state.value("highlight_strength")](const SurfacePoint& p) {
      const double x = axes[0] * p.normal.x + axes[3] * p.normal.y + axes[6] * p.normal.z;
      const double y = axes[1] * p.normal.x + axes[4] * p.normal.y + axes[7] * p.normal.z;
      return base(p) + strength * bilinear(picture, 0.5 + 0.5 * x, 0.5 - 0.5 * y, false, false);
    };
  }
  if (id == "uniform-blur") {
    const auto levels = halved_pictures(panorama.radiance);
    const Image<Rgb> level = levels.at(static_cast<std::size_t>(state.value("blur_level")));
    return of_mirrored(state, [level](Vec3 d) {
      const auto [u, v] = on_panorama(d);
      return bilinear(level, u, v, true, false);
    });
  }
  if (id == "phong") return of_mirrored(state, through(panorama, Lobe::phong(state.value("shininess"))));
  if (id == "split-sum") {
    const double roughness = state.value("roughness"), f0 = state.value("f0");
    const PointLight mean = of_mirrored(state, through(panorama, lobe_for_roughness(LobeKind::kGgx, roughness)));
    return [=](const SurfacePoint& p) {
      const double cosine = std::clamp(dot(p.normal, p.toward_eye), 1e-3, 1.0);
      const SplitSum split = ggx_split_sum(cosine, alpha_from_roughness(roughness));
      return (f0 * split.scale + split.bias) * mean(p);
    };
  }
  if (id == "fisheye-maps") return fisheye_maps_reference(panorama, state);
  if (id == "irradiance-map") return of_normal(state, through(panorama, Lobe::cosine()), albedo);
  if (id == "vector-irradiance") {
    if (state.value("vector_back") == 1) {
      return of_normal(
          state, [two = with_bands<2>(matte)](Vec3 n) { return evaluate(two, n); }, albedo);
    }
    const auto vectors = vector_irradiance(radiance);
    return of_normal(
        state,
        [vectors](Vec3 n) {
          return RgbD(irradiance_from_vector(vectors[0], n), irradiance_from_vector(vectors[1], n),
                      irradiance_from_vector(vectors[2], n));
        },
        albedo / kPi);
  }
  if (id == "sh-bands") return harmonics(radiance, state);
  if (id == "sh-polynomial" || id == "sh-constants") {
    return of_normal(
        state, [three = with_bands<3>(matte)](Vec3 n) { return evaluate(three, n); }, albedo);
  }
  if (id == "extracted-lights") {
    const int count = static_cast<int>(state.value("light_count"));
    const ExtractedLights found = extract_lights(radiance, {.lights = count, .refine = true});
    return of_normal(
        state,
        [found](Vec3 n) {
          RgbD e = kPi * found.ambient;
          for (const ExtractedLight& light : found.lights)
            e += std::max(0.0, dot(n, light.direction)) * light.irradiance;
          return e;
        },
        albedo / kPi);
  }
  if (id == "ambient-cube") {
    return of_normal(
        state, [cube = ambient_cube(matte)](Vec3 n) { return evaluate(cube, n); }, albedo);
  }
  check(false, "every technique has a reference");
  return {};
}

PointLight exact_reference(const Environment& panorama, const ViewState& state) {
  switch (state.technique->exact) {
    case Exact::kDiffuse:
      return of_normal(state, through(panorama, Lobe::cosine()), state.value("albedo"));
    case Exact::kMirror:
      return of_mirrored(state, lookup(panorama));
    case Exact::kBentMirror: {
      ViewState normals = state;
      normals.set("bump_source", 0);
      normals.set("bump_lookup", 0);
      return technique_reference(panorama, normals);
    }
    case Exact::kLamp:
      return lamp(project(panorama, 6), state, true);
    case Exact::kNine:
      return technique_reference(panorama, state);
    case Exact::kSkyMap:
      if (state.value("sky_map") == 0)
        return of_normal(state, through(panorama, Lobe::cosine()), state.value("albedo"));
      [[fallthrough]];
    case Exact::kPhong: {
      const Environment small = resample(panorama, {Layout::kEquirect}, small_view_data().reference_rows);
      return of_mirrored(state, [small, shininess = state.value("shininess")](Vec3 d) {
        return convolve_at(small, Lobe::phong(shininess), std::array{d})[0];
      });
    }
    case Exact::kGlossy:
      break;
  }
  const double f0 = state.value("f0"), roughness = state.value("roughness");
  const Brdf brdf = ggx_brdf(alpha_from_roughness(roughness), {f0, f0, f0});
  const auto texels = texels_of(resample(panorama, {Layout::kEquirect}, small_view_data().reference_rows));
  return [=, in_light = into_light(state)](const SurfacePoint& p) {
    return glossy(texels, brdf, in_light(p.normal), in_light(p.toward_eye)).lit;
  };
}

}  // namespace zonal
