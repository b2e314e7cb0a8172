#include "zonal/sh/window.h"

#include <limits>

#include "zonal/base/error.h"

namespace zonal {
namespace {

void require(bool ok, const char* message) {
  if (!ok) throw Error(ErrorKind::kUsage, message);
}

void require_fraction(double fraction) {
  require(fraction >= 1e-12 && fraction <= 1, "the squared Laplacian is reduced to a fraction from 1e-12 to 1");
}

/// l(l+1) squared: what the squared Laplacian makes of the energy of band l.
double stiffness(double l) {
  const double eigenvalue = l * (l + 1);
  return eigenvalue * eigenvalue;
}

}  // namespace

Window Window::hann(double width_bands) {
  require(std::isfinite(width_bands) && width_bands > 0, "the width of a Hann window is a number of bands above 0");
  Window window;
  window.kind_ = WindowKind::kHann;
  window.amount_ = width_bands;
  return window;
}

Window Window::lanczos(double width_bands, double power) {
  require(std::isfinite(width_bands) && width_bands > 0, "the width of a Lanczos window is a number of bands above 0");
  require(std::isfinite(power) && power > 0, "the power of a Lanczos window is above 0");
  Window window;
  window.kind_ = WindowKind::kLanczos;
  window.amount_ = width_bands;
  window.power_ = power;
  return window;
}

Window Window::laplacian(double weight) {
  require(std::isfinite(weight) && weight >= 0, "the weight of a Laplacian window is 0 or more");
  Window window;
  window.kind_ = WindowKind::kLaplacian;
  window.amount_ = weight;
  return window;
}

Window Window::laplacian_fraction(double fraction, WindowChannels channels) {
  require_fraction(fraction);
  Window window;
  window.kind_ = WindowKind::kLaplacianFraction;
  window.amount_ = fraction;
  window.channels_ = channels;
  return window;
}

double laplacian_weight(std::span<const double> band_energies, double fraction) {
  require_fraction(fraction);
  double original = 0;
  for (std::size_t l = 0; l < band_energies.size(); ++l)
    original += stiffness(static_cast<double>(l)) * band_energies[l];
  if (!std::isfinite(original)) {
    throw Error(ErrorKind::kInput, "the squared Laplacian of the function is not finite",
                "a coefficient is infinite, not a number or too large to be squared");
  }
  if (original == 0) return 0;

  // Sloan 2008, appendix A7, with the target in the place of the original: the root of
  //   target - sum L B/(1 + weight L)^2,
  // which rises and is concave, so Newton's steps from 0 never pass the root. In units of the original squared
  // Laplacian.
  double weight = 0;
  for (;;) {
    double value = fraction, slope = 0;
    for (std::size_t l = 0; l < band_energies.size(); ++l) {
      const double stiff = stiffness(static_cast<double>(l)), share = stiff * band_energies[l] / original,
                   damp = 1 + weight * stiff;
      value -= share / (damp * damp);
      slope += 2 * stiff * share / (damp * damp * damp);
    }
    const double next = weight - value / slope;
    // The last steps are rounding: upward by ulps, or down.
    if (!(next > weight * (1 + 4 * std::numeric_limits<double>::epsilon()))) return weight;
    weight = next;
  }
}

double window_factor(const Window& window, int l) {
  check(l >= 0, "bands count from 0");
  const double x = window.amount() > 0 ? kPi * l / window.amount() : 0;
  switch (window.kind()) {
    case WindowKind::kNone:
      return 1;
    case WindowKind::kHann:
      return l < window.amount() ? (1 + std::cos(x)) / 2 : 0;
    case WindowKind::kLanczos:
      if (l == 0) return 1;
      return l < window.amount() ? std::pow(std::sin(x) / x, window.power()) : 0;
    case WindowKind::kLaplacian:
      return 1 / (1 + window.amount() * stiffness(l));
    case WindowKind::kLaplacianFraction:
      break;
  }
  check(false, "a window by fraction needs the function");
  return 0;
}

std::vector<double> window_factors(const Window& window, int bands) {
  check(bands >= 0, "the number of bands must not be negative");
  std::vector<double> factors;
  for (int l = 0; l < bands; ++l) factors.push_back(window_factor(window, l));
  return factors;
}

double unwindowed_weight(Vec3 toward_dominant_light, Vec3 reflected, const ContentWindow& content) {
  require(content.threshold < 1 && content.power > 0, "a content window has a threshold below 1 and a power above 0");
  const double above = (dot(toward_dominant_light, reflected) - content.threshold) / (1 - content.threshold);
  return above > 0 ? std::min(1.0, std::pow(above, content.power)) : 0;
}

}  // namespace zonal
