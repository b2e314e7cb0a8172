#pragma once

#include <span>

#include "zonal/base/grid.h"
#include "zonal/base/run.h"
#include "zonal/math/vec.h"
#include "zonal/sh/sh.h"
#include "zonal/sht/ring_grid.h"

namespace zonal {

/// Coefficients of an equirectangular map: f_lm = Σ over texels of f w y_lm, w = `weights`, y_lm the real basis about
/// +Z without Condon-Shortley sign. With kTexelArea this is exact for the sum over texels at any number of bands; with
/// kFejer it is the integral for every function whose bands and `bands` together are at most the rows plus one, and the
/// columns (products of degree below the rows are what Fejér's rule integrates exactly). Double throughout; rounding
/// error about 1e-13 of the root mean square for 1000 bands. O(width height log width + bands² height). Same
/// bits for any number of threads. Texels in `left_out` count as zero. Throws Error{kCancelled}.
Sh<RgbD> analyze(const Grid<Rgb>& map, int bands, RingWeights weights, const Run& run = {},
                 std::span<const GridTexel> left_out = {});
Sh<RgbD> analyze(const Grid<RgbD>& map, int bands, RingWeights weights, const Run& run = {});

/// The map Σ f_lm y_lm at the texel centres of an equirectangular grid. The inverse of analyze(kFejer) for up to half
/// as many bands as rows, and (without the weights) its adjoint. Same cost and promises.
Grid<Rgb> synthesize(const Sh<RgbD>& coefficients, RingGrid grid, const Run& run = {});
Grid<RgbD> synthesize_double(const Sh<RgbD>& coefficients, RingGrid grid, const Run& run = {});

/// The same into a map that is there already, of its size: memory that is used again costs nothing, fresh memory as much
/// as the work.
void synthesize(const Sh<RgbD>& coefficients, Grid<Rgb>& map, const Run& run = {});
void synthesize(const Sh<RgbD>& coefficients, Grid<RgbD>& map, const Run& run = {});

}  // namespace zonal
