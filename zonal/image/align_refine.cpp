#include "zonal/image/align_refine.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace zonal {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kTukey = 4.685;               // standard deviations; 95 % efficient where nothing moved
constexpr double kMedianToDeviation = 1.4826;  // of a normal distribution
constexpr double kLeastDeviation = 0.5;        // codes: rounding alone, after smoothing; edges must not be outliers
constexpr double kFewestTexels = 64;
constexpr int kMostSteps = 30;
constexpr double kLargestStep_px = 2;
constexpr double kSmallestStep_px = 1e-3;  // of the texels of a level
/// Rotations to start from. They are 2 degrees apart: a corner of the coarsest level moves by a texel and a half.
constexpr std::array<double, 7> kStarts_deg = {0, -2, 2, -4, 4, -6, 6};

/// Counts absolute differences, so that their median is found in one pass.
class DifferenceHistogram {
 public:
  void add(float difference) {
    ++counts_[std::min(counts_.size() - 1, static_cast<std::size_t>(kPerCode * difference))];
    ++total_;
  }
  std::int64_t total() const { return total_; }
  double median() const {
    std::int64_t below = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      below += counts_[i];
      if (2 * below >= total_) return (static_cast<double>(i) + 0.5) / kPerCode;
    }
    return 0;
  }

 private:
  static constexpr float kPerCode = 32;
  std::array<std::int64_t, kGreyLevels* 32> counts_ = {};
  std::int64_t total_ = 0;
};

/// One level of both pyramids.
class Level {
 public:
  Level(const Image<float>& fixed, const Image<float>& moving, PicturePoint center)
      : fixed_(fixed),
        moving_(moving),
        center_(center),
        corner_px_(std::max(1.0, std::hypot(center.x, center.y))),
        differences_(fixed.width(), fixed.height()) {}

  /// Steps until they are small. Lengths are texels of this level.
  Refined fit(Placement placement) {
    Refined result{placement, 0, 0, std::numeric_limits<double>::infinity()};
    for (int step = 0; step < kMostSteps; ++step) {
      const Sums sums = sums_at(result.placement);
      if (sums.texels < kFewestTexels) return result;
      const Eigen::LDLT<Eigen::Matrix3d> solver(sums.normal);
      if (solver.info() != Eigen::Success || !(solver.vectorD().minCoeff() > 1e-9 * solver.vectorD().maxCoeff())) {
        result.error_px = std::numeric_limits<double>::infinity();
        return result;
      }
      Eigen::Vector3d move = solver.solve(sums.right);
      const Eigen::Matrix3d covariance = sums.deviation * sums.deviation * solver.solve(Eigen::Matrix3d::Identity());
      result.residual_codes = sums.deviation;
      result.correlation = sums.correlation;
      result.error_px = std::sqrt(covariance.trace());
      const double length = move.norm();
      if (length > kLargestStep_px) move *= kLargestStep_px / length;
      const Placement in_fixed{move(0), move(1), move(2) / corner_px_ / kRadians};
      result.placement = composed(result.placement, inverse(in_fixed));
      if (length < kSmallestStep_px) break;
    }
    return result;
  }

 private:
  struct Sums {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    double texels = 0, deviation = 0, correlation = 0;
  };

  struct Slope {
    float x, y;
  };
  Slope slope_at(int x, int y) const {
    return {(fixed_(x + 1, y) - fixed_(x - 1, y)) / 2, (fixed_(x, y + 1) - fixed_(x, y - 1)) / 2};
  }

  /// Fills in the differences; NaN where one picture has no data, or `fixed` no structure.
  DifferenceHistogram compare(const Placement& placement) {
    const Placing placing(placement, center_);
    DifferenceHistogram histogram;
    std::fill(differences_.values().begin(), differences_.values().end(), kNoCode);
    for (int y = 1; y + 1 < fixed_.height(); ++y) {
      for (int x = 1; x + 1 < fixed_.width(); ++x) {
        const Slope slope = slope_at(x, y);
        if (!(slope.x * slope.x + slope.y * slope.y > 0)) continue;
        const float difference = value_at(moving_, placing({x + 0.5, y + 0.5})) - fixed_(x, y);
        if (std::isnan(difference)) continue;
        differences_(x, y) = difference;
        histogram.add(std::abs(difference));
      }
    }
    return histogram;
  }

  /// The normal equations of one step; the third unknown is the way of a corner.
  Sums sums_at(const Placement& placement) {
    const DifferenceHistogram histogram = compare(placement);
    Sums sums;
    if (static_cast<double>(histogram.total()) < kFewestTexels) return sums;
    sums.deviation = std::max(kLeastDeviation, kMedianToDeviation * histogram.median());
    const double limit = kTukey * sums.deviation;
    double weights = 0, a1 = 0, b1 = 0, aa = 0, ab = 0, bb = 0;
    for (int y = 1; y + 1 < fixed_.height(); ++y) {
      for (int x = 1; x + 1 < fixed_.width(); ++x) {
        const double difference = differences_(x, y);
        if (!(std::abs(difference) < limit)) continue;
        const double inside = 1 - difference * difference / (limit * limit), weight = inside * inside;
        const Slope slope = slope_at(x, y);
        const double turn = ((x + 0.5 - center_.x) * slope.y - (y + 0.5 - center_.y) * slope.x) / corner_px_;
        const Eigen::Vector3d gradient(slope.x, slope.y, turn);
        sums.normal += weight * gradient * gradient.transpose();
        sums.right += weight * difference * gradient;
        const double a = fixed_(x, y), b = a + difference;
        weights += weight, a1 += weight * a, b1 += weight * b;
        aa += weight * a * a, ab += weight * a * b, bb += weight * b * b;
      }
    }
    sums.texels = weights;
    const double variances = (weights * aa - a1 * a1) * (weights * bb - b1 * b1);
    if (variances > 0) sums.correlation = (weights * ab - a1 * b1) / std::sqrt(variances);
    return sums;
  }

  const Image<float>& fixed_;
  const Image<float>& moving_;
  PicturePoint center_;
  double corner_px_;
  Image<float> differences_;
};

Placement scaled(const Placement& p, double factor) { return {factor * p.dx, factor * p.dy, p.rotation_deg}; }

/// One level, with lengths in pixels of the finest one.
Refined fit_level(const std::vector<Image<float>>& fixed, const std::vector<Image<float>>& moving, std::size_t level,
                  std::span<const Placement> starts) {
  const double scale = std::exp2(static_cast<double>(level));
  Level here(fixed[level], moving[level], {fixed[0].width() / 2.0 / scale, fixed[0].height() / 2.0 / scale});
  Refined best{starts[0], 0, -1, std::numeric_limits<double>::infinity()};
  for (const Placement& start : starts) {
    Refined found = here.fit(scaled(start, 1 / scale));
    found.placement = scaled(found.placement, scale);
    found.error_px *= scale;
    if (std::isfinite(found.error_px) && found.correlation > best.correlation) best = found;
  }
  return best;
}

Refined fit_levels(const std::vector<Image<float>>& fixed, const std::vector<Image<float>>& moving,
                   std::size_t coarsest, Placement start) {
  Refined found;
  for (std::size_t level = coarsest + 1; level-- > 0;) {
    found = fit_level(fixed, moving, level, std::span(&start, 1));
    start = found.placement;
  }
  return found;
}

}  // namespace

Refined refine_placement(const std::vector<Image<float>>& fixed, const std::vector<Image<float>>& moving,
                         const Placement& start) {
  std::vector<Placement> starts;
  for (const double turned_deg : kStarts_deg) starts.push_back({start.dx, start.dy, start.rotation_deg + turned_deg});
  const std::size_t coarsest = fixed.size() - 1;
  const Refined found = fit_level(fixed, moving, coarsest, starts);
  return coarsest == 0 ? found : fit_levels(fixed, moving, coarsest - 1, found.placement);
}

Refined polish_placement(const std::vector<Image<float>>& fixed, const std::vector<Image<float>>& moving,
                         const Placement& start) {
  return fit_levels(fixed, moving, std::min<std::size_t>(1, fixed.size() - 1), start);
}

Image<std::uint8_t> agreeing_texels(const Image<float>& fixed, const Image<float>& moving, const Refined& found) {
  constexpr double kDeviations = 3;
  const double limit = kDeviations * std::max(kLeastDeviation, found.residual_codes);
  const Placing placing(found.placement, {fixed.width() / 2.0, fixed.height() / 2.0});
  Image<std::uint8_t> agree(fixed.width(), fixed.height());
  for (int y = 0; y < fixed.height(); ++y) {
    for (int x = 0; x < fixed.width(); ++x) {
      agree(x, y) = std::abs(value_at(moving, placing({x + 0.5, y + 0.5})) - fixed(x, y)) < limit;
    }
  }
  return agree;
}

}  // namespace zonal
