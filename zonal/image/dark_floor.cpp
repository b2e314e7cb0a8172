#include "zonal/image/dark_floor.h"

#include <algorithm>
#include <cmath>

namespace zonal {
namespace {

constexpr double kLeastRise = 0.15;  // of the code, for each stop
constexpr int kHighestFloor = 64;
constexpr double kFewestTexels = 32;
constexpr int kHighestRise = 250;  // beyond it the longer exposure saturates and says nothing

/// For each code, how many pairs of neighbouring exposures start there, and the sums of their rises and stops.
struct Rises {
  ResponseCurve pairs = {}, rise = {}, stops = {};
};

Rises rises_of(const CodeSamples& samples, int channel) {
  Rises rises;
  for (int i = 0; i < samples.pixels(); ++i) {
    const auto codes = samples.of(channel, i);
    for (std::size_t k = 0; k + 1 < codes.size(); ++k) {
      if (codes[k + 1] > kHighestRise) break;
      rises.pairs[codes[k]] += 1;
      rises.rise[codes[k]] += codes[k + 1] - codes[k];
      rises.stops[codes[k]] += std::log2(samples.seconds[k + 1] / samples.seconds[k]);
    }
  }
  return rises;
}

int floor_of(const Rises& rises) {
  int floor = 0;
  double pairs = 0, rise = 0, expected = 0;
  for (int z = 1; z <= kHighestFloor; ++z) {
    pairs += rises.pairs[z];
    rise += rises.rise[z];
    expected += kLeastRise * z * rises.stops[z];
    if (pairs < kFewestTexels) continue;
    if (rise < expected) floor = z;
    pairs = rise = expected = 0;
  }
  return floor;
}

}  // namespace

TrustedRanges find_trusted_codes(const CodeSamples& samples) {
  TrustedRanges trusted;
  for (int c = 0; c < 3; ++c) trusted[c].lowest = floor_of(rises_of(samples, c));
  return trusted;
}

}  // namespace zonal
