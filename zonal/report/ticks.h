#pragma once

#include <string>
#include <vector>

namespace zonal {

/// A closed interval of an axis, lo < hi.
struct AxisRange {
  double lo = 0, hi = 1;
  bool operator==(const AxisRange&) const = default;
};

/// Round marks of an axis and how to write them.
struct Ticks {
  std::vector<double> at;
  std::vector<std::string> labels;  ///< one for each mark, in one format
};

/// The smallest range with room: values that are all equal get a range around them, never an empty one. lo <= hi, both
/// finite (and positive for a logarithmic axis), or std::logic_error.
AxisRange axis_range(double lo, double hi, bool log);

/// Multiples of 1, 2 or 5 times a power of ten inside the range: two of them at least, `at_most` at most. at_most >= 6:
/// steps grow by up to 2.5 at once. `whole` refuses fractions (it may then find fewer than two).
Ticks linear_ticks(AxisRange, int at_most, bool whole = false);

/// Powers of ten inside the range, every k-th when there are many; below two of them, linear ticks. lo > 0.
Ticks log_ticks(AxisRange, int at_most);

}  // namespace zonal
