#pragma once

#include <span>

#include "zonal/base/grid.h"
#include "zonal/base/run.h"
#include "zonal/math/vec.h"
#include "zonal/sht/ring_grid.h"
#include "zonal/sht/spectrum.h"

namespace zonal {

/// The half of the transform that runs along rings: from a map to the cosine and sine sums of each pair of rings,
/// weighted, for m < bands, and back. Texels in `left_out` count as zero. Parallel over blocks of rings.
void analyze_rings(const Grid<Rgb>& map, int bands, RingWeights, std::span<const GridTexel> left_out, RingSpectrum&,
                   const Run&);
void analyze_rings(const Grid<RgbD>& map, int bands, RingWeights, std::span<const GridTexel> left_out, RingSpectrum&,
                   const Run&);
void synthesize_rings(RingSpectrum&, int bands, Grid<Rgb>& map, const Run&);
void synthesize_rings(RingSpectrum&, int bands, Grid<RgbD>& map, const Run&);

}  // namespace zonal
