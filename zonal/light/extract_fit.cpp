#include "zonal/light/extract_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "zonal/base/error.h"
#include "zonal/light/extract_solve.h"
#include "zonal/math/legendre.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/gradient.h"
#include "zonal/sh/irradiance.h"

namespace zonal {
namespace {

constexpr std::array<double, 3> kBrightness = {luminance(RgbD(1, 0, 0)), luminance(RgbD(0, 1, 0)),
                                               luminance(RgbD(0, 0, 1))};
// Below this part of the mean the rest of a probe is what a picture of floats leaves of a constant.
constexpr double kConstant = 1e-7;

std::array<double, 3> channels(RgbD c) { return {c.r, c.g, c.b}; }
RgbD color(const Eigen::RowVector3d& c) { return {c(0), c(1), c(2)}; }

double weighted_square(const Eigen::MatrixX3d& columns) {
  double sum = 0;
  for (int c = 0; c < 3; ++c) sum += kBrightness[static_cast<std::size_t>(c)] * columns.col(c).squaredNorm();
  return sum;
}

/// Coefficients in matrix rows have no l = 0.
int row(std::size_t coefficient) { return static_cast<int>(coefficient) - 1; }

}  // namespace

DiscFactors disc_factors(double versine, int bands) {
  const auto count = static_cast<std::size_t>(bands);
  std::vector<double> p(count), first(count), second(count);
  legendre_from_versine(versine, p);
  legendre_derivatives(p, first);
  for (std::size_t l = 2; l < count; ++l) {
    second[l] = second[l - 2] + (2.0 * static_cast<double>(l) - 1) * first[l - 1];
  }
  DiscFactors disc = {std::vector<double>(count, 1.0), std::vector<double>(count, 0.0)};
  for (std::size_t l = 1; l < count; ++l) {
    const double degree = static_cast<double>(l), scale = 1 / (degree * (degree + 1));
    disc.factors[l] = scale * (2 - versine) * first[l];
    disc.slopes[l] = -scale * (first[l] + (2 - versine) * second[l]);
  }
  return disc;
}

LightFitter::LightFitter(const Sh<RgbD>& radiance, ExtractMetric metric, bool nonnegative)
    : bands_(radiance.bands()), nonnegative_(nonnegative), weights_(static_cast<std::size_t>(bands_), 1.0) {
  if (bands_ < 2) {
    throw Error(ErrorKind::kUsage, "lights are found in a probe of at least two bands",
                "one band holds nothing but the mean");
  }
  double largest = 0, largest_mean = 0;
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    for (const double value : channels(radiance[i])) {
      if (!std::isfinite(value)) throw Error(ErrorKind::kInput, "a coefficient of the probe is not finite");
      largest = std::max(largest, std::abs(value));
    }
    if (i == 0) largest_mean = largest;
  }
  probe_.setZero(coefficient_count(bands_) - 1, 3);
  if (largest == 0) return;
  scale_ = largest;
  if (metric == ExtractMetric::kIrradiance) weights_ = cosine_factors(bands_);
  for (std::size_t c = 0; c < 3; ++c) flux_[c] = std::sqrt(4 * kPi) * channels(radiance[0])[c] / scale_;
  for (int l = 1; l < bands_; ++l) {
    for (int m = -l; m <= l; ++m) {
      const std::array<double, 3> value = channels(radiance(l, m));
      for (std::size_t c = 0; c < 3; ++c) {
        probe_(coefficient_index(l, m) - 1, static_cast<int>(c)) =
            weights_[static_cast<std::size_t>(l)] * value[c] / scale_;
      }
    }
  }
  if (probe_.cwiseAbs().maxCoeff() <= kConstant * largest_mean / scale_) probe_.setZero();
  size_ = weighted_square(probe_);
}

Eigen::VectorXd LightFitter::column(const LightShape& shape) const {
  const std::vector<double> disc = disc_factors(shape.versine, bands_).factors;
  Eigen::VectorXd y(coefficient_count(bands_));
  basis(bands_, shape.direction, std::span(y.data(), static_cast<std::size_t>(y.size())));
  for (int l = 1; l < bands_; ++l) {
    const auto band = static_cast<std::size_t>(l);
    y.segment(l * l, 2 * l + 1) *= weights_[band] * disc[band];
  }
  return y.tail(y.size() - 1);
}

LightFit LightFitter::fit(std::vector<LightShape> shapes) const {
  const auto count = static_cast<Eigen::Index>(shapes.size());
  Eigen::MatrixXd columns(probe_.rows(), count);
  for (Eigen::Index k = 0; k < count; ++k) columns.col(k) = column(shapes[static_cast<std::size_t>(k)]);
  const Eigen::MatrixXd gram = columns.transpose() * columns;
  LightFit fit = {std::move(shapes), Eigen::MatrixX3d::Zero(count, 3), probe_, 0};
  if (constant()) return fit;
  for (int c = 0; c < 3; ++c) {
    const Eigen::VectorXd right = columns.transpose() * probe_.col(c);
    fit.flux.col(c) = nonnegative_ ? nonnegative_least_squares(gram, right, flux_[static_cast<std::size_t>(c)])
                                   : least_squares(gram, right);
  }
  fit.rest -= columns * fit.flux;
  fit.residual = std::sqrt(weighted_square(fit.rest) / size_);
  return fit;
}

std::vector<ShapeSlope> LightFitter::slopes(const LightFit& fit) const {
  std::vector<ShapeSlope> slopes;
  if (constant()) return std::vector<ShapeSlope>(fit.shapes.size());
  for (std::size_t k = 0; k < fit.shapes.size(); ++k) {
    const DiscFactors disc = disc_factors(fit.shapes[k].versine, bands_);
    Sh<double> by_direction(bands_), by_versine(bands_);
    for (std::size_t i = 1; i < by_direction.size(); ++i) {
      for (int c = 0; c < 3; ++c) {
        by_direction[i] +=
            kBrightness[static_cast<std::size_t>(c)] * fit.flux(static_cast<int>(k), c) * fit.rest(row(i), c);
      }
    }
    by_versine = by_direction;
    for (int l = 1; l < bands_; ++l) {
      const auto band = static_cast<std::size_t>(l);
      for (double& value : by_direction.band(l)) value *= -2 / size_ * weights_[band] * disc.factors[band];
      for (double& value : by_versine.band(l)) value *= -2 / size_ * weights_[band] * disc.slopes[band];
    }
    slopes.push_back({gradient(by_direction, fit.shapes[k].direction), evaluate(by_versine, fit.shapes[k].direction)});
  }
  return slopes;
}

Sh<double> LightFitter::unexplained(const LightFit& fit) const {
  Sh<double> left(bands_);
  for (std::size_t i = 1; i < left.size(); ++i) left[i] = luminance(color(fit.rest.row(row(i))));
  return convolve(std::move(left), weights_);
}

ExtractedLights LightFitter::result(const LightFit& fit) const {
  ExtractedLights result;
  result.residual = fit.residual;
  const Eigen::RowVector3d taken = fit.flux.colwise().sum();
  result.ambient = scale_ / (4 * kPi) * (RgbD(flux_[0], flux_[1], flux_[2]) - color(taken));
  for (std::size_t k = 0; k < fit.shapes.size(); ++k) {
    const LightShape& shape = fit.shapes[k];
    // A disc of radiance L: flux 2 pi L (1 - c), irradiance pi L (1 - c^2).
    result.lights.push_back({shape.direction,
                             scale_ * (1 - shape.versine / 2) * color(fit.flux.row(static_cast<int>(k))),
                             std::min(2 * std::asin(std::sqrt(shape.versine / 2)), kPi / 2)});
  }
  return result;
}

}  // namespace zonal
