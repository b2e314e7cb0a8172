// Compiled once per instruction set: nothing here but the loop (see cmake/zonal.cmake).
#include "zonal/light/fisheye_means_kernel.h"

namespace zonal::ZONAL_ISA {
namespace {

constexpr int kFloats = 2 * ZONAL_LANES;
using Vec = float __attribute__((vector_size(kFloats * sizeof(float))));

inline Vec load(const float* p, int n) {
  Vec v = {};
  if (n == kFloats)
    __builtin_memcpy(&v, p, sizeof v);
  else
    __builtin_memcpy(&v, p, static_cast<unsigned long>(n) * sizeof(float));
  return v;
}

/// c^exponent by repeated squaring; a fraction costs a library call for each pixel.
inline Vec power(Vec c, const LobeShape& lobe) {
  Vec result = Vec{} + 1, square = c;
  for (int n = lobe.whole; n > 0;) {
    if ((n & 1) != 0) result *= square;
    n >>= 1;
    if (n > 0) square *= square;
  }
  if (lobe.remainder > 0) {
    for (int i = 0; i < kFloats; ++i) result[i] *= __builtin_powf(c[i], lobe.remainder);
  }
  return result;
}

/// Clenshaw's sum of the factor's series.
inline Vec factor(Vec c, const LobeShape& lobe) {
  const Vec x = 2 * c - 1;
  Vec next = {}, after = {};
  for (int k = lobe.factors - 1; k > 0; --k) {
    const Vec sum = lobe.factor[k] + 2 * x * next - after;
    after = next;
    next = sum;
  }
  return lobe.factor[0] + x * next - after;
}

void add(const LobeShape& lobe, const LobePixels& pixels, int count, const float* q, double* sums) {
  Vec weights = {}, r = {}, g = {}, b = {};
  for (int i = 0; i < count; i += kFloats) {
    const int n = count - i < kFloats ? count - i : kFloats;  // what is not there weighs nothing
    const Vec c = q[0] * load(pixels.x + i, n) + q[1] * load(pixels.y + i, n) + q[2] * load(pixels.z + i, n);
    const auto counts = c > lobe.least_cosine;
    const Vec safe = counts ? c : Vec{} + 1;
    const Vec value = power(safe, lobe) * factor(safe, lobe);
    const Vec k = counts ? value : Vec{};
    weights += k * load(pixels.weight + i, n);
    r += k * load(pixels.r + i, n);
    g += k * load(pixels.g + i, n);
    b += k * load(pixels.b + i, n);
  }
  for (int i = 0; i < kFloats; ++i) {
    sums[0] += weights[i];
    sums[1] += r[i];
    sums[2] += g[i];
    sums[3] += b[i];
  }
}

}  // namespace

const FisheyeMeansKernels kFisheyeMeansKernels = {add};

}  // namespace zonal::ZONAL_ISA
