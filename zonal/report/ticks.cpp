#include "zonal/report/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "zonal/base/check.h"
#include "zonal/report/text.h"

namespace zonal {
namespace {

/// Of the leading digit of a value that is not zero.
int exponent_of(double value) {
  return static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9));  // log10 may miss a power by an ulp
}

/// The smallest of 1, 2, 5, 10 ... times a power of ten that is at least `step`.
double round_up_step(double step) {
  const double decade = std::pow(10, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * decade >= step * (1 - 1e-9)) return factor * decade;  // 1e-9: pow and log10 may miss a power by an ulp
  }
  return 10 * decade;
}

/// Marks of one axis share their decimals, so that the points stand below each other.
std::string linear_label(double value, double step, double largest) {
  if (largest >= 1e6 || step < 1e-4) {
    // Down to the digit that the step changes.
    const int digits = value == 0 ? 1 : exponent_of(value) - exponent_of(step) + 1;
    return number(value, std::clamp(digits, 1, 15));
  }
  const int decimals = std::max(0, -exponent_of(step));
  return fmt::format("{}{:.{}f}", value < 0 ? "\u2212" : "", std::abs(value), decimals);
}

}  // namespace

AxisRange axis_range(double lo, double hi, bool log) {
  check(std::isfinite(lo) && std::isfinite(hi), "an axis needs finite values");
  check(lo <= hi, "an axis needs lo <= hi");
  if (log) {
    check(lo > 0, "a logarithmic axis needs positive values");
    // A factor of two each way, or what is left of the range of double.
    if (hi / lo < 1 + 1e-9) return {std::max(lo / 2, 1e-300), std::min(hi, 1e300) * 2};
    return {lo, hi};
  }
  const double size = std::max(std::abs(lo), std::abs(hi));
  if (size == 0) return {0, 1};
  // A range below the resolution of its numbers has no marks to tell apart.
  if (hi / 2 - lo / 2 <= 1e-12 * size) return {lo - size / 10, hi + size / 10};
  return {lo, hi};
}

Ticks linear_ticks(AxisRange range, int at_most, bool whole) {
  check(std::isfinite(range.lo) && std::isfinite(range.hi) && range.lo < range.hi,
        "ticks need a finite range, lo < hi");
  check(at_most >= 6, "at_most must be at least 6");
  // Divided first: the difference of two huge values may overflow.
  double step = round_up_step(range.hi / (at_most - 1) - range.lo / (at_most - 1));
  if (whole) step = std::max(step, 1.0);
  Ticks ticks;
  const double first = std::ceil(range.lo / step - 1e-9), last = std::floor(range.hi / step + 1e-9);
  const double largest = std::max(std::abs(range.lo), std::abs(range.hi));
  const int count = static_cast<int>(last - first) + 1;
  for (int i = 0; i < count; ++i) {
    const double value = (first + i) * step + 0.0;  // + 0.0: no negative zero
    ticks.at.push_back(value);
    ticks.labels.push_back(linear_label(value, step, largest));
  }
  return ticks;
}

Ticks log_ticks(AxisRange range, int at_most) {
  check(range.lo > 0 && std::isfinite(range.hi) && range.lo < range.hi, "log ticks need 0 < lo < hi");
  check(at_most >= 6, "at_most must be at least 6");
  const int first = static_cast<int>(std::ceil(std::log10(range.lo) - 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(range.hi) + 1e-9));
  if (last - first < 1) return linear_ticks(range, at_most);
  const int stride = (last - first) / at_most + 1;
  Ticks ticks;
  for (int exponent = first; exponent <= last; exponent += stride) {
    ticks.at.push_back(std::pow(10, exponent));
    ticks.labels.push_back(exponent >= -2 && exponent <= 3 ? fmt::format("{:g}", std::pow(10, exponent))
                                                           : power_of_ten(exponent));
  }
  return ticks;
}

}  // namespace zonal
