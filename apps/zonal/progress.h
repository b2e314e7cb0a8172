#pragma once

#include <chrono>
#include <string_view>

namespace zonal {

/// A line on a terminal that says how far a stage is. Drawn a few times a second at most, gone when cleared.
class ProgressBar {
 public:
  /// Whether standard error is a terminal; nothing is ever drawn elsewhere.
  static bool possible();

  void show(std::string_view stage, double fraction);
  void clear();

 private:
  std::chrono::steady_clock::time_point last_ = {};
  bool drawn_ = false;
};

}  // namespace zonal
