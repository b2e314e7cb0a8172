#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "zonal/base/run.h"
#include "zonal/image/exposures.h"

namespace zonal {

/// The codes of some texels in every exposure of a bracket: what a response is estimated from. Pictures with more than
/// 8 bits are rounded: to the estimator half a code of noise is little.
struct CodeSamples {
  std::vector<double> seconds;                     ///< of each exposure, rising
  std::array<std::vector<std::uint8_t>, 3> codes;  ///< [channel][pixel * exposures + exposure]

  int exposures() const { return static_cast<int>(seconds.size()); }
  int pixels() const { return static_cast<int>(codes[0].size() / seconds.size()); }
  /// One texel's codes, one for each exposure.
  std::span<const std::uint8_t> of(int channel, int pixel) const {
    return std::span(codes[channel]).subspan(static_cast<std::size_t>(pixel) * seconds.size(), seconds.size());
  }
};

/// About `count` texels for a direct solution, or fewer where the pictures have no more good ones. Candidates on a
/// regular grid; kept are, evenly over all brightnesses, those whose neighbourhood of 3x3 is flattest in all exposures
/// (there a small misalignment, sharpening or JPEG's blocks do least harm) and whose code never falls by more than 8 as
/// the exposure grows (nothing moved there). Texels without data in some exposure are left out. An arranged bracket.
CodeSamples sample_flat_texels(const Exposures&, int count, const Run& = {});

/// Every n-th texel of every n-th row, n the smallest that gives at most `at_most`; 0: all texels. Those without data
/// in some exposure are left out.
CodeSamples sample_all_texels(const Exposures&, int at_most, const Run& = {});

}  // namespace zonal
