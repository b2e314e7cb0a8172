#include "zonal/sht/ring_fft.h"

#include <cmath>
#include <complex>
#include <cstring>

#include "zonal/math/vec.h"

namespace zonal {
namespace {

// A generic radix r costs r operations per entry; from here on three transforms of a power of two are cheaper.
constexpr int kLargestRadix = 61;

std::vector<int> radices(int n) {
  std::vector<int> factors;
  for (int r : {8, 4, 2, 3, 5}) {
    for (; n % r == 0; n /= r) factors.push_back(r);
  }
  for (int r = 7; r * r <= n; r += 2) {
    for (; n % r == 0; n /= r) factors.push_back(r);
  }
  if (n > 1) factors.push_back(n);
  return factors;
}

/// exp(-2πi numerator/denominator), the fraction reduced first so that large products keep their digits.
std::complex<double> root(long numerator, long denominator) {
  const double turn = 2 * kPi * static_cast<double>(numerator % denominator) / static_cast<double>(denominator);
  return {std::cos(turn), -std::sin(turn)};
}

void append(std::vector<double>& table, std::complex<double> z) {
  table.push_back(z.real());
  table.push_back(z.imag());
}

}  // namespace

RingFft::RingFft(int length) : length_(length), padded_(length) {
  bool small = true;
  for (int r : radices(length)) small &= r <= kLargestRadix;
  if (small) {
    plan_stages(length);
  } else {
    plan_chirp(length);
  }
}

void RingFft::plan_stages(int length) {
  int n = length, stride = 1;
  for (int r : radices(length)) {
    const int groups = n / r;
    std::vector<double> twiddles, roots;
    for (int p = 0; p < groups; ++p) {
      for (int k = 1; k < r; ++k) append(twiddles, root(static_cast<long>(p) * k, n));
    }
    for (int j = 0; j < r; ++j) append(roots, root(j, r));
    tables_.push_back(std::move(twiddles));
    tables_.push_back(std::move(roots));
    stages_.push_back({r, groups, stride, tables_[tables_.size() - 2].data(), tables_.back().data()});
    n = groups;
    stride *= r;
  }
}

void RingFft::plan_chirp(int length) {
  padded_ = 1;
  while (padded_ < 2 * length - 1) padded_ *= 2;
  plan_stages(padded_);
  std::vector<std::complex<double>> spectrum(padded_);
  for (int n = 0; n < length; ++n) {
    const std::complex<double> chirp = root(static_cast<long>(n) * n, 2L * length);
    append(chirp_, chirp);
    spectrum[n] = std::conj(chirp);
    if (n > 0) spectrum[padded_ - n] = std::conj(chirp);
  }
  // One transform with the same code: the values in lane 0, the rest zero.
  const RingKernels& kernels = ring_kernels(Isa::kBaseline);
  const int lanes = kernels.lanes;
  std::vector<double> a(2UL * lanes * padded_), b(a.size());
  for (int n = 0; n < padded_; ++n) {
    a[2UL * lanes * n] = spectrum[n].real();
    a[2UL * lanes * n + lanes] = spectrum[n].imag();
  }
  const double* result = kernels.fft(stages_.data(), static_cast<int>(stages_.size()), a.data(), b.data());
  for (int n = 0; n < padded_; ++n) {
    const std::complex<double> z(result[2L * lanes * n], result[2L * lanes * n + lanes]);
    append(chirp_spectrum_, z / static_cast<double>(padded_));
  }
}

double* RingFft::forward(const RingKernels& kernels, double* values, double* scratch) const {
  const int count = static_cast<int>(stages_.size());
  if (chirp_.empty()) return kernels.fft(stages_.data(), count, values, scratch);

  // Bluestein: nk = (n² + k² - (k - n)²) / 2 makes the transform a convolution with a chirp, done over a power of two.
  // The inverse transform of it is a forward one between two conjugations.
  const std::size_t entry = 2UL * kernels.lanes;
  kernels.multiply(values, chirp_.data(), length_, false);
  std::memset(values + entry * length_, 0, entry * (padded_ - length_) * sizeof(double));
  double* product = kernels.fft(stages_.data(), count, values, scratch);
  kernels.multiply(product, chirp_spectrum_.data(), padded_, true);
  double* other = product == values ? scratch : values;
  double* result = kernels.fft(stages_.data(), count, product, other);
  // conj(result) times the chirp = conj(result times conj(chirp)).
  std::vector<double> conjugate_chirp(chirp_);
  for (std::size_t i = 1; i < conjugate_chirp.size(); i += 2) conjugate_chirp[i] = -conjugate_chirp[i];
  kernels.multiply(result, conjugate_chirp.data(), length_, true);
  return result;
}

}  // namespace zonal
