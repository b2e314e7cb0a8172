#include "bench/stopwatch.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace zonal::bench {

std::vector<double> race(std::string_view title, const std::vector<Contender>& contenders, int rounds) {
  using Clock = std::chrono::steady_clock;
  std::vector<std::vector<double>> times(contenders.size());
  volatile double consumed = 0;
  for (int round = -1; round < rounds; ++round) {  // the first one warms up
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      const auto begin = Clock::now();
      consumed = consumed + contenders[i].work();
      const std::chrono::duration<double, std::milli> taken = Clock::now() - begin;
      if (round >= 0) times[i].push_back(taken.count());
    }
  }
  std::printf("\n%.*s\n", static_cast<int>(title.size()), title.data());
  std::vector<double> medians;
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    std::nth_element(times[i].begin(), times[i].begin() + rounds / 2, times[i].end());
    medians.push_back(times[i][rounds / 2]);
    std::printf("  %-44s %10.3f ms   %8.2f x\n", contenders[i].name.c_str(), medians[i], medians[i] / medians[0]);
  }
  return medians;
}

}  // namespace zonal::bench
