#include "zonal/image/deghost.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "zonal/base/check.h"
#include "zonal/base/parallel.h"
#include "zonal/image/light_row.h"

namespace zonal {
namespace {

constexpr float kLeastWeight = 0.1f;  // below it a code says too little to compare
constexpr double kSmoothFrom = 1.0 / 8, kSmoothTo = 3.0 / 8;
constexpr double kMedianToDeviation = 1.4826;  // of a normal distribution
constexpr int kNoiseRows = 97;                 // rows in which the noise is measured

using Row = std::vector<LightTexel>;

class Comparison {
 public:
  Comparison(const Exposures& bracket, const Response& response, const TrustedRanges& trusted)
      : bracket_(bracket), tables_(bracket, response, CodeWeight::kHat, trusted) {
    for (const Exposure& exposure : bracket) log_seconds_.push_back(static_cast<float>(std::log(exposure.seconds)));
  }

  int width() const { return bracket_[0].picture.width(); }
  int height() const { return bracket_[0].picture.height(); }
  int count() const { return static_cast<int>(bracket_.size()); }

  std::vector<Row> rows_at(int y) const {
    std::vector<Row> rows(bracket_.size(), Row(static_cast<std::size_t>(width())));
    for (std::size_t k = 0; k < rows.size(); ++k) read_light(bracket_[k], tables_[k], y, rows[k]);
    return rows;
  }

  /// The sum of an exposure's weights in a row.
  static double weight(const Row& row) {
    double sum = 0;
    for (const LightTexel& light : row) sum += light[0].weight + light[1].weight + light[2].weight;
    return sum;
  }

  /// Calls f(k, difference in standard deviations of one code's noise) for every exposure and channel of a texel that
  /// can be compared with the reference.
  template <class F>
  void compare(const std::vector<Row>& rows, int x, int reference, F f) const {
    for (int c = 0; c < 3; ++c) {
      const int chosen = reference_at(rows, x, c, reference);
      if (chosen < 0) continue;
      const CodeValue& expected = rows[chosen][x][c];
      for (int k = 0; k < count(); ++k) {
        if (k == chosen) continue;
        const CodeValue& got = rows[k][x][c];
        if (got.weight < kLeastWeight) continue;
        const float difference = got.log_exposure - log_seconds_[k] - (expected.log_exposure - log_seconds_[chosen]);
        f(k, std::abs(difference) / std::hypot(got.slope, expected.slope));
      }
    }
  }

 private:
  /// The exposure nearest to the reference that has a good code; -1: none.
  int reference_at(const std::vector<Row>& rows, int x, int c, int reference) const {
    for (int away = 0; away < count(); ++away) {
      for (const int k : {reference - away, reference + away}) {
        if (k >= 0 && k < count() && rows[k][x][c].weight >= kLeastWeight) return k;
      }
    }
    return -1;
  }

  const Exposures& bracket_;
  CodeTables tables_;
  std::vector<float> log_seconds_;
};

int best_exposed(const Comparison& comparison, const Run& run) {
  const std::vector<double> none(static_cast<std::size_t>(comparison.count()));
  const std::vector<double> weights = reduce_blocks(
      run, "", comparison.height(), 1, none,
      [&](Block block) {
        const std::vector<Row> rows = comparison.rows_at(block.begin);
        std::vector<double> sums;
        for (int k = 0; k < comparison.count(); ++k) sums.push_back(Comparison::weight(rows[k]));
        return sums;
      },
      [](std::vector<double>& all, const std::vector<double>& row) {
        for (std::size_t k = 0; k < all.size(); ++k) all[k] += row[k];
      });
  return static_cast<int>(std::max_element(weights.begin(), weights.end()) - weights.begin());
}

double measured_noise(const Comparison& comparison, int reference) {
  std::vector<float> differences;
  const int step = std::max(1, comparison.height() / kNoiseRows);
  for (int y = 0; y < comparison.height(); y += step) {
    const std::vector<Row> rows = comparison.rows_at(y);
    for (int x = 0; x < comparison.width(); x += step) {
      comparison.compare(rows, x, reference, [&](int, float difference) { differences.push_back(difference); });
    }
  }
  if (differences.empty()) return 1;
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  return std::max(1.0, kMedianToDeviation * *middle);
}

/// The mean over a window of (2 radius + 1)², cut at the edges, along the rows of `from`; turned, so that twice does
/// both axes.
Image<float> blurred_and_turned(const Image<float>& from, int radius) {
  Image<float> to(from.height(), from.width());
  for (int y = 0; y < from.height(); ++y) {
    const auto row = from.row(y);
    const int width = from.width();
    float sum = 0;
    for (int x = 0; x < std::min(radius, width); ++x) sum += row[x];
    for (int x = 0; x < width; ++x) {
      // Of small integers, or of means of such: rounding stays far below the mask's steps of 1/255.
      if (x + radius < width) sum += row[x + radius];
      const int left = std::max(0, x - radius), right = std::min(width - 1, x + radius);
      to(y, x) = sum / static_cast<float>(right - left + 1);
      if (x - radius >= 0) sum -= row[x - radius];
    }
  }
  return to;
}

/// From 1 where texels disagree to a mask that is 255 where they do not.
Image<std::uint8_t> smooth_mask(const Image<std::uint8_t>& moved) {
  Image<float> share(moved.width(), moved.height());
  std::copy(moved.values().begin(), moved.values().end(), share.values().begin());
  const int radius = std::max(2, std::min(moved.width(), moved.height()) / 150);
  share = blurred_and_turned(blurred_and_turned(share, radius), radius);
  Image<std::uint8_t> mask(moved.width(), moved.height());
  std::transform(share.values().begin(), share.values().end(), mask.values().begin(), [](float s) {
    const double t = std::clamp((s - kSmoothFrom) / (kSmoothTo - kSmoothFrom), 0.0, 1.0);
    return static_cast<std::uint8_t>(std::lround(255 * (1 - t * t * (3 - 2 * t))));
  });
  return mask;
}

}  // namespace

Deghosting deghost(const Exposures& bracket, const Response& response, const DeghostOptions& options, const Run& run) {
  check(bracket.size() >= 2, "deghosting takes an arranged bracket");
  const Comparison comparison(bracket, response, options.trusted);
  Deghosting result;
  result.reference = best_exposed(comparison, run);
  result.noise_codes = measured_noise(comparison, result.reference);

  result.masks.assign(bracket.size(), Image<std::uint8_t>(comparison.width(), comparison.height()));
  const double limit = options.threshold * result.noise_codes;
  for_each_block(run, "looking for what moved", comparison.height(), 1, [&](Block block) {
    const std::vector<Row> rows = comparison.rows_at(block.begin);
    for (int x = 0; x < comparison.width(); ++x) {
      comparison.compare(rows, x, result.reference, [&](int k, float difference) {
        if (difference > limit) result.masks[k](x, block.begin) = 1;
      });
    }
  });
  result.left_out.resize(bracket.size());
  for_each_block(run, "", comparison.count(), 1, [&](Block block) {
    Image<std::uint8_t>& mask = result.masks[block.begin];
    mask = smooth_mask(mask);
    const auto low = std::count_if(mask.values().begin(), mask.values().end(), [](std::uint8_t m) { return m < 128; });
    result.left_out[block.begin] = static_cast<double>(low) / static_cast<double>(mask.size());
  });
  return result;
}

}  // namespace zonal
