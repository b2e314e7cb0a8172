#include "zonal/sh/product.h"

#include <cmath>

#include "zonal/math/legendre.h"
#include "zonal/math/quadrature.h"
#include "zonal/sh/product_kernel.h"

namespace zonal {
namespace {

int bands_of(std::size_t count) {
  const int bands = static_cast<int>(std::lround(std::sqrt(static_cast<double>(count))));
  check(bands >= 1 && static_cast<std::size_t>(coefficient_count(bands)) == count, "coefficients come in squares");
  return bands;
}

/// One ring of the sphere and the trigonometry of its equal steps in phi.
class Ring {
 public:
  Ring(int bands, int steps) : bands_(bands), steps_(steps), cosines_(steps), legendre_(columns_before(bands)) {
    for (int k = 0; k < steps; ++k) cosines_[k] = std::cos(2 * kPi * k / steps);
    sines_.resize(steps);
    for (int k = 0; k < steps; ++k) sines_[k] = std::sin(2 * kPi * k / steps);
  }

  void move_to(double z) {
    const double r = std::sqrt((1 - z) * (1 + z));
    for (int m = 0; m < bands_; ++m) {
      associated_legendre(m, z, r, std::span(legendre_).subspan(columns_before(m), bands_ - m));
    }
  }

  /// The function at each step.
  void synthesize(std::span<const double> sh, int bands, std::span<double> values) const {
    std::fill(values.begin(), values.end(), 0.0);
    for (int m = 0; m < bands; ++m) {
      double even = 0, odd = 0;
      for (int l = m; l < bands; ++l) {
        even += legendre(l, m) * sh[coefficient_index(l, m)];
        if (m > 0) odd += legendre(l, m) * sh[coefficient_index(l, -m)];
      }
      for (int k = 0, angle = 0; k < steps_; ++k, angle = next(angle, m)) {
        values[k] += even * cosines_[angle] + odd * sines_[angle];
      }
    }
  }

  /// Adds weight times the sum over the steps of values y_i: the adjoint of synthesize.
  void analyze(std::span<const double> values, double weight, int bands, std::span<double> sh) const {
    for (int m = 0; m < bands; ++m) {
      double even = 0, odd = 0;
      for (int k = 0, angle = 0; k < steps_; ++k, angle = next(angle, m)) {
        even += values[k] * cosines_[angle];
        odd += values[k] * sines_[angle];
      }
      for (int l = m; l < bands; ++l) {
        sh[coefficient_index(l, m)] += weight * legendre(l, m) * even;
        if (m > 0) sh[coefficient_index(l, -m)] += weight * legendre(l, m) * odd;
      }
    }
  }

 private:
  std::size_t columns_before(int m) const { return static_cast<std::size_t>(m * bands_ - m * (m - 1) / 2); }
  double legendre(int l, int m) const { return legendre_[columns_before(m) + static_cast<std::size_t>(l - m)]; }
  int next(int angle, int m) const { return angle + m < steps_ ? angle + m : angle + m - steps_; }

  int bands_, steps_;
  std::vector<double> cosines_, sines_;
  std::vector<double> legendre_;  // columns of equal m, l = m..bands-1
};

const ProductKernels& best_kernels() {
  static const ProductKernels& kernels = product_kernels(best_isa());
  return kernels;
}

template <class T>
void multiply(void (*const (&kernels)[kMaxStaticBands])(const T*, const T*, T*), int bands, std::span<const T> f,
              std::span<const T> g, std::span<T> result) {
  const auto size = static_cast<std::size_t>(coefficient_count(bands));
  check(1 <= bands && bands <= kMaxStaticBands && f.size() == size && g.size() == size && result.size() == size,
        "multiply_few_bands takes functions of 1 to 6 bands");
  kernels[bands - 1](f.data(), g.data(), result.data());
}

}  // namespace

void multiply_few_bands(int bands, std::span<const float> f, std::span<const float> g, std::span<float> result) {
  multiply(best_kernels().in_float, bands, f, g, result);
}
void multiply_few_bands(int bands, std::span<const double> f, std::span<const double> g, std::span<double> result) {
  multiply(best_kernels().in_double, bands, f, g, result);
}

std::vector<double> multiply_on_sphere(std::span<const double> f, std::span<const double> g, int result_bands) {
  check(result_bands >= 1, "a product needs at least one band of each");
  const int given = bands_of(f.size()), other = bands_of(g.size());
  // f g y_k vanishes for bands beyond the sum of the two others.
  const int bands = std::min(result_bands, given + other - 1);
  const int f_bands = std::min(given, other + bands - 1), g_bands = std::min(other, given + bands - 1);
  const int steps = f_bands + g_bands + bands - 2;  // one more than the degree of f g y_k
  const Quadrature gauss = gauss_legendre((steps + 1) / 2);
  Ring ring(std::max({f_bands, g_bands, bands}), steps);
  std::vector<double> f_values(steps), g_values(steps), product(coefficient_count(result_bands), 0.0);
  for (std::size_t i = 0; i < gauss.size(); ++i) {
    ring.move_to(gauss.nodes[i]);
    ring.synthesize(f, f_bands, f_values);
    ring.synthesize(g, g_bands, g_values);
    for (int k = 0; k < steps; ++k) f_values[k] *= g_values[k];
    ring.analyze(f_values, gauss.weights[i] * 2 * kPi / steps, bands, product);
  }
  return product;
}

}  // namespace zonal
