#include "zonal/gl/technique_reference_test.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "zonal/base/check.h"
#include "zonal/light/ambient_reflectance.h"
#include "zonal/light/brdf.h"
#include "zonal/light/dfg.h"
#include "zonal/light/extract.h"
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
#include "zonal/view/view_pictures.h"
#include "zonal/view/view_uniforms.h"

namespace zonal {
namespace {

Vec3 mirrored(const SurfacePoint& p) { return 2 * dot(p.normal, p.toward_eye) * p.normal - p.toward_eye; }

/// The light turned, as the library turns pictures: what it has at d is what the panorama has at the result.
std::function<Vec3(Vec3)> into_light(const ViewState& state) {
  const Rotation light_from_world = Rotation::about_z(-radians(state.value("light_yaw_deg")));
  return [light_from_world](Vec3 d) { return light_from_world * d; };
}

/// Between the four texels around the place of a direction, across the edges of faces and discs. Where the library's
/// own Sampler finds better weights (at poles and rims) hardware does not.
std::function<RgbD(Vec3)> lookup(Environment environment) {
  const Mapping mapping(environment.projection, {environment.radiance.width(), environment.radiance.height()});
  return [picture = std::move(environment.radiance), mapping](Vec3 d) {
    const PixelPoint p = *mapping.position(d);
    const int chart = mapping.chart(p), x0 = static_cast<int>(std::floor(p.x - 0.5)),
              y0 = static_cast<int>(std::floor(p.y - 0.5));
    const double x = p.x - 0.5 - x0, y = p.y - 0.5 - y0;
    RgbD sum;
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i < 2; ++i) {
        const auto texel = mapping.wrap(chart, x0 + i, y0 + j);
        sum += ((i == 1 ? x : 1 - x) * (j == 1 ? y : 1 - y)) * RgbD(picture(texel.x, texel.y));
      }
    }
    return sum;
  };
}

/// Between the four nearest texels of a flat picture; (0, 0) is its top left corner, (1, 1) the opposite one.
RgbD bilinear(const Image<Rgb>& image, double u, double v, bool repeats_x, bool repeats_y) {
  const auto place = [](int i, int size, bool repeats) {
    return repeats ? ((i % size) + size) % size : std::clamp(i, 0, size - 1);
  };
  const double x = u * image.width() - 0.5, y = v * image.height() - 0.5;
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  RgbD sum;
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < 2; ++i) {
      const double weight = (i == 1 ? x - x0 : 1 - (x - x0)) * (j == 1 ? y - y0 : 1 - (y - y0));
      sum += weight * RgbD(image(place(x0 + i, image.width(), repeats_x), place(y0 + j, image.height(), repeats_y)));
    }
  }
  return sum;
}

/// Where a panorama shows a direction, both 0..1.
std::array<double, 2> on_panorama(Vec3 d) {
  const Mapping mapping({Layout::kEquirect}, {2, 1});
  const PixelPoint p = *mapping.position(d);
  return {p.x / 2, p.y};
}

/// The sums over a small panorama: its texels as directions with solid angles.
struct LitTexel {
  Vec3 toward;
  double solid_angle;
  RgbD radiance;
};
std::vector<LitTexel> texels_of(const Environment& environment) {
  const Image<Rgb>& image = environment.radiance;
  const Mapping mapping(environment.projection, {image.width(), image.height()});
  std::vector<LitTexel> texels;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      texels.push_back({*mapping.texel_direction(x, y), mapping.solid_angle(x, y), RgbD(image(x, y))});
    }
  }
  return texels;
}

/// The bump picture's normal in the frame of the surface's texture coordinates: u along the equator, v to the south.
Vec3 bent_normal_of_ball(const SurfacePoint& p, double depth) {
  static const Image<Rgb> picture = bump_normals(128);
  const RgbD texel = bilinear(picture, 4 * p.u, 4 * p.v, true, true);
  const Vec3 bump = {depth * (2 * texel.r - 1), depth * (2 * texel.g - 1), 2 * texel.b - 1};
  const double sine = std::hypot(p.normal.x, p.normal.y);
  const Vec3 east = normalize(cross({0, 0, 1}, p.normal)), south = cross(east, p.normal);
  // The gradients of u and v are as 1/(2 sin theta) to 1; the longer one counts as a unit.
  const double longest = std::max(1 / (2 * sine), 1.0);
  return normalize(bump.x / (2 * sine * longest) * east + bump.y / longest * south + bump.z * p.normal);
}

PointLight of_normal(const ViewState& state, std::function<RgbD(Vec3)> light, double scale) {
  return [in_light = into_light(state), light = std::move(light), scale](const SurfacePoint& p) {
    return scale * light(in_light(p.normal));
  };
}

PointLight of_mirrored(const ViewState& state, std::function<RgbD(Vec3)> light) {
  return [in_light = into_light(state), light = std::move(light)](const SurfacePoint& p) {
    return light(in_light(mirrored(p)));
  };
}

/// The mean through a lobe, summed over all texels of the panorama.
std::function<RgbD(Vec3)> through(const Environment& panorama, const Lobe& lobe) {
  return [&panorama, lobe](Vec3 d) { return convolve_at(panorama, lobe, std::array{d})[0]; };
}

PointLight lambert(const Sh<RgbD>& radiance, const ViewState& state) {
  const ExtractedLights found = extract_lights(radiance, {.lights = 1, .refine = true});
  const double albedo = state.value("albedo"), alpha = alpha_from_roughness(state.value("roughness"));
  const int ambient = static_cast<int>(state.value("ambient_light"));
  const double f0 = state.value("f0");
  return [=, in_light = into_light(state)](const SurfacePoint& p) {
    const ExtractedLight& light = found.lights.at(0);
    const RgbD direct = albedo / kPi * std::max(0.0, dot(in_light(p.normal), light.direction)) * light.irradiance;
    if (ambient == 0) return direct;
    if (ambient == 1) return direct + albedo * found.ambient;
    const double cosine = std::clamp(dot(p.normal, p.toward_eye), 1e-3, 1.0);
    return direct + ambient_reflectance(ggx_brdf(alpha, {f0, f0, f0}), cosine, 1e-4).value * found.ambient;
  };
}

PointLight sphere_map(const Environment& panorama, const ViewState& state) {
  const auto map = lookup(resample(panorama, {Layout::kSphereMap}, 2 * small_view_data().cube_px));
  if (state.value("viewpoint") == 1) return of_mirrored(state, map);
  const auto axes = camera_matrices(state.camera, 1).eye_from_world;
  const auto row = [axes](std::size_t i) { return Vec3{axes[i], axes[3 + i], axes[6 + i]}; };
  return [=](const SurfacePoint& p) {
    const Vec3 n = {dot(row(0), p.normal), dot(row(1), p.normal), dot(row(2), p.normal)};
    const Vec3 r = 2 * n.z * n - Vec3{0, 0, 1};    // right, up, toward the camera, which looks along +X of the map
    return map({-r.z, -r.x, r.y});
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
  matte = rotate(matte, Rotation::about_z(radians(state.value("light_yaw_deg"))));
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

ViewDataOptions small_view_data() {
  return {.panorama_px = 64, .cube_px = 32, .chain_px = 64, .irradiance_px = 32, .reference_rows = 16};
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
    return [mirror = of_mirrored(state, lookup(panorama)), depth = state.value("bump_depth")](SurfacePoint p) {
      p.normal = bent_normal_of_ball(p, depth);
      return mirror(p);
    };
  }
  if (id == "highlight-map") {
    const auto axes = camera_matrices(state.camera, 1).eye_from_world;
    const Image<Rgb> picture = highlight_picture(64, mean_radiance(radiance));
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
  if (id == "irradiance-map") return of_normal(state, through(panorama, Lobe::cosine()), albedo);
  if (id == "vector-irradiance") {
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
    return of_normal(state, [three = with_bands<3>(matte)](Vec3 n) { return evaluate(three, n); }, albedo);
  }
  if (id == "extracted-lights") {
    const int count = static_cast<int>(state.value("light_count"));
    const ExtractedLights found = extract_lights(radiance, {.lights = count, .refine = true});
    return of_normal(
        state,
        [found](Vec3 n) {
          RgbD e = kPi * found.ambient;
          for (const ExtractedLight& light : found.lights) e += std::max(0.0, dot(n, light.direction)) * light.irradiance;
          return e;
        },
        albedo / kPi);
  }
  if (id == "ambient-cube") {
    return of_normal(state, [cube = ambient_cube(matte)](Vec3 n) { return evaluate(cube, n); }, albedo);
  }
  check(false, "every technique has a reference");
  return {};
}

PointLight exact_reference(const Environment& panorama, const ViewState& state) {
  const Environment small = resample(panorama, {Layout::kEquirect}, small_view_data().reference_rows);
  switch (state.technique->exact) {
    case Exact::kDiffuse:
      return of_normal(state, through(panorama, Lobe::cosine()), state.value("albedo"));
    case Exact::kMirror:
      return of_mirrored(state, lookup(panorama));
    case Exact::kPhong:
      return of_mirrored(state, [small, shininess = state.value("shininess")](Vec3 d) {
        return convolve_at(small, Lobe::phong(shininess), std::array{d})[0];
      });
    case Exact::kGlossy:
      break;
  }
  const double f0 = state.value("f0");
  const Brdf brdf = ggx_brdf(alpha_from_roughness(state.value("roughness")), {f0, f0, f0});
  return [=, texels = texels_of(small), in_light = into_light(state)](const SurfacePoint& p) {
    // The BRDF knows a surface whose normal is +Z, seen from the half plane y = 0.
    const Vec3 n = in_light(p.normal), v = in_light(p.toward_eye);
    const double cosine = dot(n, v);
    const Vec3 x = normalize(v - cosine * n), y = cross(n, x);
    const Vec3 viewer = {dot(v, x), 0, cosine};
    RgbD sum;
    for (const LitTexel& texel : texels) {
      const Vec3 l = {dot(texel.toward, x), dot(texel.toward, y), dot(texel.toward, n)};
      if (l.z > 0 && cosine > 0) sum += l.z * texel.solid_angle * (brdf(l, viewer) * texel.radiance);
    }
    return sum;
  };
}

}  // namespace zonal
