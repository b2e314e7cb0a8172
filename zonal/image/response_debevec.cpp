#include "zonal/image/response_debevec.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>

#include "zonal/image/response_finish.h"

namespace zonal {
namespace {

constexpr double kPublishedTexels = 150;

/// The normal equations of one channel's curve.
struct Equations {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(kCodes, kCodes);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(kCodes);
};

/// Adds one texel with its radiance eliminated: ln radiance is the weighted mean of g(z) - ln seconds, so its equations
/// are those of the deviations from that mean.
void add_texel(std::span<const std::uint8_t> codes, std::span<const double> log_seconds,
               std::span<const double> weights, double scale, Equations& equations) {
  double total = 0, mean_log = 0;
  for (std::size_t k = 0; k < codes.size(); ++k) {
    total += weights[codes[k]];
    mean_log += weights[codes[k]] * log_seconds[k];
  }
  if (total <= 0) return;
  mean_log /= total;
  for (std::size_t k = 0; k < codes.size(); ++k) {
    const double w = scale * weights[codes[k]];
    if (w <= 0) continue;
    equations.matrix(codes[k], codes[k]) += w;
    equations.right(codes[k]) += w * (log_seconds[k] - mean_log);
    for (std::size_t other = 0; other < codes.size(); ++other) {
      equations.matrix(codes[k], codes[other]) -= w * weights[codes[other]] / total;
    }
  }
}

/// Second differences should vanish, weighted as the codes are; the outermost codes as their neighbours, so that codes
/// without any weight are continued straight.
void add_smoothness(double smoothness, std::span<const double> weights, Equations& equations) {
  constexpr std::array<double, 3> kSecond = {1, -2, 1};
  for (int z = 1; z < kCodes - 1; ++z) {
    const double w = smoothness * smoothness * std::max(weights[z], 1e-4);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) equations.matrix(z - 1 + i, z - 1 + j) += w * kSecond[i] * kSecond[j];
    }
  }
}

std::array<double, kCodes> squared_weights(TrustedCodes trusted) {
  std::array<double, kCodes> weights;
  for (int z = 0; z < kCodes; ++z) {
    const double w = code_weight(CodeWeight::kHat, trusted, z / 255.0);
    weights[z] = w * w;
  }
  return weights;
}

}  // namespace

ResponseFit estimate_response_debevec(const CodeSamples& samples, const DebevecOptions& options) {
  check_samples(samples, options.trusted);
  std::vector<double> log_seconds;
  for (const double seconds : samples.seconds) log_seconds.push_back(std::log(seconds));

  ResponseFit fit;
  for (int c = 0; c < 3; ++c) {
    const std::array<double, kCodes> weights = squared_weights(options.trusted[c]);
    Equations equations;
    for (int i = 0; i < samples.pixels(); ++i) {
      add_texel(samples.of(c, i), log_seconds, weights, kPublishedTexels / samples.pixels(), equations);
    }
    add_smoothness(options.smoothness, weights, equations);
    // The curve is known up to a constant only; any positive weight on this equation gives the same curve.
    equations.matrix(kMiddleCode, kMiddleCode) += 1;
    const Eigen::VectorXd log_exposure = equations.matrix.ldlt().solve(equations.right);
    for (int z = 0; z < kCodes; ++z) fit.response.exposure[c][z] = std::exp(log_exposure(z));
  }
  finish(samples, CodeWeight::kHat, options.trusted, fit);
  return fit;
}

}  // namespace zonal
