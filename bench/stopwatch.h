#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace zonal::bench {

/// One way of doing a piece of work. It returns a number made from its whole output, so that nothing can be left out.
struct Contender {
  std::string name;
  std::function<double()> work;
};

/// Runs the contenders in turn, `rounds` times over, and prints the median of each and its ratio to the first, the
/// baseline. Interleaved, because the machine's speed drifts: only ratios of one run mean something. Returns the
/// medians in milliseconds.
std::vector<double> race(std::string_view title, const std::vector<Contender>& contenders, int rounds = 7);

}  // namespace zonal::bench
