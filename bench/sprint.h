#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace zonal::bench {

/// One way of doing `items` small things, in about 10 to 1000 microseconds. It returns a number made from its output.
struct Runner {
  std::string name;
  long items;
  std::function<double()> work;
};

/// The shortest time of each runner in nanoseconds an item. Run in turn, many times over: what takes nanoseconds is
/// disturbed by everything else on the machine, and never made faster by it. Prints each with its ratio to the first,
/// the baseline.
std::vector<double> sprint(std::string_view title, const std::vector<Runner>& runners, int rounds = 400);

}  // namespace zonal::bench
