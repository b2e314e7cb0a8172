#include "zonal/image/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "zonal/base/check.h"
#include "zonal/base/error.h"

namespace zonal {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void require_same_size(const Image<Rgb>& image, const Image<Rgb>& reference) {
  if (image.width() == reference.width() && image.height() == reference.height()) return;
  const auto size = [](const Image<Rgb>& i) { return std::to_string(i.width()) + "x" + std::to_string(i.height()); };
  throw Error(ErrorKind::kInput, "the pictures differ in size: " + size(image) + " and " + size(reference),
              "convert one of them to the projection and size of the other");
}

bool is_finite(Rgb c) { return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b); }
RgbD magnitude(RgbD c) { return {std::abs(c.r), std::abs(c.g), std::abs(c.b)}; }

}  // namespace

Comparison compare(const Image<Rgb>& image, const Image<Rgb>& reference, std::span<const double> weights) {
  require_same_size(image, reference);
  check(weights.empty() || weights.size() == image.size(), "one weight for each texel");
  const auto used = [&](std::size_t i) {
    return (weights.empty() || weights[i] > 0) && is_finite(image.values()[i]) && is_finite(reference.values()[i]);
  };

  Comparison result;
  double weight_sum = 0, squares = 0, reference_squares = 0, signed_sum = 0, peak = 0;
  for (std::size_t i = 0; i < image.size(); ++i) {
    if (!weights.empty() && !(weights[i] > 0)) continue;
    if (!used(i)) {
      ++result.not_finite;
      continue;
    }
    ++result.texels;
    const double weight = weights.empty() ? 1 : weights[i];
    const RgbD truth(reference.values()[i]);
    const RgbD error = RgbD(image.values()[i]) - truth;
    weight_sum += weight;
    squares += weight * (error.r * error.r + error.g * error.g + error.b * error.b);
    reference_squares += weight * (truth.r * truth.r + truth.g * truth.g + truth.b * truth.b);
    signed_sum += weight * (error.r + error.g + error.b);
    peak = std::max(peak, max_channel(magnitude(truth)));
    const double worst = max_channel(magnitude(error));
    if (worst > result.max_error) {
      result.max_error = worst;
      result.worst_x = static_cast<int>(i % static_cast<std::size_t>(image.width()));
      result.worst_y = static_cast<int>(i / static_cast<std::size_t>(image.width()));
    }
  }
  if (result.texels == 0) return result;

  const double reference_rms = std::sqrt(reference_squares / (3 * weight_sum));
  result.rmse = std::sqrt(squares / (3 * weight_sum));
  result.mean_error = signed_sum / (3 * weight_sum);
  result.psnr_db = result.rmse > 0 ? 20 * std::log10(peak / result.rmse) : kInfinity;
  if (result.rmse > 0) result.relative_rmse = reference_rms > 0 ? result.rmse / reference_rms : kInfinity;

  // Second pass: the floor under a relative error needs the reference's rms.
  const double floor = 1e-3 * reference_rms;
  for (std::size_t i = 0; i < image.size(); ++i) {
    if (!used(i)) continue;
    const RgbD truth(reference.values()[i]), size = magnitude(truth);
    const RgbD error = magnitude(RgbD(image.values()[i]) - truth);
    const auto relative = [&](double e, double s) { return e > 0 ? e / std::max(s, floor) : 0; };
    result.max_relative_error = std::max(
        {result.max_relative_error, relative(error.r, size.r), relative(error.g, size.g), relative(error.b, size.b)});
  }
  return result;
}

Image<float> difference(const Image<Rgb>& image, const Image<Rgb>& reference) {
  require_same_size(image, reference);
  Image<float> picture(image.width(), image.height());
  for (std::size_t i = 0; i < image.size(); ++i) {
    const Rgb a = image.values()[i], b = reference.values()[i];
    picture.values()[i] = is_finite(a) && is_finite(b) ? static_cast<float>(max_channel(magnitude(RgbD(a) - RgbD(b))))
                                                       : std::numeric_limits<float>::quiet_NaN();
  }
  return picture;
}

}  // namespace zonal
