#pragma once

#include <vector>

#include "zonal/base/run.h"
#include "zonal/light/environment.h"
#include "zonal/light/render_kernel.h"
#include "zonal/sh/sh.h"

namespace zonal {

/// The function with these coefficients at every texel centre of a picture; texels that show nothing are black.
/// Equirectangular pictures are synthesised directly; the others are read from a ring grid (RingReader) whose error is
/// below 1e-6 of the greatest value the function can have. Throws Error{kInput} when the size does not fit the
/// projection, Error{kCancelled}.
Environment render(const Sh<RgbD>&, const Projection&, ImageSize, const Run& = {});

/// What a convolution makes of the constant 1 on the grid of its source: nearly 1. It depends on θ alone, given by its
/// coefficients of m = 0, as long as there are no more bands than columns; else it is whole.
struct GridWeight {
  std::vector<double> zonal;
  Sh<RgbD> whole;
};

/// A band-limited function on the sphere, synthesised once on a ring grid so fine that six-point interpolation between
/// its texels stays below a stated error.
class RingReader {
 public:
  /// `tolerance` is what the interpolation may be wrong by at most, in the function's unit; the grid grows until it is
  /// met, within limits of memory (at 2048 bands half a gigabyte). `weight` is a second function, grey and as smooth,
  /// that is read along with the first.
  RingReader(const Sh<RgbD>&, double tolerance, const Run&, const GridWeight& weight = {});

  /// The bound that was reached: the sum over bands of the most the band can be, times Lagrange's remainder at its
  /// frequency.
  double error_bound() const { return error_bound_; }

  /// Values in the unit directions (x[i], y[i], z[i]) as interleaved RGB, and of the second function.
  void read(const double* x, const double* y, const double* z, int count, float* out, float* weight) const;

 private:
  BorderedGrid grid() const { return {width_, height_, texels_.data()}; }

  const RenderKernels* kernels_;
  int width_ = 0, height_ = 0;
  std::vector<float> texels_;
  double error_bound_ = 0;
};

/// The greatest value that each band of a function can take in any channel: sqrt((2l+1)/4π) times the band's norm.
std::vector<double> band_maxima(const Sh<RgbD>&);

}  // namespace zonal
