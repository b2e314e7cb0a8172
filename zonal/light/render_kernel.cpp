// Compiled once per instruction set: nothing here but the loops (see cmake/zonal.cmake).
#include "zonal/light/render_kernel.h"

namespace zonal::ZONAL_ISA {
namespace {

constexpr int kLanes = ZONAL_LANES;
using Vec = double __attribute__((vector_size(kLanes * sizeof(double))));
using Texel = float __attribute__((vector_size(16)));
using TexelPair = float __attribute__((vector_size(32)));

constexpr double kPi = 3.14159265358979323846;

inline Vec load(const double* p) {
  Vec v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}

/// The loop is written out for the compiler: there is no vector square root in the language.
inline Vec square_root(Vec v) {
  Vec root;
  for (int i = 0; i < kLanes; ++i) root[i] = __builtin_sqrt(v[i]);
  return root;
}

/// atan2(y, x) to 1e-12: the angle is halved twice, tan(φ/2) = t / (1 + sqrt(1 + t²)), then the series of the arc tangent.
inline Vec azimuth(Vec y, Vec x) {
  const Vec ay = y < 0 ? -y : y, ax = x < 0 ? -x : x;
  const auto steep = ay > ax;
  const Vec large = steep ? ay : ax, small = steep ? ax : ay;
  Vec t = small / (large > 0 ? large : Vec{} + 1);
  t = t / (1 + square_root(1 + t * t));
  t = t / (1 + square_root(1 + t * t));
  const Vec u = t * t;
  Vec series = Vec{};
  for (int k = 8; k >= 0; --k) series = (k % 2 == 0 ? 1.0 : -1.0) / (2 * k + 1) + u * series;
  Vec angle = 4 * (t * series);
  angle = steep ? kPi / 2 - angle : angle;
  angle = x < 0 ? kPi - angle : angle;
  return y < 0 ? -angle : angle;
}

/// Lagrange's weights for the points -2..3 at f in [0, 1).
inline void six_weights(float f, float (&w)[6]) {
  const float a = f + 2, b = f + 1, c = f, d = f - 1, e = f - 2, g = f - 3;
  const float ab = a * b, cd = c * d, eg = e * g;
  w[0] = b * cd * eg * (-1.0f / 120);
  w[1] = a * cd * eg * (1.0f / 24);
  w[2] = ab * d * eg * (-1.0f / 12);
  w[3] = ab * c * eg * (1.0f / 12);
  w[4] = ab * cd * g * (-1.0f / 24);
  w[5] = ab * cd * e * (1.0f / 120);
}

inline Texel read(const BorderedGrid& grid, double column, double row) {
  // Centres are at +1/2; the grid is not left by more than the border for any direction.
  const double x = column - 0.5, y = row - 0.5;
  const int left = static_cast<int>(x + 2) - 2, top = static_cast<int>(y + 2) - 2;  // floor, x > -2
  float wx[6], wy[6];
  six_weights(static_cast<float>(x - left), wx);
  six_weights(static_cast<float>(y - top), wy);
  TexelPair across[3];
  for (int i = 0; i < 3; ++i) {
    const float a = wx[2 * i], b = wx[2 * i + 1];
    across[i] = TexelPair{a, a, a, a, b, b, b, b};
  }
  const float* corner = grid.texels + (top + BorderedGrid::kBorder - 2) * grid.row_stride() +
                        4L * (left + BorderedGrid::kBorder - 2);
  TexelPair sum = {};
  for (int j = 0; j < 6; ++j, corner += grid.row_stride()) {
    TexelPair row_sum = {};
    for (int i = 0; i < 3; ++i) {
      TexelPair texels;
      __builtin_memcpy(&texels, corner + 8 * i, sizeof texels);
      row_sum += across[i] * texels;
    }
    sum += wy[j] * row_sum;
  }
  return Texel{sum[0] + sum[4], sum[1] + sum[5], sum[2] + sum[6], sum[3] + sum[7]};
}

void interpolate(const BorderedGrid& grid, const double* x, const double* y, const double* z, int count, float* out,
                 float* fourth) {
  double padded[3][kLanes];
  for (int i = 0; i < count; i += kLanes) {
    const int n = count - i < kLanes ? count - i : kLanes;
    const double* in[3] = {x + i, y + i, z + i};
    if (n < kLanes) {
      for (int axis = 0; axis < 3; ++axis) {
        for (int k = 0; k < kLanes; ++k) padded[axis][k] = k < n ? in[axis][k] : 1;
        in[axis] = padded[axis];
      }
    }
    const Vec vx = load(in[0]), vy = load(in[1]), vz = load(in[2]);
    const Vec phi = azimuth(vy, vx), theta = azimuth(square_root(vx * vx + vy * vy), vz);
    const Vec column = (0.5 - phi * (0.5 / kPi)) * grid.width, row = theta * (1 / kPi) * grid.height;
    for (int k = 0; k < n; ++k) {
      const Texel texel = read(grid, column[k], row[k]);
      for (int c = 0; c < 3; ++c) out[3 * (i + k) + c] = texel[c];
      fourth[i + k] = texel[3];
    }
  }
}

void add_points(const RationalLobe& lobe, const PointLight* lights, int light_count, const double* x, const double* y,
                const double* z, int count, float* out) {
  constexpr int kRun = 64;
  for (int begin = 0; begin < count; begin += kRun) {
    const int n = count - begin < kRun ? count - begin : kRun;
    float dx[kRun], dy[kRun], dz[kRun], r[kRun], g[kRun], b[kRun];
    for (int i = 0; i < kRun; ++i) {
      const int from = begin + (i < n ? i : 0);
      dx[i] = static_cast<float>(x[from]), dy[i] = static_cast<float>(y[from]), dz[i] = static_cast<float>(z[from]);
      r[i] = 0, g[i] = 0, b[i] = 0;
    }
    for (int k = 0; k < light_count; ++k) {
      const PointLight& light = lights[k];
      const float lx = static_cast<float>(light.x), ly = static_cast<float>(light.y), lz = static_cast<float>(light.z);
      const float scale = static_cast<float>(lobe.scale), a0 = static_cast<float>(lobe.a), b0 = static_cast<float>(lobe.b);
      for (int i = 0; i < kRun; ++i) {
        const float ex = dx[i] - lx, ey = dy[i] - ly, ez = dz[i] - lz;
        const float versine = 0.5f * (ex * ex + ey * ey + ez * ez), c = 1 - versine;
        const float base = a0 + b0 * versine;
        const float k_value = (c > 0 ? c : 0) * scale / (base * base);
        r[i] += k_value * light.r;
        g[i] += k_value * light.g;
        b[i] += k_value * light.b;
      }
    }
    for (int i = 0; i < n; ++i) {
      float* texel = out + 3L * (begin + i);
      texel[0] += r[i], texel[1] += g[i], texel[2] += b[i];
    }
  }
}

}  // namespace

extern const RenderKernels kRenderKernels;
const RenderKernels kRenderKernels = {interpolate, add_points};

}  // namespace zonal::ZONAL_ISA
