#pragma once

// For tests: one of every kind of picture, and points spread over pictures and the sphere.

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "zonal/sphere/mapping.h"

namespace zonal {

/// A projection of every layout, the fisheyes with every lens model and several fields of view, off-centre and elliptic
/// too. `natural` is the natural size of the pictures.
struct Example {
  std::string name;
  Projection projection;
  ImageSize size;
};

inline std::vector<Example> every_projection(int natural) {
  std::vector<Example> examples;
  const auto add = [&](const std::string& suffix, const Projection& projection) {
    std::string name(name_of(projection.layout));
    name.append(suffix).append(" ").append(std::to_string(natural));
    examples.push_back({name, projection, image_size(projection.layout, natural)});
  };
  const auto add_lens = [&](Layout layout, LensModel model, double fov_deg) {
    std::string suffix(" ");
    suffix.append(name_of(model)).append(" ").append(std::to_string(static_cast<int>(fov_deg)));
    add(suffix, {layout, {model, fov_deg}});
  };
  for (const Layout layout : all_layouts()) {
    if (layout != Layout::kFisheye && layout != Layout::kDualFisheye) add("", {layout});
  }
  for (const LensModel model : {LensModel::kEquidistant, LensModel::kEquisolid, LensModel::kStereographic}) {
    for (const double fov_deg : {120.0, 180.0, 235.0}) add_lens(Layout::kFisheye, model, fov_deg);
    for (const double fov_deg : {180.0, 200.0}) add_lens(Layout::kDualFisheye, model, fov_deg);
  }
  add_lens(Layout::kFisheye, LensModel::kEquidistant, 360);
  add_lens(Layout::kFisheye, LensModel::kEquisolid, 360);
  add_lens(Layout::kFisheye, LensModel::kStereographic, 340);
  add_lens(Layout::kFisheye, LensModel::kOrthographic, 150);
  add_lens(Layout::kFisheye, LensModel::kOrthographic, 180);
  add_lens(Layout::kDualFisheye, LensModel::kOrthographic, 180);
  if (natural < 3) return examples;  // too small to hold a circle beside its centre
  const double n = natural;
  add(" off centre", {Layout::kFisheye, {LensModel::kEquidistant, 180, 0.45 * n, 0.53 * n, 0.41 * n}});
  // A circle in a picture that is no square.
  for (const Layout layout : {Layout::kMirrorBall, Layout::kSphereMap, Layout::kAngular}) {
    examples.push_back({std::string(name_of(layout)) + " placed " + std::to_string(natural),
                        {layout, {.center_x_px = 0.7 * n, .center_y_px = 0.55 * n, .radius_x_px = 0.43 * n}},
                        {natural + natural / 2, natural}});
  }
  add(" elliptic", {Layout::kFisheye, {LensModel::kStereographic, 200, 0.5 * n, 0.48 * n, 0.44 * n, 0.38 * n}});
  return examples;
}

/// How far from its centre a disc's rim lies in angle, where the picture is made of discs; the angle of a whole sphere
/// else.
inline double reach(const Projection& projection) {
  switch (projection.layout) {
    case Layout::kDualParaboloid:
      return kPi / 2;
    case Layout::kFisheye:
    case Layout::kDualFisheye:
      return kPi * projection.lens.fov_deg / 360;
    default:
      return kPi;
  }
}

/// Whether a disc's law is flat at its rim, so that r hardly depends on θ there.
inline bool flat_at_rim(const Projection& p) {
  return p.layout == Layout::kMirrorBall || p.layout == Layout::kSphereMap ||
         (p.lens.model == LensModel::kOrthographic && p.lens.fov_deg == 180) ||
         (p.lens.model == LensModel::kEquisolid && p.lens.fov_deg == 360);
}

/// Repeatable random points.
class Spread {
 public:
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
  }
  int index(int count) { return static_cast<int>(bits_() % static_cast<std::uint64_t>(count)); }
  PixelPoint point(ImageSize size) { return {uniform(0, size.width), uniform(0, size.height)}; }
  /// Uniform over the sphere.
  Vec3 direction() {
    const double z = uniform(-1, 1), azimuth = uniform(-kPi, kPi), s = std::sqrt(1 - z * z);
    return normalize({s * std::cos(azimuth), s * std::sin(azimuth), z});
  }

 private:
  std::mt19937_64 bits_{20240607};
};

}  // namespace zonal
