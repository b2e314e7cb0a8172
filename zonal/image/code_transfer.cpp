#include "zonal/image/code_transfer.h"

#include <algorithm>

namespace zonal {
namespace {

/// Codes outside of these are black or saturated, or one code of noise away from it.
constexpr int kBlack = 2, kSaturated = 252;

/// For each code, how many texels are darker, half of those at the code counted with them.
std::array<double, kGreyLevels> ranks_of(const GreyHistogram& histogram) {
  std::array<double, kGreyLevels> ranks = {};
  double below = 0, total = 0;
  for (const std::int64_t n : histogram) total += static_cast<double>(n);
  for (int z = 0; z < kGreyLevels; ++z) {
    const auto here = static_cast<double>(histogram[z]);
    ranks[z] = (below + here / 2) / std::max(1.0, total);
    below += here;
  }
  return ranks;
}

/// The code with a rank, between codes by a straight line.
float code_of(double rank, const std::array<double, kGreyLevels>& ranks) {
  const auto above = std::lower_bound(ranks.begin(), ranks.end(), rank);
  if (above == ranks.begin()) return 0;
  if (above == ranks.end()) return kGreyLevels - 1;
  const auto z = static_cast<double>(above - ranks.begin());
  const double lower = *(above - 1);
  return static_cast<float>(z - (*above - rank) / (*above - lower));
}

}  // namespace

CodeTransfer transfer_codes(const GreyHistogram& shorter, const GreyHistogram& longer) {
  const std::array<double, kGreyLevels> to = ranks_of(shorter), from = ranks_of(longer);
  CodeTransfer transfer;
  for (int z = 0; z < kGreyLevels; ++z) {
    transfer.shorter[z] = static_cast<float>(z);
    transfer.longer[z] = code_of(from[z], to);
  }
  const float lowest = std::max(transfer.longer[kBlack], static_cast<float>(kBlack)),
              highest = std::min(transfer.longer[kSaturated], static_cast<float>(kSaturated));
  transfer.range = std::max(0.0f, highest - lowest);
  for (auto* table : {&transfer.shorter, &transfer.longer}) {
    for (float& code : *table) code = std::clamp(code, std::min(lowest, highest), highest);
  }
  return transfer;
}

}  // namespace zonal
