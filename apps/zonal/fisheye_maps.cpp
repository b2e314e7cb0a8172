#include "apps/zonal/fisheye_maps.h"

#include <algorithm>
#include <cmath>

#include "apps/zonal/output.h"
#include "zonal/base/check.h"
#include "zonal/io/picture_writer.h"
#include "zonal/io/png.h"
#include "zonal/light/rearrange.h"

namespace zonal {
namespace {

Image<Rgb8> codes_of(const Image<Rgb>& values) {
  const auto code = [](float v) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(v, 0.0f, 1.0f))); };
  Image<Rgb8> codes(values.width(), values.height());
  std::ranges::transform(values.values(), codes.values().begin(), [&](Rgb v) {
    return Rgb8{code(v.r), code(v.g), code(v.b)};
  });
  return codes;
}

Image<Rgb> cross_of(const Environment& cube) {
  const auto cross = rearranged(cube, {Layout::kCubeCross}, image_size(Layout::kCubeCross, cube.radiance.width()));
  check(cross.has_value(), "all cube layouts hold the same texels");
  return cross->radiance;
}

}  // namespace

std::vector<FisheyeFile> add_fisheye_maps(const FisheyeForms& forms, const std::string& name,
                                          const std::string& first_form, bool codes, OutputFolder& folder) {
  std::vector<FisheyeFile> files;
  const auto add = [&](const Image<Rgb>& map, const std::string& form) {
    const std::string stem = name + "-" + form;
    const std::string what = name + " map, " + form + " " + words_of({map.width(), map.height()});
    if (codes) {
      folder.add(stem + ".png", encode_png(codes_of(map)));
      files.push_back({stem + ".png", what + ", codes"});
      return;
    }
    for (const std::string extension : {".exr", ".png"}) {
      require_picture_writer(stem + extension)(map, folder.add(stem + extension), {});
      files.push_back({stem + extension, what + (extension == ".png" ? ", for screens" : "")});
    }
  };
  add(forms.paraboloid, first_form);
  add(forms.equirect.radiance, "panorama");
  add(cross_of(forms.cube), "cube-cross");
  return files;
}

}  // namespace zonal
