#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "zonal/base/run.h"
#include "zonal/light/environment.h"
#include "zonal/light/lobe.h"
#include "zonal/sh/sh.h"

namespace zonal {

struct ConvolveOptions {
  /// The error bound to aim for, relative to the map's mean brightness.
  double tolerance = 1e-3;
  /// Bands are taken as the lobe's tail asks for them, up to this many and up to twice the rows of the map (but 512),
  /// for what is finer than half a texel is not in it. A lobe too sharp for them is widened by what they resolve (0.18
  /// degrees for 2048 bands, a texel of a map of as many columns), and the report says so.
  int max_bands = 2048;
  /// At most this many texels (a sun's, a lamp's) are convolved exactly one by one instead of with the bands.
  int max_points = 256;
};

/// What one convolution did and how wrong it can be. Brightness is the largest absolute channel.
struct ConvolveReport {
  int bands = 0;
  int points = 0;            ///< texels convolved one by one
  double widened_deg = 0;    ///< width of the Gaussian that a lobe too sharp for max_bands was blurred with; else 0
  double error_bound = 0;    ///< on any channel in any direction, in the map's unit: truncation and interpolation
  double bound_to_mean = 0;  ///< the same over the mean brightness of the map
  double bound_to_peak = 0;  ///< the same over its greatest
  std::int64_t zeroed_texels = 0;  ///< results below zero within the bound, from a map without negatives, set to zero
  double zeroed_depth = 0;         ///< the deepest of them
};

struct Convolved {
  Environment map;
  ConvolveReport report;
};

/// An environment made ready to be convolved with some lobes: analysed once, for as many bands as they need.
///
/// The result in direction n is the mean over texels, weighted by solid angle times the lobe's kernel (the sum of the
/// weights is one but for the grid's coarseness, and dividing by it keeps a constant sky constant on any grid). The sum
/// is zonal, so each band l is multiplied by the lobe's factor λ_l. A few texels that hold much of the energy (suns)
/// are taken out first and their lobe is added exactly, so that nothing rings around them. The bound: with e the kernel
/// that the bands leave out, |error(n)| = |Σ f e(n·s)| is at most what the brightest texels meeting the largest |e|
/// give (rearrangement_bound). docs/notes/convolution.md.
class Convolution {
 public:
  /// Other projections than equirectangular are resampled to one first. Throws Error{kInput} for values that are not
  /// finite, Error{kCancelled}.
  Convolution(const Environment&, std::span<const Lobe>, const ConvolveOptions& = {}, const Run& = {});
  ~Convolution();
  Convolution(Convolution&&) noexcept;

  /// The environment seen through lobes[i], at the texel centres of a picture. Texels that show nothing are black.
  Convolved render(int i, const Projection&, ImageSize, const Run& = {}) const;

  /// The coefficients of what is left without the points (with them where every lobe is widened), for all bands that
  /// were analysed.
  const Sh<RgbD>& coefficients() const;

 private:
  struct State;
  std::unique_ptr<const State> state_;
};

/// One lobe, one picture.
Convolved convolve(const Environment&, const Lobe&, const Projection&, ImageSize, const ConvolveOptions& = {},
                   const Run& = {});

/// An equirectangular copy whose texels are no larger than the environment's; the environment itself where it is
/// equirectangular.
Environment as_equirect(const Environment&, const Run& = {});

}  // namespace zonal
