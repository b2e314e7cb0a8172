#pragma once

#include <vector>

#include "zonal/sht/kernels.h"

namespace zonal {

/// A plan for complex transforms of one length, any length: mixed radix 8, 4, 2, 3, 5 and small odd factors, and
/// Bluestein's chirp (1970) where a prime factor is large.
class RingFft {
 public:
  explicit RingFft(int length);

  int length() const { return length_; }
  /// Entries of [re, im][lanes] that `values` and `scratch` must have room for.
  int capacity() const { return padded_; }
  /// X_k = Σ_n x_n exp(-2πi nk/N) for each lane; the result is in the buffer returned.
  double* forward(const RingKernels& kernels, double* values, double* scratch) const;

 private:
  void plan_stages(int length);
  void plan_chirp(int length);

  int length_;
  int padded_;
  std::vector<FftStage> stages_;
  std::vector<std::vector<double>> tables_;  // what the stages point to
  std::vector<double> chirp_;                // exp(-πi n²/N); empty unless Bluestein
  std::vector<double> chirp_spectrum_;       // transform of the conjugate chirp, over the padded length
};

}  // namespace zonal
