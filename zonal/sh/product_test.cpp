#include "zonal/sh/product.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "zonal/math/sphere_rule.h"
#include "zonal/sh/axial_product.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/gaunt.h"
#include "zonal/sh/product_kernel.h"
#include "zonal/sh/product_matrix.h"
#include "zonal/sh/zonal.h"

namespace zonal {
namespace {

template <class T, int N>
Sh<T, N> wavy(int bands, double step) {
  Sh<T, N> sh(bands);
  for (std::size_t i = 0; i < sh.size(); ++i) sh[i] = static_cast<T>(std::sin(step * static_cast<double>(i) + 0.4));
  return sh;
}

/// The first bands of f g by brute force over the sphere.
template <int N, int M>
Sh<double> projected(const Sh<double, N>& f, const Sh<double, M>& g, int bands) {
  Sh<double> result(bands), y(bands);
  for (const auto& [d, weight] : sphere_rule(f.bands() + g.bands() + bands)) {
    basis(bands, d, y.values());
    const double value = weight * evaluate(f, d) * evaluate(g, d);
    for (std::size_t i = 0; i < y.size(); ++i) result[i] += value * y[i];
  }
  return result;
}

template <class A, class B>
double worst_difference(const A& a, const B& b) {
  EXPECT_EQ(a.size(), b.size());
  double worst = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

TEST(Product, IsTheProjectedProductForAnyBands) {
  int compared = 0;
  for (int a = 1; a <= 9; ++a) {
    const Sh<double> f = wavy<double, kDynamic>(a, 1.3);
    for (int b = 1; b <= 9; b += 2) {
      const Sh<double> g = wavy<double, kDynamic>(b, 2.9);
      for (int k = 1; k <= 19; k += 3) {
        // Values to 100 in sums of some hundred terms.
        EXPECT_LT(worst_difference(product_to(f, g, k), projected(f, g, k)), 1e-12) << a << " " << b << " " << k;
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 9 * 5 * 7);
}

TEST(Product, StaticAndDynamicAndListAndRingsAgree) {
  const Sh<double, 6> f = wavy<double, 6>(6, 1.3);
  const Sh<double, 4> g = wavy<double, 4>(4, 2.9);
  const Sh<double> df = with_bands(f, 6), dg = with_bands(g, 4);
  EXPECT_LT(worst_difference(product(f, g), product(df, dg)), 1e-15);
  EXPECT_LT(worst_difference(product_to<3>(f, g), product_to(df, dg, 3)), 1e-15);
  EXPECT_LT(worst_difference(product_of_few_bands<6>(f, g, 6), product_by_rings<6>(f, g, 6)), 1e-13);
  EXPECT_LT(worst_difference(product(f, g), product(g, f)), 1e-13);
  const Sh<double, 9> full = full_product(f, g);
  EXPECT_LT(worst_difference(full, full_product(df, dg)), 1e-15);
  int compared = 0;
  for (const Vec3 d : spiral_directions(30)) {
    EXPECT_NEAR(evaluate(full, d), evaluate(f, d) * evaluate(g, d), 1e-12);  // 81 terms of size 1
    ++compared;
  }
  EXPECT_EQ(compared, 30);
}

/// The product by the list of Gaunt integrals: all orders of i, j and k.
template <int N>
Sh<double, N> product_by_list(const Sh<double, N>& f, const Sh<double, N>& g) {
  Sh<double, N> sum;
  for (const auto& [i, j, k, value] : gaunt_integrals(N)) {
    std::array<std::size_t, 3> order = {i, j, k};
    do {
      sum[order[2]] += value * f[order[0]] * g[order[1]];
    } while (std::next_permutation(order.begin(), order.end()));
  }
  return sum;
}

template <int N, class T, class Kernel>
double worst_of_kernel(Kernel kernel, int* compared) {
  double worst = 0;
  for (int k = 0; k < 10; ++k, ++*compared) {
    const Sh<T, N> f = wavy<T, N>(N, 1.3 + 0.1 * k), g = wavy<T, N>(N, 2.9 - 0.2 * k);
    Sh<T, N> result;
    kernel(&f[0], &g[0], &result[0]);
    worst = std::max(worst, worst_difference(cast<double>(result), product_by_list(cast<double>(f), cast<double>(g))));
  }
  return worst;
}

TEST(Product, RingsAgreeWithTheListOnEveryInstructionSet) {
  int compared = 0;
  for (const Isa isa : available_isas()) {
    [&]<int... n>(std::integer_sequence<int, n...>) {
      (
          [&] {
            // Coefficients up to 1 in functions of norm N; sums of some hundred terms round like their square root.
            constexpr double kRoundings = 2 * (n + 1) * (n + 1);
            const auto& kernels = product_kernels(isa);
            EXPECT_LT((worst_of_kernel<n + 1, float>(kernels.in_float[n], &compared)), kRoundings * 6e-8) << n;
            EXPECT_LT((worst_of_kernel<n + 1, double>(kernels.in_double[n], &compared)), kRoundings * 1.1e-16) << n;
          }(),
          ...);
    }
    (std::make_integer_sequence<int, 6>());
  }
  EXPECT_EQ(compared, static_cast<int>(available_isas().size()) * 6 * 2 * 10);
}

TEST(Product, BeyondTheFullProductIsZero) {
  const Sh<double> p = product_to(wavy<double, kDynamic>(3, 1.3), wavy<double, kDynamic>(5, 2.9), 12);
  EXPECT_GT(std::abs(p(6, 1)), 0.01);
  for (int l = 7; l < 12; ++l) {
    for (const double value : p.band(l)) EXPECT_EQ(value, 0);
  }
}

TEST(Product, MultipliesColorsByChannel) {
  const Sh<float, 4> f = wavy<float, 4>(4, 1.3), g = wavy<float, 4>(4, 2.9);
  const Sh<Rgb, 4> tinted = Rgb(1, 2, -4) * f, other = Rgb(3, 1, 0.5f) * g;
  const Sh<float, 4> plain = product(f, g);
  const Sh<Rgb, 4> by_number = product(tinted, g), by_number_first = product(g, tinted), both = product(tinted, other);
  const Sh<Rgb, 9> rings = product_to<9>(tinted, other);
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const float p = plain[i];
    EXPECT_NEAR(by_number[i].r, p, 1e-6f);
    EXPECT_NEAR(by_number[i].b, -4 * p, 4e-6f);
    EXPECT_NEAR(by_number[i].g, by_number_first[i].g, 1e-6f);
    EXPECT_NEAR(both[i].g, 2 * p, 2e-6f);
    EXPECT_NEAR(both[i].r, 3 * p, 3e-6f);
    EXPECT_NEAR(rings[i].r, 3 * p, 3e-6f);
    EXPECT_NEAR(rings[i].b, -2 * p, 2e-6f);
  }
}

TEST(ProductMatrix, MultipliesAsTheProductDoes) {
  const Sh<double, 6> f = wavy<double, 6>(6, 1.3), g = wavy<double, 6>(6, 2.9);
  EXPECT_LT(worst_difference(ProductMatrix<6>(f).apply(g), product(f, g)), 1e-14);  // 36 terms
  // Three bands take five of f.
  const Sh<double> few = with_bands(g, 3);
  EXPECT_LT(worst_difference(ProductMatrix(f, 3).apply(few), product_to(f, few, 3)), 1e-14);
  EXPECT_GT(worst_difference(ProductMatrix(with_bands(f, 4), 3).apply(few), product_to(f, few, 3)), 0.01);
  // On rings.
  const Sh<double> many = wavy<double, kDynamic>(9, 0.7), eight = wavy<double, kDynamic>(8, 0.3);
  const ProductMatrix matrix(many, 8);
  EXPECT_LT(worst_difference(matrix.apply(eight), product_to(many, eight, 8)), 1e-13);
  double skew = 0;
  for (std::size_t i = 0; i < 64; ++i) {
    for (std::size_t j = 0; j < i; ++j) skew = std::max(skew, std::abs(matrix(i, j) - matrix(j, i)));
  }
  EXPECT_LT(skew, 1e-14);
  EXPECT_LT(worst_difference(ProductMatrix<6>(many).apply(g), product_to<6>(many, g)), 1e-13);
}

TEST(ProductWithZonal, AgreesWithTheGeneralProduct) {
  const std::vector<double> zonal = {1, -0.7, 0.3, 0.9, -0.2, 0.1, 0.4};
  int compared = 0;
  for (const Vec3 axis : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, normalize({0.2, -0.7, 0.4}), Vec3{-1, 0, 0}}) {
    const Sh<double, 5> f = wavy<double, 5>(5, 1.3);
    const Sh<double> many = wavy<double, kDynamic>(11, 1.3);
    const Sh<double> turned = zonal_toward(zonal, axis);
    EXPECT_LT(worst_difference(product_with_zonal(f, zonal, axis), product_to<5>(f, turned)), 1e-14);
    EXPECT_LT(worst_difference(product_with_zonal(many, zonal, axis), product_to(many, turned, 11)), 1e-13);
    ++compared;
  }
  EXPECT_EQ(compared, 4);
}

TEST(Product, RefusesEmptyInput) {
  const Sh<double> f(3), none;
  EXPECT_THROW(product(f, none), std::logic_error);
  EXPECT_THROW(product_to(f, f, 0), std::logic_error);
  EXPECT_THROW(ProductMatrix(f, 0), std::logic_error);
  EXPECT_THROW(ProductMatrix(f, 4).apply(f), std::logic_error);
  EXPECT_THROW(product_with_zonal(none, std::vector<double>{1}), std::logic_error);
}

}  // namespace
}  // namespace zonal
