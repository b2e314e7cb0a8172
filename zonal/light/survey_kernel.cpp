// Compiled once per instruction set: nothing here but the loops (see cmake/zonal.cmake).
#include "zonal/light/survey_kernel.h"

namespace zonal::ZONAL_ISA {
namespace {

constexpr int kWide = 2 * ZONAL_LANES;
using Wide = float __attribute__((vector_size(kWide * sizeof(float))));
using WideInt = int __attribute__((vector_size(kWide * sizeof(int))));

/// Texels are counted in chunks: short enough that float sums of a chunk lose nothing that matters.
constexpr int kChunk = 64;
static_assert(kChunk % kWide == 0);

inline Wide load_wide(const float* from) {
  Wide v;
  __builtin_memcpy(&v, from, sizeof(v));
  return v;
}
inline Wide lesser(Wide a, Wide b) { return a < b ? a : b; }
inline Wide greater(Wide a, Wide b) { return a > b ? a : b; }
inline double total(Wide v) {
  double sum = 0;
  for (int i = 0; i < kWide; ++i) sum += v[i];
  return sum;
}

/// The exponent of each number, as a bin; zero and negative numbers go to the first.
inline WideInt bin_of(Wide luminance) {
  const Wide positive = luminance > 0 ? luminance : Wide{};
  WideInt bits;
  __builtin_memcpy(&bits, &positive, sizeof(bits));
  WideInt bin = (bits >> 23) - (127 + kFirstBinLog2);
  bin = bin > 0 ? bin : WideInt{};
  return bin < kLuminanceBins - 1 ? bin : WideInt{} + (kLuminanceBins - 1);
}

/// Running extremes and counts, a lane for every kWide-th texel.
struct Lanes {
  Wide min_luminance, max_luminance, max_channel;
  WideInt negative = {};
  Wide not_finite = {};  // stays 0 while every number times 0 is 0
};

/// Neighbouring texels are alike: four histograms keep their increments from waiting for each other.
using Histograms = int[4][kLuminanceBins];

void count_chunk(const Rgb* texels, Lanes& lanes, Histograms& bins, RowCount& row) {
  float r[kChunk], g[kChunk], b[kChunk];
  for (int i = 0; i < kChunk; ++i) r[i] = texels[i].r, g[i] = texels[i].g, b[i] = texels[i].b;
  Wide sum_r = {}, sum_g = {}, sum_b = {}, below = {};
  int bin[kChunk];
  for (int i = 0; i < kChunk; i += kWide) {
    const Wide vr = load_wide(r + i), vg = load_wide(g + i), vb = load_wide(b + i);
    const Wide light = 0.2126f * vr + 0.7152f * vg + 0.0722f * vb;
    sum_r += vr, sum_g += vg, sum_b += vb;
    below += lesser(vr, Wide{}) + lesser(vg, Wide{}) + lesser(vb, Wide{});
    lanes.not_finite += light * 0;
    lanes.negative -= lesser(lesser(vr, vg), vb) < 0;  // true is -1
    lanes.min_luminance = lesser(light, lanes.min_luminance);
    lanes.max_luminance = greater(light, lanes.max_luminance);
    lanes.max_channel = greater(greater(greater(vr, vg), vb), lanes.max_channel);
    const WideInt index = bin_of(light);
    __builtin_memcpy(bin + i, &index, sizeof(index));
  }
  row.sum[0] += total(sum_r), row.sum[1] += total(sum_g), row.sum[2] += total(sum_b);
  row.negative_sum += total(below);
  for (int i = 0; i < kChunk; i += 4) {
    for (int k = 0; k < 4; ++k) ++bins[k][bin[i + k]];
  }
}

void count_row(const Rgb* texels, int count, RowCount* row) {
  *row = {};
  const float first = 0.2126f * texels[0].r + 0.7152f * texels[0].g + 0.0722f * texels[0].b;
  Lanes lanes = {Wide{} + first, Wide{} + first, Wide{} + texels[0].r, {}, {}};
  Histograms bins = {};
  int i = 0;
  for (; i + kChunk <= count; i += kChunk) count_chunk(texels + i, lanes, bins, *row);
  if (i < count) {
    // The rest is filled up with its first texel, which is then taken out again.
    Rgb rest[kChunk];
    for (int k = 0; k < kChunk; ++k) rest[k] = texels[i + k < count ? i + k : i];
    count_chunk(rest, lanes, bins, *row);
    const int extra = kChunk - (count - i);
    const Rgb c = texels[i];
    row->sum[0] -= static_cast<double>(extra) * c.r;
    row->sum[1] -= static_cast<double>(extra) * c.g;
    row->sum[2] -= static_cast<double>(extra) * c.b;
    const auto below = [](float v) { return v < 0 ? v : 0; };
    row->negative_sum -= extra * (static_cast<double>(below(c.r)) + below(c.g) + below(c.b));
    if (c.r < 0 || c.g < 0 || c.b < 0) row->negative_texels -= extra;
    bins[0][bin_of(Wide{} + (0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b))[0]] -= extra;
  }
  row->min_luminance = lanes.min_luminance[0];
  row->max_luminance = lanes.max_luminance[0];
  row->max_channel = lanes.max_channel[0];
  for (int k = 0; k < kWide; ++k) {
    row->min_luminance = lanes.min_luminance[k] < row->min_luminance ? lanes.min_luminance[k] : row->min_luminance;
    row->max_luminance = lanes.max_luminance[k] > row->max_luminance ? lanes.max_luminance[k] : row->max_luminance;
    row->max_channel = lanes.max_channel[k] > row->max_channel ? lanes.max_channel[k] : row->max_channel;
    row->negative_texels += lanes.negative[k];
    row->finite = row->finite && lanes.not_finite[k] == 0;
  }
  for (int k = 0; k < kLuminanceBins; ++k) row->bins[k] = bins[0][k] + bins[1][k] + bins[2][k] + bins[3][k];
}

}  // namespace

const SurveyKernels kSurveyKernels = {count_row};

}  // namespace zonal::ZONAL_ISA
