// Compiled once per instruction set: nothing here but the loops (see cmake/zonal.cmake).
#include "zonal/light/distribution_kernel.h"

namespace zonal::ZONAL_ISA {
namespace {

constexpr int kLanes = 2 * ZONAL_LANES;  // floats: 4, 8 or 16
constexpr int kGroupFloats = 3 * kGroupTexels;
using Vec = float __attribute__((vector_size(kLanes * sizeof(float))));

RowTally tally(const float* row, int floats, float* groups) {
  RowTally total;
  Vec lowest = {};
  int group = 0;
  for (; (group + 1) * kGroupFloats <= floats; ++group, row += kGroupFloats) {
    Vec largest = {}, sum = {};
    for (int i = 0; i < kGroupFloats; i += kLanes) {
      Vec v;
      __builtin_memcpy(&v, row + i, sizeof v);
      const Vec magnitude = v < 0 ? -v : v;
      sum += magnitude;
      largest = magnitude > largest ? magnitude : largest;
      lowest = v < lowest ? v : lowest;
    }
    float brightest = 0, group_sum = 0;
    for (int lane = 0; lane < kLanes; ++lane) {
      brightest = largest[lane] > brightest ? largest[lane] : brightest;
      group_sum += sum[lane];
    }
    groups[group] = brightest;
    total.sum += group_sum;
  }
  for (int lane = 0; lane < kLanes; ++lane) total.lowest = lowest[lane] < total.lowest ? lowest[lane] : total.lowest;
  const int rest = floats - group * kGroupFloats;
  if (rest > 0) groups[group] = 0;
  for (int i = 0; i < rest; ++i) {
    const float magnitude = row[i] < 0 ? -row[i] : row[i];
    total.sum += magnitude;
    groups[group] = magnitude > groups[group] ? magnitude : groups[group];
    total.lowest = row[i] < total.lowest ? row[i] : total.lowest;
  }
  return total;
}

}  // namespace

const TallyRow kTallyRow = tally;

}  // namespace zonal::ZONAL_ISA
