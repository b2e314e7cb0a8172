#include "zonal/report/gallery.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

#include "zonal/base/check.h"
#include "zonal/report/gallery_light.h"
#include "zonal/report/gallery_plots.h"

namespace zonal {
namespace {

/// As the paper goes on; the functions that the basis is made of, which it has in its appendix, come last.
constexpr std::array<std::string_view, 17> kOrder = {
    "basis-shapes",   "basis-cubes",  "rotating-light",   "clamped-cosine-3", "clamped-cosine-5", "probe-bands",
    "sphere-light",   "cones",        "extracted-lights", "windows",          "delta-windows",    "laplacian",
    "windowed-probe", "yellow-light", "content-window",   "hole-in-the-sky",  "legendre"};

std::ptrdiff_t place_of(const GalleryFigure& figure) {
  const auto place = std::ranges::find(kOrder, figure.id);
  check(place != kOrder.end(), "a figure of the gallery has no place in its order");
  return place - kOrder.begin();
}

}  // namespace

std::vector<GalleryFigure> gallery_figures(const Environment& probe, const Run& run) {
  std::vector<GalleryFigure> all = gallery_plots(run), lights = gallery_lights(probe, run);
  all.insert(all.end(), std::make_move_iterator(lights.begin()), std::make_move_iterator(lights.end()));
  std::ranges::stable_sort(all, {}, place_of);
  return all;
}

}  // namespace zonal
