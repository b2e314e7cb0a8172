// Batches against the verbs for one function, in double.
#include "zonal/sh/batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "zonal/math/sphere_rule.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/product.h"
#include "zonal/sh/product_matrix.h"
#include "zonal/sh/rotate.h"

namespace zonal {
namespace {

constexpr double kTolerance = 1e-6;  // relative to the size of what is computed: eight roundings of a float

/// Calls work.operator()<N>(isa) for 1 to 6 bands on each instruction set; returns how often.
template <class Work>
int for_each_kernel(Work&& work) {
  int calls = 0;
  for (const Isa isa : available_isas()) {
    [&]<int... n>(std::integer_sequence<int, n...>) { ((work.template operator()<n + 1>(isa), ++calls), ...); }
    (std::make_integer_sequence<int, 6>());
  }
  return calls;
}

std::vector<float> random_rows(BatchLayout layout, std::size_t rows, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<float> normal;
  std::vector<float> values(layout.size(rows));
  for (float& value : values) value = normal(random);
  return values;
}

template <int N>
Sh<double, N> item(const std::vector<float>& values, BatchLayout layout, std::size_t j) {
  Sh<double, N> sh;
  for (std::size_t i = 0; i < sh.size(); ++i) sh[i] = values[i * layout.stride + j];
  return sh;
}

template <int N>
double norm(const Sh<double, N>& sh) {
  double square = 0;
  for (const double value : sh.values()) square += value * value;
  return std::sqrt(square);
}

/// The largest difference of a coefficient relative to `size`.
template <int N>
double difference(const Sh<double, N>& a, const Sh<double, N>& b, double size) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst / size;
}

/// Spread over the sphere, poles included.
std::vector<float> directions(BatchLayout layout) {
  std::vector<Vec3> all = spiral_directions(static_cast<int>(layout.count));
  for (std::size_t i = 0; i < all.size() && i < 2; ++i) all[i] = {0, 0, i == 0 ? 1.0 : -1.0};
  std::vector<float> rows(layout.size(3));
  for (std::size_t j = 0; j < all.size(); ++j) {
    rows[j] = static_cast<float>(all[j].x);
    rows[layout.stride + j] = static_cast<float>(all[j].y);
    rows[2 * layout.stride + j] = static_cast<float>(all[j].z);
  }
  return rows;
}

TEST(Batch, BasisAgrees) {
  const BatchLayout layout = BatchLayout::padded(75);
  const std::vector<float> d = directions(layout);
  int compared = 0;
  const int kernels = for_each_kernel([&]<int N>(Isa isa) {
    std::vector<float> basis(layout.size(N * N));
    basis_batch(N, layout, d, basis, isa);
    for (std::size_t j = 0; j < layout.count; ++j) {
      Sh<double, N> y;
      basis_unrolled<N, double>(d[j], d[layout.stride + j], d[2 * layout.stride + j], y.values().data());
      EXPECT_LT(difference(item<N>(basis, layout, j), y, 1), kTolerance) << name_of(isa) << " " << N;
      ++compared;
    }
  });
  EXPECT_EQ(compared, kernels * 75);
}

TEST(Batch, ValuesAgreeForAnyNumberOfChannels) {
  const BatchLayout layout = BatchLayout::dense(53);
  const std::vector<float> d = directions(layout);
  int compared = 0;
  const int kernels = for_each_kernel([&]<int N>(Isa isa) {
    for (std::size_t channels = 0; channels <= 9; ++channels) {
      const std::vector<float> sh = random_rows(BatchLayout::dense(N * N), channels, 3);
      std::vector<float> values(layout.size(channels));
      evaluate_batch(N, sh, layout, d, values, isa);
      for (std::size_t channel = 0; channel < channels; ++channel) {
        Sh<double, N> f;
        for (std::size_t i = 0; i < f.size(); ++i) f[i] = sh[channel * f.size() + i];
        for (std::size_t j = 0; j < layout.count; ++j) {
          const Vec3 at = {d[j], d[layout.stride + j], d[2 * layout.stride + j]};
          // No function of this norm has a larger value anywhere.
          const double largest = norm(f) * N / std::sqrt(4 * kPi);
          EXPECT_NEAR(values[channel * layout.stride + j], evaluate(f, at), kTolerance * largest);
          ++compared;
        }
      }
    }
  });
  EXPECT_EQ(compared, kernels * 45 * 53);
}

/// Turns of every kind: about the axes, next to the poles of each decomposition, half turns, mirrors.
std::vector<Rotation> rotations(std::size_t count) {
  const Rotation mirror_y = {{Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}}};
  const Rotation mirror_z = {{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, -1}}};
  const Rotation inversion = {{Vec3{-1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, -1}}};
  std::vector<Rotation> all = {Rotation::identity(),
                               Rotation::about_z(0.9),
                               Rotation::about_z(kPi),
                               Rotation::about_x(kPi),
                               Rotation::about_y(kPi),
                               Rotation::about_y(kPi / 2),
                               Rotation::about_y(1e-3),
                               Rotation::about_y(1e-6),
                               Rotation::about_y(1e-9),
                               Rotation::about_x(kPi - 1e-4),
                               Rotation::about_x(1e-16),
                               Rotation::about_x(1e-30),
                               mirror_y,
                               mirror_z,
                               inversion};
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  while (all.size() < count) {
    const Rotation turn =
        Rotation::about(normalize({normal(random), normal(random), normal(random)}), 3 * normal(random));
    all.push_back(all.size() % 3 == 0 ? turn * mirror_y : turn);
  }
  return all;
}

TEST(Batch, RotatesAllByOne) {
  const BatchLayout layout = BatchLayout::dense(35);
  int compared = 0;
  const int kernels = for_each_kernel([&]<int N>(Isa isa) {
    const std::vector<float> from = random_rows(layout, N * N, 7);
    std::vector<float> to(from.size());
    for (const Rotation& turn : rotations(20)) {
      rotate_batch(N, turn, layout, from, to, isa);
      for (std::size_t j = 0; j < layout.count; ++j) {
        const Sh<double, N> f = item<N>(from, layout, j);
        EXPECT_LT(difference(item<N>(to, layout, j), rotate(f, turn), norm(f)), kTolerance) << name_of(isa) << " " << N;
        ++compared;
      }
    }
  });
  EXPECT_EQ(compared, kernels * 20 * 35);
}

TEST(Batch, RotatesEachByItsOwn) {
  const BatchLayout layout = BatchLayout::padded(301);
  const std::vector<Rotation> turns = rotations(layout.count);
  std::vector<float> matrices(layout.size(9));
  for (std::size_t j = 0; j < layout.count; ++j) {
    for (std::size_t row = 0; row < 3; ++row) {
      const Vec3 v = turns[j].rows[row];
      matrices[(3 * row + 0) * layout.stride + j] = static_cast<float>(v.x);
      matrices[(3 * row + 1) * layout.stride + j] = static_cast<float>(v.y);
      matrices[(3 * row + 2) * layout.stride + j] = static_cast<float>(v.z);
    }
  }
  int compared = 0;
  const int kernels = for_each_kernel([&]<int N>(Isa isa) {
    const std::vector<float> from = random_rows(layout, N * N, 9);
    std::vector<float> to(from.size());
    rotate_batch(N, matrices, layout, from, to, isa);
    for (std::size_t j = 0; j < layout.count; ++j) {
      const Sh<double, N> f = item<N>(from, layout, j), expected = ShRotation<N>(turns[j]).apply(f);
      EXPECT_LT(difference(item<N>(to, layout, j), expected, norm(f)), kTolerance) << name_of(isa) << N << " " << j;
      ++compared;
    }
  });
  EXPECT_EQ(compared, kernels * 301);
}

TEST(Batch, MultipliesPairs) {
  const BatchLayout layout = BatchLayout::dense(61);
  int compared = 0;
  const int kernels = for_each_kernel([&]<int N>(Isa isa) {
    const std::vector<float> f = random_rows(layout, N * N, 11), g = random_rows(layout, N * N, 12);
    std::vector<float> products(f.size());
    product_batch(N, layout, f, g, products, isa);
    for (std::size_t j = 0; j < layout.count; ++j) {
      const Sh<double, N> a = item<N>(f, layout, j), b = item<N>(g, layout, j);
      EXPECT_LT(difference(item<N>(products, layout, j), product(a, b), norm(a) * norm(b)), kTolerance);
      ++compared;
    }
  });
  EXPECT_EQ(compared, kernels * 61);
}

TEST(Batch, MatricesMultiplyAsProductsDo) {
  const BatchLayout layout = BatchLayout::dense(21);
  int compared = 0;
  const int kernels = for_each_kernel([&]<int N>(Isa isa) {
    const std::vector<float> f = random_rows(layout, N * N, 13);
    std::vector<float> matrices(layout.size(product_matrix_entries(N)));
    product_matrix_batch(N, layout, f, matrices, isa);
    for (std::size_t j = 0; j < layout.count; ++j) {
      const Sh<double, N> a = item<N>(f, layout, j);
      const ProductMatrix<N> expected(a);
      for (std::size_t row = 0; row < N * N; ++row) {
        for (std::size_t column = 0; column < N * N; ++column, ++compared) {
          const float entry = matrices[product_matrix_entry(row, column) * layout.stride + j];
          EXPECT_NEAR(entry, expected(row, column), kTolerance * norm(a));
        }
      }
    }
  });
  EXPECT_EQ(kernels, 6 * static_cast<int>(available_isas().size()));
  EXPECT_EQ(compared, kernels / 6 * 21 * (1 + 16 + 81 + 256 + 625 + 1296));
}

TEST(Batch, ErrorsOfTheCallerAreFound) {
  const BatchLayout three = BatchLayout::dense(3);
  std::vector<float> small(3 * 4), d(3 * 3), matrix(9 * 3, 0.0f);
  EXPECT_NO_THROW(basis_batch(2, three, d, small));
  EXPECT_THROW(basis_batch(0, three, d, small), std::logic_error);
  EXPECT_THROW(basis_batch(7, three, d, small), std::logic_error);
  EXPECT_THROW(basis_batch(3, three, d, small), std::logic_error);
  EXPECT_THROW(basis_batch(2, three, small, small), std::logic_error);
  EXPECT_THROW(basis_batch(2, {3, 2}, d, small), std::logic_error);
  EXPECT_THROW(evaluate_batch(2, std::vector<float>(5), three, d, small), std::logic_error);
  EXPECT_THROW(evaluate_batch(2, std::vector<float>(8), three, d, small), std::logic_error);
  EXPECT_THROW(rotate_batch(2, Rotation{{Vec3{2, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}, three, small, small),
               std::logic_error);
  EXPECT_THROW(product_batch(2, three, small, d, small), std::logic_error);
  EXPECT_THROW(product_matrix_batch(2, three, small, small), std::logic_error);
  for (const std::size_t i : {0, 4, 8}) std::fill_n(matrix.begin() + static_cast<long>(3 * i), 3, 1.0f);
  for (const Isa isa : available_isas()) {
    EXPECT_NO_THROW(rotate_batch(2, matrix, three, small, small, isa));
    for (const float wrong : {0.0f, 1.00001f, std::nanf("")}) {
      std::vector<float> bad = matrix;
      bad[3 * 8 + 2] = wrong;
      EXPECT_THROW(rotate_batch(2, bad, three, small, small, isa), std::logic_error) << wrong;
    }
  }
}

}  // namespace
}  // namespace zonal
