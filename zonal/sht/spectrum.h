#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>

#include "zonal/sht/ring_grid.h"

namespace zonal {

/// Uninitialised doubles on a cache line's boundary, in large pages where the system has them: a transform touches each
/// of its buffers' pages once or twice, and with small pages the faults cost as much as the work.
class AlignedDoubles {
 public:
  explicit AlignedDoubles(std::size_t count) : data_(allocate(count * sizeof(double))) {}
  double* data() { return data_.get(); }
  const double* data() const { return data_.get(); }

 private:
  static double* allocate(std::size_t bytes);
  struct Free {
    void operator()(double* p) const { std::free(p); }
  };
  std::unique_ptr<double, Free> data_;
};

/// What lies between the two halves of the transform: for each m and each block of ring pairs the cosine and sine sums,
/// values[m][block][12][lanes] with 12 = [north + south, north - south][channel][cos, sin].
class RingSpectrum {
 public:
  RingSpectrum(RingGrid grid, int bands, int lanes)
      : lanes_(lanes),
        blocks_((grid.pairs() + lanes - 1) / lanes),
        values_(static_cast<std::size_t>(bands) * blocks_ * kEntries * lanes) {}

  static constexpr int kEntries = 12;
  int lanes() const { return lanes_; }
  int blocks() const { return blocks_; }
  long stride() const { return static_cast<long>(blocks_) * kEntries * lanes_; }
  double* at(int m, int block) { return values_.data() + m * stride() + static_cast<long>(block) * kEntries * lanes_; }

 private:
  int lanes_;
  int blocks_;
  AlignedDoubles values_;
};

}  // namespace zonal
