#include "zonal/sht/ring_fft.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "zonal/math/vec.h"
#include "zonal/sht/spectrum.h"

namespace zonal {
namespace {

using Complex = std::complex<double>;

std::vector<Complex> by_definition(const std::vector<Complex>& values) {
  const long n = static_cast<long>(values.size());
  std::vector<Complex> result(values.size());
  for (long k = 0; k < n; ++k) {
    for (long j = 0; j < n; ++j)
      result[k] += values[j] * std::polar(1.0, -2 * kPi * static_cast<double>(j * k % n) / static_cast<double>(n));
  }
  return result;
}

TEST(RingFft, AgreesWithTheDefinitionAtEveryLengthAndInstructionSet) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  int compared = 0;
  // Every small length, lengths of real pictures, and large primes (67, 127, 961 = 31², 1009) that go through the
  // chirp.
  std::vector<int> lengths = {128, 134, 210, 243, 254, 256, 360, 500, 720, 922, 961, 1009, 1024};
  for (int n = 1; n <= 40; ++n) lengths.push_back(n);
  for (const int n : lengths) {
    const RingFft fft(n);
    for (const Isa isa : available_isas()) {
      const RingKernels& kernels = ring_kernels(isa);
      const int lanes = kernels.lanes;
      AlignedDoubles values(2UL * lanes * fft.capacity()), scratch(2UL * lanes * fft.capacity());
      std::vector<std::vector<Complex>> lane_values(lanes, std::vector<Complex>(n));
      for (int lane = 0; lane < lanes; ++lane) {
        for (int i = 0; i < n; ++i) {
          const Complex z(normal(random), normal(random));
          lane_values[lane][i] = z;
          values.data()[2L * lanes * i + lane] = z.real();
          values.data()[2L * lanes * i + lanes + lane] = z.imag();
        }
      }
      const double* result = fft.forward(kernels, values.data(), scratch.data());
      for (const int lane : {0, lanes - 1}) {
        const std::vector<Complex> expected = by_definition(lane_values[lane]);
        for (int k = 0; k < n; ++k) {
          const Complex got(result[2L * lanes * k + lane], result[2L * lanes * k + lanes + lane]);
          // Rounding grows like the root of the length here, and so does the size of the result; the definition's own
          // sum is worse.
          ASSERT_LT(std::abs(got - expected[k]), 1e-15 * n + 1e-14) << "length " << n << ", " << name_of(isa);
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(compared, 20000);
}

}  // namespace
}  // namespace zonal
