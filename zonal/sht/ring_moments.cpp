#include "zonal/sht/ring_moments.h"

#include <cmath>

namespace zonal {

RingMoments::RingMoments(int width, int bands, Isa isa)
    : kernels_(moment_kernels(isa)), width_(width), bands_(bands <= 3 ? 3 : kMaxBands) {
  const int lanes = kernels_.lanes, quarter = 3 * (width / 4), whole = quarter / lanes * lanes;
  const int entries = 2 * (bands_ - 1);
  table_.resize(static_cast<std::size_t>(quarter) * entries);
  for (int i = 0; i < quarter; ++i) {
    for (int m = 1; m < bands_; ++m) {
      const double turn = 2 * kPi * m * (i / 3) / width;
      const std::size_t at = i < whole
                                 ? (static_cast<std::size_t>(i / lanes) * entries + 2 * (m - 1)) * lanes + i % lanes
                                 : static_cast<std::size_t>(i) * entries + 2 * (m - 1);
      table_[at] = static_cast<float>(std::cos(turn));
      table_[at + (i < whole ? lanes : 1)] = static_cast<float>(std::sin(turn));
    }
  }
}

void RingMoments::operator()(const float* north, const float* south, Values& values) const {
  const auto kernel = bands_ == 3 ? kernels_.three : kernels_.six;
  double sums[2 * (2 * kMaxBands - 1) * 3] = {};  // [row][entry][channel]
  kernel(north, south, width_, table_.data(), sums);
  const int entries = 2 * bands_ - 1;
  for (int row = 0; row < 2; ++row) {
    const double* of_row = sums + 3 * entries * row;
    for (int m = 0; m < bands_; ++m) {
      for (int c = 0; c < 3; ++c) {
        values[row][m][0][c] = m == 0 ? of_row[c] : of_row[3 * (2 * m - 1) + c];
        values[row][m][1][c] = m == 0 ? 0 : of_row[3 * 2 * m + c];
      }
    }
  }
}

}  // namespace zonal
