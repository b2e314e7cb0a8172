#pragma once

#include "zonal/base/kernel.h"

namespace zonal {

/// An equirectangular grid with a border, ready for six-point interpolation without a branch: texels[row][column] as
/// four floats, red, green, blue and any fourth quantity, kBorder rows and columns beyond each edge.
struct BorderedGrid {
  static constexpr int kBorder = 3;
  int width, height;    // without the border
  const float* texels;  // of the first border texel
  long row_stride() const { return 4L * (width + 2 * kBorder); }
};

/// One texel that is convolved by itself: its direction, and its radiance times its solid angle.
struct PointLight {
  double x, y, z;
  float r, g, b;
};

/// scale max(c, 0) / (a + b versine)², versine = 1 - c: the cosine and GGX.
struct RationalLobe {
  double scale, a, b;
};

/// The inner loops of rendering, compiled once per instruction set. Directions are three arrays; out is interleaved
/// RGB, fourth the grid's other quantity.
struct RenderKernels {
  /// Reads the grid at each direction, by Lagrange's six-point polynomial along both axes.
  void (*interpolate)(const BorderedGrid& grid, const double* x, const double* y, const double* z, int count,
                      float* out, float* fourth);
  /// out += Σ over lights of lobe(direction . light) times its colour.
  void (*add_points)(const RationalLobe& lobe, const PointLight* lights, int light_count, const double* x,
                     const double* y, const double* z, int count, float* out);
};
ZONAL_KERNELS(RenderKernels, kRenderKernels, render_kernels);

}  // namespace zonal
