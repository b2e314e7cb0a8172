#include "zonal/sh/gaunt.h"

#include <array>
#include <cstddef>

#include "zonal/base/check.h"
#include "zonal/sh/gaunt_list.h"

namespace zonal {
namespace {

constexpr int kBands = kMaxStaticBands;

/// k leads the order, so the integrals of fewer bands come first.
constexpr std::array<std::size_t, kBands + 1> kCounts = [] {
  std::array<std::size_t, kBands + 1> counts = {};
  for (int bands = 1; bands <= kBands; ++bands) {
    for (const GauntIntegral& g : kGauntList<kBands>) {
      counts[static_cast<std::size_t>(bands)] += g.k < coefficient_count(bands);
    }
  }
  return counts;
}();

}  // namespace

std::span<const GauntIntegral> gaunt_integrals(int bands) {
  check(1 <= bands && bands <= kBands, "Gaunt integrals are listed for 1 to 6 bands");
  return std::span(kGauntList<kBands>).first(kCounts[static_cast<std::size_t>(bands)]);
}

}  // namespace zonal
