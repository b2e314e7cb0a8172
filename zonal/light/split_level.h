#pragma once

#include <vector>

#include "zonal/base/run.h"
#include "zonal/light/environment.h"
#include "zonal/sphere/mapping.h"

namespace zonal {

/// Rec. 709 luminance, no less than 0: what counts as bright.
inline double brightness(Rgb c) {
  const double light = luminance(RgbD(c));
  return light > 0 ? light : 0;
}

/// What is bright in a picture.
struct BrightLevel {
  double threshold = 0;  ///< `times` the mean brightness of the texels that are no brighter than this
  double mean = 0;       ///< mean brightness of all
  double maximum = 0;
};

/// Found by iteration from above, on a histogram with bins 3 % wide: the threshold belongs to a set of texels that is
/// whole bins. Throws Error{kInput} when a value that is shown is not finite.
BrightLevel bright_level(const Environment&, const Mapping&, double times, const Run&);

/// A texel brighter than the threshold.
struct BrightTexel {
  Texel texel;
  double brightness = 0;
  double solid_angle = 0;
};

/// All of them, row by row; they are few, and found by their place.
class BrightTexels {
 public:
  BrightTexels(const Environment&, const Mapping&, double threshold, const Run&);

  std::size_t size() const { return texels_.size(); }
  const BrightTexel& operator[](std::size_t i) const { return texels_[i]; }
  /// The index of a texel, -1 for one that is not bright.
  int find(Texel) const;

 private:
  std::vector<BrightTexel> texels_;
  std::vector<std::size_t> row_begin_;
};

}  // namespace zonal
