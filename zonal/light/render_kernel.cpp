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

/// atan2(y, x) to 1e-12: the angle is halved twice, tan(φ/2) = t / (1 + sqrt(1 + t²)), then the series of the arc
/// tangent.
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

using Floats = float __attribute__((vector_size(kLanes * sizeof(float))));
using Ints = int __attribute__((vector_size(kLanes * sizeof(int))));
using Longs = long long __attribute__((vector_size(kLanes * sizeof(long long))));

/// Where the six texels along one axis begin, and their weights as three pairs of floats packed into 64 bits, for each
/// lane.
struct Taps {
  Ints first;
  Longs pairs[3];
};

inline Longs packed(Vec low, Vec high) {
  const Ints l = reinterpret_cast<Ints>(__builtin_convertvector(low, Floats));
  const Ints h = reinterpret_cast<Ints>(__builtin_convertvector(high, Floats));
  return (__builtin_convertvector(l, Longs) & 0xffffffffLL) | (__builtin_convertvector(h, Longs) << 32);
}

/// Lagrange's polynomial through the texels -2..3 around a point at `position`, in texels with centres at 1/2; first
/// counts from the border's edge.
inline Taps taps_at(Vec position) {
  const Vec shifted = position + (BorderedGrid::kBorder - 0.5);  // never negative
  const Ints cell = __builtin_convertvector(shifted, Ints);
  const Vec c = shifted - __builtin_convertvector(cell, Vec);
  const Vec a = c + 2, b = c + 1, d = c - 1, e = c - 2, g = c - 3;
  const Vec ab = a * b, cd = c * d, eg = e * g;
  return {cell - 2,
          {packed(b * cd * eg * (-1.0 / 120), a * cd * eg * (1.0 / 24)),
           packed(ab * d * eg * (-1.0 / 12), ab * c * eg * (1.0 / 12)),
           packed(ab * cd * g * (-1.0 / 24), ab * cd * e * (1.0 / 120))}};
}

/// (low, low, low, low, high, high, high, high) of two packed floats.
inline TexelPair spread(long long pair) {
  using Four = long long __attribute__((vector_size(32)));
  const TexelPair both = reinterpret_cast<TexelPair>(Four{pair, pair, pair, pair});
  return __builtin_shufflevector(both, both, 0, 0, 0, 0, 1, 1, 1, 1);
}

inline Texel read(const BorderedGrid& grid, const Taps& across, const Taps& down, int lane) {
  const TexelPair columns[3] = {spread(across.pairs[0][lane]), spread(across.pairs[1][lane]),
                                spread(across.pairs[2][lane])};
  const float* corner = grid.texels + down.first[lane] * grid.row_stride() + 4 * across.first[lane];
  TexelPair sum = {};
  for (int j = 0; j < 6; ++j, corner += grid.row_stride()) {
    TexelPair row = {};
    for (int i = 0; i < 3; ++i) {
      TexelPair texels;
      __builtin_memcpy(&texels, corner + 8 * i, sizeof texels);
      row += columns[i] * texels;
    }
    float weight;
    const long long pair = down.pairs[j / 2][lane];
    __builtin_memcpy(&weight, reinterpret_cast<const char*>(&pair) + 4 * (j % 2), sizeof weight);
    sum += weight * row;
  }
  return __builtin_shufflevector(sum, sum, 0, 1, 2, 3) + __builtin_shufflevector(sum, sum, 4, 5, 6, 7);
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
    const Taps across = taps_at((0.5 - phi * (0.5 / kPi)) * grid.width),
               down = taps_at(theta * (1 / kPi) * grid.height);
    for (int k = 0; k < n; ++k) {
      const Texel texel = read(grid, across, down, k);
      __builtin_memcpy(out + 3L * (i + k), &texel, 3 * sizeof(float));
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
      const float scale = static_cast<float>(lobe.scale), a0 = static_cast<float>(lobe.a),
                  b0 = static_cast<float>(lobe.b);
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

const RenderKernels kRenderKernels = {interpolate, add_points};

}  // namespace zonal::ZONAL_ISA
