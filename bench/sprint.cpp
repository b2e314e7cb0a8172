#include "bench/sprint.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>

namespace zonal::bench {

std::vector<double> sprint(std::string_view title, const std::vector<Runner>& runners, int rounds) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> shortest(runners.size(), std::numeric_limits<double>::infinity());
  volatile double consumed = 0;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < runners.size(); ++i) {
      const auto begin = Clock::now();
      consumed = consumed + runners[i].work();
      const std::chrono::duration<double, std::nano> taken = Clock::now() - begin;
      shortest[i] = std::min(shortest[i], taken.count() / static_cast<double>(runners[i].items));
    }
  }
  std::printf("\n%.*s\n", static_cast<int>(title.size()), title.data());
  for (std::size_t i = 0; i < runners.size(); ++i) {
    std::printf("  %-48s %9.2f ns   %8.3f x\n", runners[i].name.c_str(), shortest[i], shortest[i] / shortest[0]);
  }
  return shortest;
}

}  // namespace zonal::bench
