#include "zonal/sh/least_squares.h"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "zonal/base/error.h"
#include "zonal/sh/eval.h"

namespace zonal {
namespace {

constexpr int kMaxBands = 32;
constexpr Eigen::Index kBlockRows = 512;

// A value as a row of channels and back.
double channel(double value, int) { return value; }
double channel(RgbD value, int i) { return i == 0 ? value.r : i == 1 ? value.g : value.b; }
double from_channels(double, const Eigen::RowVectorXd& c) { return c(0); }
RgbD from_channels(RgbD, const Eigen::RowVectorXd& c) { return {c(0), c(1), c(2)}; }
template <class T>
constexpr int kChannels = 1;
template <>
constexpr int kChannels<RgbD> = 3;

[[noreturn]] void fail(std::size_t sample, const char* what, std::string hint = {}) {
  throw Error(ErrorKind::kInput, "sample " + std::to_string(sample) + " " + what, std::move(hint));
}

/// The weights scaled so that they sum to 4 pi, checked together with everything else about the samples.
template <class T>
std::vector<double> checked_weights(std::span<const ShSample<T>> samples) {
  double largest = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const ShSample<T>& s = samples[i];
    const double long_side = std::hypot(s.direction.x, s.direction.y, s.direction.z);
    if (!std::isfinite(long_side)) fail(i, "has a direction that is not finite");
    if (long_side == 0) fail(i, "has the zero vector as its direction");
    for (int c = 0; c < kChannels<T>; ++c) {
      if (!std::isfinite(channel(s.value, c))) fail(i, "has a value that is not finite", "leave such samples out");
    }
    if (!(s.weight >= 0)) fail(i, "has a weight that is negative or not a number", "0 leaves a sample out");
    if (!std::isfinite(s.weight)) fail(i, "has an infinite weight");
    largest = std::max(largest, s.weight);
  }
  if (largest == 0) {
    throw Error(ErrorKind::kInput, samples.empty() ? "there are no samples" : "all samples have the weight 0");
  }
  std::vector<double> weights;
  double sum = 0;  // relative to the largest: it cannot overflow
  for (const ShSample<T>& s : samples) sum += weights.emplace_back(s.weight / largest);
  for (double& weight : weights) weight *= 4 * kPi / sum;
  return weights;
}

/// The triangular factor of the rows [sqrt(weight) basis | sqrt(weight) value], a block of samples at a time.
template <class T>
Eigen::MatrixXd triangle(std::span<const ShSample<T>> samples, const std::vector<double>& weights, int bands) {
  const Eigen::Index unknowns = coefficient_count(bands), columns = unknowns + kChannels<T>;
  Eigen::MatrixXd stack = Eigen::MatrixXd::Zero(columns + kBlockRows, columns);
  Eigen::Index filled = columns;  // the triangle so far lies on top
  const auto reduce = [&] {
    Eigen::HouseholderQR<Eigen::Ref<Eigen::MatrixXd>> qr(stack);
    stack.bottomRows(kBlockRows).setZero();
    stack.topRows(columns).triangularView<Eigen::StrictlyLower>().setZero();
    filled = columns;
  };
  std::vector<double> y(static_cast<std::size_t>(unknowns));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (weights[i] == 0) continue;
    const Vec3 d = samples[i].direction;
    const double root = std::sqrt(weights[i]), long_side = std::hypot(d.x, d.y, d.z);
    basis<double>(bands, {d.x / long_side, d.y / long_side, d.z / long_side}, y);
    for (Eigen::Index k = 0; k < unknowns; ++k) stack(filled, k) = root * y[static_cast<std::size_t>(k)];
    for (int c = 0; c < kChannels<T>; ++c) stack(filled, unknowns + c) = root * channel(samples[i].value, c);
    if (++filled == stack.rows()) reduce();
  }
  reduce();
  return stack.topRows(columns);
}

template <class T>
LeastSquaresFit<T> fit(std::span<const ShSample<T>> samples, int bands, double ridge) {
  if (bands < 1 || bands > kMaxBands) {
    throw Error(ErrorKind::kUsage, "samples are fitted by 1 to 32 bands, not " + std::to_string(bands),
                "for more, fill a panorama and project it");
  }
  if (!(ridge >= 0) || !std::isfinite(ridge)) throw Error(ErrorKind::kUsage, "a ridge is a number from 0 on");
  const std::vector<double> weights = checked_weights(samples);
  const Eigen::Index unknowns = coefficient_count(bands);
  const auto used = static_cast<Eigen::Index>(weights.size() - std::ranges::count(weights, 0.0));
  const std::string hint = "give more samples, fewer bands, or a ridge such as 0.01";
  if (ridge == 0 && used < unknowns) {
    throw Error(ErrorKind::kInput,
                std::to_string(bands) + " bands have " + std::to_string(unknowns) + " coefficients, more than the " +
                    std::to_string(used) + " samples can tell",
                hint);
  }

  const Eigen::MatrixXd r = triangle(samples, weights, bands);
  const Eigen::MatrixXd system = r.topLeftCorner(unknowns, unknowns), values = r.topRightCorner(unknowns, kChannels<T>);
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(system, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::ArrayXd sigma = svd.singularValues().array();
  const double most = sigma.maxCoeff(), least = sigma.minCoeff();
  // Below the rounding of the triangle a singular value is noise.
  const double noise = std::numeric_limits<double>::epsilon() * static_cast<double>(std::max(used, unknowns)) * most;
  if (ridge == 0 && least <= noise) {
    throw Error(ErrorKind::kInput,
                "the samples leave " + std::to_string((sigma <= noise).count()) + " of " + std::to_string(unknowns) +
                    " combinations of coefficients open",
                "spread them over more of the sphere; or " + hint);
  }
  const Eigen::ArrayXd inverse = sigma / (sigma.square() + ridge);
  const Eigen::MatrixXd solution =
      svd.matrixV() * (inverse.matrix().asDiagonal() * (svd.matrixU().transpose() * values));

  // What no function of these bands reaches lies below the triangle of the system; the ridge adds what it gives up.
  Eigen::RowVectorXd residual(kChannels<T>);
  for (int c = 0; c < kChannels<T>; ++c) {
    const double reached = (system * solution.col(c) - values.col(c)).squaredNorm();
    const double beyond = r.col(unknowns + c).tail(kChannels<T>).squaredNorm();
    residual(c) = std::sqrt((reached + beyond) / (4 * kPi));
  }
  LeastSquaresFit<T> result;
  result.coefficients = Sh<T>(bands);
  for (Eigen::Index i = 0; i < unknowns; ++i) {
    result.coefficients[static_cast<std::size_t>(i)] = from_channels(T(), solution.row(i));
  }
  result.residual = from_channels(T(), residual);
  result.condition = std::sqrt((most * most + ridge) / (least * least + ridge));
  return result;
}

}  // namespace

LeastSquaresFit<double> fit_sh(std::span<const ShSample<double>> samples, int bands, double ridge) {
  return fit(samples, bands, ridge);
}

LeastSquaresFit<RgbD> fit_sh(std::span<const ShSample<RgbD>> samples, int bands, double ridge) {
  return fit(samples, bands, ridge);
}

}  // namespace zonal
