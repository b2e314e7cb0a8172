// Compiled once per instruction set: nothing here but the loops (see cmake/zonal.cmake).
#include "zonal/light/resample_kernel.h"

#include "zonal/light/sample_taps.h"

namespace zonal::ZONAL_ISA {
namespace {

template <class V>
inline V load_from(const void* from) {
  V v;
  __builtin_memcpy(&v, from, sizeof(V));
  return v;
}
template <class V>
inline void store(void* to, V v) {
  __builtin_memcpy(to, &v, sizeof(V));
}

// --- Arctangent: a polynomial in x² from the Chebyshev series atan x = 2 Σ (-1)^k q^(2k+1)/(2k+1) T_(2k+1)(x), q =
// tan(π/8)
// (|x| <= 1; Mason & Handscomb 2003, table 5.4). What is left out is below 2 q^17/17 = 4e-8.
constexpr int kTerms = 8;
constexpr double kTanEighth = 0.41421356237309504880;  // sqrt(2) - 1
constexpr double kHalfPi = 1.57079632679489661923;

struct Polynomial {
  float c[kTerms];
};

constexpr Polynomial arctangent() {
  double sum[2 * kTerms] = {}, before[2 * kTerms] = {1}, now[2 * kTerms] = {0, 1};  // coefficients of T_(n-1), T_n
  double power = kTanEighth;
  for (int n = 1; n < 2 * kTerms; ++n) {
    if (n % 2 == 1) {
      const double weight = 2 * power / n * (n % 4 == 1 ? 1 : -1);
      for (int i = 0; i < 2 * kTerms; ++i) sum[i] += weight * now[i];
      power *= kTanEighth * kTanEighth;
    }
    double next[2 * kTerms] = {};
    for (int i = 0; i < 2 * kTerms; ++i) next[i] = (i > 0 ? 2 * now[i - 1] : 0) - before[i];
    for (int i = 0; i < 2 * kTerms; ++i) before[i] = now[i], now[i] = next[i];
  }
  Polynomial p{};
  for (int k = 0; k < kTerms; ++k) p.c[k] = static_cast<float>(sum[2 * k + 1]);
  return p;
}
constexpr Polynomial kArctangent = arctangent();

constexpr int kWide = 2 * ZONAL_LANES;
using Wide = float __attribute__((vector_size(kWide * sizeof(float))));

/// atan2 for points that are not both zero.
inline Wide angle_of(Wide y, Wide x) {
  const Wide ax = absolute(x), ay = absolute(y);
  const auto steep = ay > ax;
  const Wide t = (steep ? ax : ay) / (steep ? ay : ax);
  const Wide square = t * t;
  Wide sum = Wide{} + kArctangent.c[kTerms - 1];
  for (int k = kTerms - 2; k >= 0; --k) sum = sum * square + kArctangent.c[k];
  Wide angle = sum * t;
  angle = steep ? static_cast<float>(kHalfPi) - angle : angle;
  angle = x < 0 ? static_cast<float>(2 * kHalfPi) - angle : angle;
  return y < 0 ? -angle : angle;
}

inline Wide square_root(Wide v) {
  for (int i = 0; i < kWide; ++i) v[i] = __builtin_sqrtf(v[i]);
  return v;
}

void panorama_positions(const TexelFrames& frames, float dx, float dy, const PanoramaScale& scale, int count, float* x,
                        float* y) {
  for (int i = 0; i < count; i += kWide) {
    Wide d[3];
    for (int axis = 0; axis < 3; ++axis) {
      d[axis] = load_from<Wide>(frames.center[axis] + i) + dx * load_from<Wide>(frames.across[axis] + i) +
                dy * load_from<Wide>(frames.down[axis] + i);
    }
    Wide level = square_root(d[0] * d[0] + d[1] * d[1]);
    // Straight up or down every azimuth is right; this keeps 0/0 away.
    level = level > 0 ? level : Wide{} + 1e-30f;
    const Wide azimuth = angle_of(d[1], level > 1e-30f ? d[0] : Wide{} + 1);
    store(x + i, scale.x_zero + scale.x_per_radian * azimuth);
    store(y + i, scale.y_zero + scale.y_per_radian * angle_of(d[2], level));
  }
}

// --- Reading the picture

using WideInt = int __attribute__((vector_size(kWide * sizeof(int))));

/// The texels up and left of some points, as offsets into the picture (-1: not inside), and the way to the next.
struct Cells {
  int offset[kKernelPoints];
  float s[kKernelPoints], t[kKernelPoints];

  Cells(const TexelArray& a, int count, const float* x, const float* y) {
    for (int i = 0; i < count; i += kWide) {
      const Wide px = load_from<Wide>(x + i), py = load_from<Wide>(y + i);
      const WideInt left = __builtin_convertvector(px + 16, WideInt) - 16;
      const WideInt top = __builtin_convertvector(py + 16, WideInt) - 16;
      // The last row is left out because vector loads read a little past the texels they need.
      const WideInt inside = (left >= 1) & (left < a.width - 2) & (top >= 1) & (top < a.height - 3);
      store(offset + i, inside ? top * a.width + left : WideInt{} - 1);
      // Adding 16 may round up to the next texel.
      store(s + i, greater(px - __builtin_convertvector(left, Wide), Wide{}));
      store(t + i, greater(py - __builtin_convertvector(top, Wide), Wide{}));
    }
  }
};

/// Calls add(sum of point i, texel up and left of it, s, t) for the points inside and lists the others.
template <class Add>
inline int for_each_inside(const TexelArray& source, int count, const float* x, const float* y, float* sums,
                           int* missed, Add add) {
  const Cells cells(source, count, x, y);
  int misses = 0;
  for (int i = 0; i < count; ++i) {
    if (cells.offset[i] < 0) {
      missed[misses++] = i;
    } else {
      add(sums + kSumLanes * i, source.texels + cells.offset[i], cells.s[i], cells.t[i]);
    }
  }
  return misses;
}

int add_linear(const TexelArray& source, int count, const float* x, const float* y, float* sums, int* missed) {
  using Float8 = float __attribute__((vector_size(32)));
  const Float8 left = {1, 1, 1, 0, 0, 0, 0, 0}, right_minus_left = {-1, -1, -1, 1, 1, 1, 0, 0};
  return for_each_inside(source, count, x, y, sums, missed, [&](float* sum, const Rgb* texel, float s, float t) {
    const Float8 upper = load_from<Float8>(texel), lower = load_from<Float8>(texel + source.width);
    store(sum, load_from<Float8>(sum) + (left + s * right_minus_left) * (upper + t * (lower - upper)));
  });
}

int add_cubic(const TexelArray& source, int count, const float* x, const float* y, float* sums, int* missed) {
  return for_each_inside(source, count, x, y, sums, missed, [&](float* sum, const Rgb* texel, float s, float t) {
    const Float4 across = Float4{} + s, down = Float4{} + t;
    texel -= source.width + 1;
    Float4 rows[4];
    for (int j = 0; j < 4; ++j, texel += source.width) {
      rows[j] = limited_cubic(load_from<Float4>(texel), load_from<Float4>(texel + 1), load_from<Float4>(texel + 2),
                              load_from<Float4>(texel + 3), across);
    }
    Float4 value = limited_cubic(rows[0], rows[1], rows[2], rows[3], down);
    value[3] = 0;  // that lane has read the next texel's red
    store(sum, load_from<Float4>(sum) + value);
  });
}

void sum_and_max(const float* values, int count, float* sum, float* max) {
  Wide sums = {}, largest = Wide{} + values[0];
  int i = 0;
  for (; i + kWide <= count; i += kWide) {
    const Wide v = load_from<Wide>(values + i);
    sums += v;
    largest = v > largest ? v : largest;
  }
  float total = 0, top = values[0];
  for (int lane = 0; lane < kWide; ++lane) {
    total += sums[lane];
    top = largest[lane] > top ? largest[lane] : top;
  }
  for (; i < count; ++i) {
    total += values[i];
    top = values[i] > top ? values[i] : top;
  }
  *sum = total;
  *max = top;
}

}  // namespace

const ResampleKernels kResampleKernels = {panorama_positions, add_linear, add_cubic, sum_and_max};

}  // namespace zonal::ZONAL_ISA
