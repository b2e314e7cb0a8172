#pragma once

#include <vector>

#include "zonal/light/split_level.h"

namespace zonal {

/// A compact bright set of texels.
struct Source {
  std::vector<Texel> texels;  ///< the brightest first
  double level = 0;           ///< the brightness over which they are
  double energy = 0;          ///< about, in luminance: above what it rises from where that is bright too
};

struct SourceLimits {
  double threshold = 0;    ///< the brightness over which the texels were collected
  double max_size_sr = 0;  ///< a source has at most this solid angle
  double min_energy = 0;   ///< and at least this energy
};

/// Adds the texels to a growing set from the brightest down (the max-tree of Salembier et al. 1998). While a component
/// stays under the size it is one source, or several where the peaks on either side of a saddle are 4 times as bright
/// as the saddle. When it would outgrow the size, its peak must be 4 times as bright as the texel it would have taken
/// in, and what is twice as bright as that texel is the source: closer to it there is the grain of what surrounds it.
/// Strips whose light is spread wider, in the mean square, than that of the largest disc are left out. The strongest
/// first.
std::vector<Source> find_sources(const BrightTexels&, const Mapping&, const SourceLimits&);

/// Calls f for the up to 8 texels around, across every seam of the picture. One may come twice.
template <class F>
void for_each_neighbour(const Mapping& mapping, Texel t, const F& f) {
  const int chart = mapping.chart(center_of(t));
  for (int k = 0; k < 9; ++k) {
    const Texel n = mapping.wrap(chart, t.x + k % 3 - 1, t.y + k / 3 - 1);
    if (!(n == t)) f(n);
  }
}

}  // namespace zonal
