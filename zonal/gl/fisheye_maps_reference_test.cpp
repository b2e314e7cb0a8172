#include "zonal/gl/fisheye_maps_reference_test.h"

#include <algorithm>
#include <vector>

#include "zonal/gl/reference_lookups_test.h"
#include "zonal/light/fisheye_means.h"
#include "zonal/light/fisheye_published.h"
#include "zonal/light/resample.h"
#include "zonal/view/sky_maps.h"

namespace zonal {
namespace {

/// The mean over the texels of half a panorama.
RgbD mean_of_half(const Environment& panorama, bool upper) {
  RgbD sum;
  double area = 0;
  for (const LitTexel& texel : texels_of(panorama)) {
    if ((texel.toward.z > 0) != upper) continue;
    sum += texel.solid_angle * texel.radiance;
    area += texel.solid_angle;
  }
  return (1 / area) * sum;
}

Rgb ground_of(const Environment& panorama, const ViewState& state) {
  const int choice = static_cast<int>(state.value("sky_ground"));
  if (choice == 0) return Rgb(mean_of_half(panorama, false));
  const double grey = choice == 1 ? 0 : state.value("sky_grey") * luminance(mean_of_half(panorama, true));
  return Rgb(RgbD(grey, grey, grey));
}

/// A map with two texels of the ground around it, so that a lookup beside it finds the border; a pair without.
std::function<RgbD(Vec3)> bordered(const Image<Rgb>& map, Rgb ground) {
  const int size = map.height(), border = map.width() > size ? 0 : 2, padded = size + 2 * border;
  std::vector<Image<Rgb>> squares;
  for (int left = 0; left < map.width(); left += size) {
    Image<Rgb>& square = squares.emplace_back(padded, padded, ground);
    for (int y = 0; y < size; ++y) {
      std::ranges::copy(map.row(y).subspan(static_cast<std::size_t>(left), static_cast<std::size_t>(size)),
                        square.row(y + border).begin() + border);
    }
  }
  return [squares, size, border, padded](Vec3 d) {
    const bool lower = squares.size() == 2 && d.z < 0;
    const double depth = std::max(1 + (lower ? -d.z : d.z), 1e-9);
    const auto place = [&](double x) { return ((x / (2 * depth) + 0.5) * size + border) / padded; };
    return bilinear(squares[lower ? 1 : 0], place(d.y), place(-d.x), false, false);
  };
}

/// The corrected means at the texels' centres.
Image<Rgb> corrected_paraboloid(const Environment& photograph, double shininess, Rgb ground, int size,
                                FisheyeOutside outside) {
  const bool two = outside == FisheyeOutside::kTwo;
  Image<Rgb> map(two ? 2 * size : size, size, ground);
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const bool lower = x >= size;
      // The paraboloid itself: a quarter of a unit deep where it is half a unit wide.
      const double u = (x % size + 0.5) / size - 0.5, v = 0.5 - (y + 0.5) / size, m = u * u + v * v;
      if (outside == FisheyeOutside::kGround && m > 0.25) continue;
      const Vec3 q = normalize({v, u, lower ? m - 0.25 : 0.25 - m});
      map(x, y) = Rgb(fisheye_means(photograph, {.shininess = shininess, .ground = ground}, {&q, 1})[0]);
    }
  }
  return map;
}

}  // namespace

PointLight fisheye_maps_reference(const Environment& panorama, const ViewState& state) {
  const bool irradiance = state.value("sky_map") == 0, published = state.value("sky_weights") == 0;
  const double shininess = irradiance ? 1 : state.value("shininess");
  const auto outside = static_cast<FisheyeOutside>(state.value("sky_outside"));
  const int size = small_view_data().sky_px, form = static_cast<int>(state.value("sky_form"));
  const Rgb ground = ground_of(panorama, state);
  const Environment photograph = resample(panorama, {Layout::kFisheye}, sky_photograph_px(size));
  const Image<Rgb> map =
      published ? published_paraboloid(photograph,
                                       {.shininess = shininess, .ground = ground, .size_px = size, .outside = outside})
                : corrected_paraboloid(photograph, shininess, ground, size, outside);
  const auto read = [&](Layout layout, int px) {
    return lookup(read_paraboloid(map, ground, {layout}, image_size(layout, px)));
  };
  const auto mean = form == 0   ? bordered(map, ground)
                    : form == 1 ? read(Layout::kEquirect, size)
                                : read(Layout::kCubeStack, size / 2);
  return irradiance ? of_normal(state, mean, state.value("albedo")) : of_mirrored(state, mean);
}

}  // namespace zonal
