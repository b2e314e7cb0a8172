#include "zonal/sh/nonnegative.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "zonal/base/error.h"
#include "zonal/sh/jet.h"
#include "zonal/sh/minimum.h"

namespace zonal {
namespace {

double mean(const Sh<double>& sh) { return sh[0] / std::sqrt(4 * kPi); }

/// Strength 0 is no window; more is stronger.
Window of_strength(WindowKind family, double strength) {
  if (strength == 0) return Window::none();
  if (family == WindowKind::kHann) return Window::hann(1 / strength);
  if (family == WindowKind::kLanczos) return Window::lanczos(1 / strength);
  return Window::laplacian(strength);
}

struct Strengths {
  double weakest, strongest;
};

/// A strength that does next to nothing, and one that cannot fail.
Strengths strengths(const std::vector<Sh<double>>& channels, WindowKind family) {
  const int bands = channels.front().bands();
  if (family != WindowKind::kLaplacian) return {1 / (64.0 * bands), 1};  // a width of one band leaves the mean
  // Every band from 1 on shrinks by 1 + 4 weight at least.
  double worst = 1;
  for (const Sh<double>& channel : channels) {
    const double variation = derivative_bound(channel, 0);
    if (variation == 0) continue;
    if (mean(channel) == 0) {
      throw Error(ErrorKind::kInput, "no Laplacian window makes a function with a mean of zero non-negative",
                  "a Hann or Lanczos window can remove it wholly");
    }
    worst = std::max(worst, variation / mean(channel));
  }
  const double stiffest = std::pow(static_cast<double>(bands) * (bands - 1), 2);
  const double strongest = std::max(worst / 4, std::numeric_limits<double>::min());
  return {std::min(1e-4 / std::max(stiffest, 1.0), strongest), strongest};
}

class Question {
 public:
  Question(const std::vector<Sh<double>>& channels, const NonNegativeOptions& options)
      : channels_(channels), options_(options) {}

  /// Is the function non-negative under the window of this strength? The answer holds what is known about it.
  bool ask(double strength) {
    NonNegativeWindow answer = {.window = of_strength(options_.family, strength),
                                .minimum_found = std::numeric_limits<double>::infinity(),
                                .guaranteed_minimum = std::numeric_limits<double>::infinity()};
    for (const Sh<double>& channel : channels_) {
      const double allowed = options_.tolerance * mean(channel);
      const Sh<double> windowed = zonal::window(channel, answer.window);
      // A mean of zero allows nothing; then the depth of the search is a matter of the function's size.
      const double tolerance = std::max(allowed / 2, 1e-9 * derivative_bound(windowed, 0));
      Minimum minimum;
      if (tolerance > 0) minimum = certified_minimum(windowed, {.tolerance = tolerance, .enough = -allowed});
      answer.minimum_found = std::min(answer.minimum_found, minimum.found);
      answer.guaranteed_minimum = std::min(answer.guaranteed_minimum, minimum.guaranteed);
      if (minimum.guaranteed < -allowed) return false;
    }
    answer_ = answer;
    return true;
  }
  /// Of the last question that was answered yes.
  const NonNegativeWindow& answer() const { return answer_; }

 private:
  const std::vector<Sh<double>>& channels_;
  const NonNegativeOptions& options_;
  NonNegativeWindow answer_;
};

}  // namespace

NonNegativeWindow nonnegative_window(const std::vector<Sh<double>>& channels, const NonNegativeOptions& options) {
  check(!channels.empty() && channels.front().bands() >= 1, "a function of at least one band");
  check(options.tolerance > 0, "the tolerance of a non-negative function is above 0");
  if (options.family != WindowKind::kHann && options.family != WindowKind::kLanczos &&
      options.family != WindowKind::kLaplacian) {
    throw Error(ErrorKind::kUsage, "a non-negative window is a Hann, a Lanczos or a Laplacian window");
  }
  for (const Sh<double>& channel : channels) {
    check(channel.bands() == channels.front().bands(), "channels of the same number of bands");
    if (!std::isfinite(derivative_bound(channel, 0)) || !std::isfinite(channel[0])) {
      throw Error(ErrorKind::kInput, "a coefficient of the function is not finite");
    }
    if (mean(channel) < 0) {
      throw Error(ErrorKind::kInput, "no window makes a function with a negative mean non-negative",
                  "windows keep the mean; the lighting itself is negative");
    }
  }
  Question question(channels, options);
  if (question.ask(0)) return question.answer();

  const auto [weakest, strongest] = strengths(channels, options.family);
  constexpr int kSteps = 32;
  double fails = 0, succeeds = strongest;
  for (int step = 0; step <= kSteps; ++step) {
    const double strength = step == kSteps ? strongest : weakest * std::pow(strongest / weakest, 1.0 * step / kSteps);
    if (question.ask(strength)) {
      succeeds = strength;
      break;
    }
    check(step < kSteps, "the strongest window leaves nothing negative");
    fails = strength;
  }
  while (succeeds - fails > 1e-5 * succeeds) {
    const double middle = (fails + succeeds) / 2;
    (question.ask(middle) ? succeeds : fails) = middle;
  }
  return question.answer();
}

}  // namespace zonal
