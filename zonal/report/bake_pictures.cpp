#include "zonal/report/bake_pictures.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "zonal/base/parallel.h"
#include "zonal/image/color.h"
#include "zonal/image/compare.h"
#include "zonal/light/resample.h"
#include "zonal/light/sample.h"
#include "zonal/report/ball.h"
#include "zonal/report/png_uri.h"

namespace zonal {
namespace {

constexpr int kIrradianceHeight = 256;
constexpr int kFitHeight = 96;
constexpr Projection kFlat = {Layout::kEquirect};

EncodedPicture encoded(const Image<Rgb8>& picture) {
  return {png_data_uri(picture), picture.width(), picture.height()};
}

/// An equirectangular picture of a map, linear.
Image<Rgb> flat(const Environment& map, int height_px, const Run& run) {
  return resample(map, kFlat, height_px, {}, run).radiance;
}

EncodedPicture ball_picture(const Environment& map, BallKind kind, const BallOptions& options, const Tonemap& curve) {
  const Sampler sampler(map);
  return encoded(tonemap(draw_ball([&](Vec3 toward) { return sampler(toward); }, kind, options), curve));
}

/// How far `fit` is from `exact`, the largest difference white.
EncodedPicture error_picture(const Image<Rgb>& fit, const Image<Rgb>& exact) {
  const Image<float> error = difference(fit, exact);
  float largest = 0;
  for (const float value : error.values()) {
    if (value > largest) largest = value;  // not for NaN
  }
  return encoded(false_color(error, largest > 0 ? largest : 1));
}

EncodedPicture error_scale() {
  Image<Rgb8> scale(256, 1);
  for (int x = 0; x < scale.width(); ++x) scale(x, 0) = false_color((x + 0.5) / scale.width());
  return encoded(scale);
}

/// Numbers as colours, without a tone curve: 0 black, 1 full.
EncodedPicture table_picture(const Image<Rgb>& table) {
  Image<Rgb8> shown(256, 256);
  for (int y = 0; y < shown.height(); ++y) {
    for (int x = 0; x < shown.width(); ++x) {
      const Rgb value = table(x * table.width() / shown.width(), y * table.height() / shown.height());
      shown(x, y) = {srgb8(value.r), srgb8(value.g), srgb8(value.b)};
    }
  }
  return encoded(shown);
}

}  // namespace

BakePictures draw_bake_pictures(const BakePage& page, const Run& run) {
  const Image<Rgb> panorama = flat(page.panorama, kPagePanoramaHeight, run);
  const Image<Rgb> irradiance = flat(page.irradiance, kIrradianceHeight, run);
  const Image<Rgb> exact = flat(page.irradiance, kFitHeight, run);

  BakePictures pictures;
  pictures.tonemap.exposure_ev = auto_exposure_ev(panorama);
  Tonemap matt = pictures.tonemap;
  matt.exposure_ev -= std::log2(kPi);
  pictures.chain_balls.resize(page.chain.size());
  pictures.fits.resize(page.sh.size());

  // Independent of each other, the long ones first.
  std::vector<std::function<void()>> tasks;
  tasks.push_back([&] { pictures.panorama = encoded(tonemap(panorama, pictures.tonemap)); });
  for (std::size_t i = 0; i < page.chain.size(); ++i) {
    tasks.push_back([&, i] {
      // A mirror squeezes half the sphere into its rim.
      const BallOptions options = {.size_px = 160, .supersample = page.chain[i].roughness == 0 ? 3 : 1};
      pictures.chain_balls[i] = ball_picture(page.chain[i].map, BallKind::kMirror, options, pictures.tonemap);
    });
  }
  tasks.push_back([&] { pictures.irradiance = encoded(tonemap(irradiance, matt)); });
  tasks.push_back([&] {
    pictures.exact_ball = ball_picture(page.irradiance, BallKind::kDiffuse, {}, matt);
    pictures.exact_map = encoded(tonemap(exact, matt));
    pictures.error_scale = error_scale();
    if (!page.split_sum.empty()) pictures.split_sum = table_picture(page.split_sum);
  });
  for (std::size_t i = 0; i < page.sh.size(); ++i) {
    tasks.push_back([&, i] {
      const Environment& fit = page.sh[i].irradiance;
      Run alone;  // a task waits for no other
      alone.threads = 1;
      const Image<Rgb> map = flat(fit, kFitHeight, alone);
      pictures.fits[i] = {ball_picture(fit, BallKind::kDiffuse, {}, matt), encoded(tonemap(map, matt)),
                          error_picture(map, exact)};
    });
  }
  for_each_block(run, "page", static_cast<int>(tasks.size()), 1, [&](Block block) { tasks[block.index](); });
  return pictures;
}

}  // namespace zonal
