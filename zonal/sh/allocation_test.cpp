// Verbs on static bands take no heap, so that they can run in a game's frame.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <vector>

#include "zonal/sh/ambient_cube.h"
#include "zonal/sh/batch.h"
#include "zonal/sh/gradient.h"
#include "zonal/sh/half_space.h"
#include "zonal/sh/irradiance.h"
#include "zonal/sh/product.h"
#include "zonal/sh/product_matrix.h"
#include "zonal/sh/rotate.h"
#include "zonal/sh/shading_constants.h"
#include "zonal/sh/window.h"
#include "zonal/sh/zh3.h"

namespace {

std::atomic<long> allocations = 0;

}  // namespace

// The whole test program counts; array forms come here too. Not inlined: the compiler must see pairs of new and delete,
// not of new and free.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size > 0 ? size : 1);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace zonal {
namespace {

template <class Work>
long allocations_of(Work&& work) {
  work();  // what is made once in the run of a program
  const long before = allocations;
  work();
  return allocations - before;
}

template <class T, int N>
int expect_no_heap() {
  Sh<T, N> sh;
  Sh<double, N> plain;
  for (std::size_t i = 0; i < sh.size(); ++i) plain[i] = 1 / (1.0 + static_cast<double>(i));
  if constexpr (kIsColor<T>) {
    sh = cast<T>(RgbD(1, 2, 3) * plain);
  } else {
    sh = cast<T>(plain);
  }
  const Vec3 axis = normalize({0.3, 0.2, -0.6});
  const Rotation turn = Rotation::about(axis, 1.2);
  const std::vector<double> zonal = {1, 0.5, 0.25, 0.1, 0.2, 0.3};
  const std::span bands = std::span(zonal).first(N);
  const AxialProduct<N> half = half_space<N>();
  int tried = 0;
  Sh<T, N> sink;
  const auto expect = [&](auto&& work, const char* verb) {
    EXPECT_EQ(allocations_of([&] { sink += work(); }), 0) << verb << " " << N;
    ++tried;
  };
  const auto expect_value = [&](auto&& work, const char* verb) {
    EXPECT_EQ(allocations_of([&] { sink[0] += static_cast<T>(work()); }), 0) << verb << " " << N;
    ++tried;
  };
  expect([&] { return rotate(sh, turn); }, "rotate");
  expect([&] { return rotate(sh, turn * Rotation{{Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}}}); }, "mirror");
  expect([&] { return rotate(sh, Rotation::about_z(1)); }, "rotate about z");
  expect([&] { return ShRotation<N>(turn).apply_inverse(sh); }, "ShRotation");
  expect([&] { return cast<T>(product(sh, plain)); }, "product");
  expect([&] { return cast<T>(product(plain, sh)); }, "product");
  expect([&] { return cast<T>(product_to<N>(sh, Sh<double, 2>())); }, "product of different bands");
  expect([&] { return ProductMatrix<N>(plain).apply(sh); }, "ProductMatrix");
  expect([&] { return product_with_zonal(sh, zonal, axis); }, "product_with_zonal");
  expect([&] { return half.apply(sh, axis); }, "AxialProduct");
  expect([&] { return multiply_by_half_space(sh, axis); }, "multiply_by_half_space");
  expect([&] { return multiply_by_clamped_cosine(sh, axis); }, "multiply_by_clamped_cosine");
  expect([&] { return convolve(sh, bands); }, "convolve");
  expect([&] { return irradiance(sh); }, "irradiance");
  expect([&] { return irradiance_over_pi(sh); }, "irradiance_over_pi");
  for (const Window& with : {Window::hann(N), Window::lanczos(N, 2), Window::laplacian(0.01),
                             Window::laplacian_fraction(0.5), Window::laplacian_fraction(0.5, WindowChannels::kEach)}) {
    expect([&] { return window(sh, with); }, "window");
  }
  expect([&] { return sh_from_ambient_cube<N>(ambient_cube(sh)); }, "ambient_cube");
  expect_value([&] { return evaluate(sh, axis); }, "evaluate");
  expect_value([&] { return evaluate(ambient_cube(sh), axis); }, "evaluate an ambient cube");
  expect_value([&] { return band_energies(sh)[0]; }, "band_energies");
  expect_value([&] { return squared_laplacian(sh); }, "squared_laplacian");
  EXPECT_EQ(allocations_of([&] { plain += zonal_toward<N>(bands, axis); }), 0) << "zonal_toward " << N;
  EXPECT_EQ(allocations_of([&] { plain[0] += gradient(plain, axis).x; }), 0) << "gradient " << N;
  EXPECT_NE(sink[0], T());
  return tried + 2;
}

/// Of a fixed number of bands.
template <class T>
int expect_no_heap_in_three_bands() {
  Sh<T, 3> sh, sink;
  for (std::size_t i = 0; i < sh.size(); ++i) sh[i] = static_cast<T>(Rgb(1, 2, 3));
  int tried = 0;
  const auto expect = [&](auto&& work, const char* verb) {
    EXPECT_EQ(allocations_of([&] { sink[0] += work(); }), 0) << verb;
    ++tried;
  };
  const Vec3 up = {0, 0, 1};
  expect([&] { return expand(zh3(sh))[4]; }, "zh3");
  expect([&] { return expand(zh3_guess(with_bands<2>(sh)))[4]; }, "zh3_guess");
  expect([&] { return irradiance_over_pi(irradiance_over_pi_constants(sh), up); }, "irradiance_over_pi_constants");
  expect([&] { return irradiance(irradiance_matrix(sh), up); }, "irradiance_matrix");
  EXPECT_NE(sink[0], T());
  return tried;
}

int expect_no_heap_in_batches() {
  int tried = 0;
  for (const BatchLayout layout : {BatchLayout::padded(100), BatchLayout::dense(256)}) {
    for (int bands = 1; bands <= kMaxStaticBands; ++bands) {
      const auto n = static_cast<std::size_t>(coefficient_count(bands));
      std::vector<float> d(layout.size(3)), f(layout.size(n)), g(f.size()), r(layout.size(9)), sh(3 * n),
          values(layout.size(3)), matrices(layout.size(product_matrix_entries(bands)));
      for (std::size_t i = 0; i < 9; i += 4) {
        for (std::size_t j = 0; j < layout.count; ++j) r[i * layout.stride + j] = 1;
      }
      const auto expect = [&](auto&& work, const char* verb) {
        EXPECT_EQ(allocations_of(work), 0) << verb << " " << bands;
        ++tried;
      };
      expect([&] { basis_batch(bands, layout, d, f); }, "basis_batch");
      expect([&] { evaluate_batch(bands, sh, layout, d, values); }, "evaluate_batch");
      expect([&] { rotate_batch(bands, Rotation::about_x(1), layout, f, g); }, "rotate_batch by one");
      expect([&] { rotate_batch(bands, r, layout, f, g); }, "rotate_batch by each");
      expect([&] { product_batch(bands, layout, f, g, g); }, "product_batch");
      expect([&] { product_matrix_batch(bands, layout, f, matrices); }, "product_matrix_batch");
    }
  }
  return tried;
}

TEST(Allocation, NoneInVerbsOnStaticBands) {
  EXPECT_GT(allocations_of([] { EXPECT_GT(Sh<double>(4).size(), 0u); }), 0) << "the counter sees nothing";
  int tried = 0;
  [&]<int... n>(std::integer_sequence<int, n...>) {
    ((tried += expect_no_heap<float, n + 1>() + expect_no_heap<Rgb, n + 1>()), ...);
  }
  (std::make_integer_sequence<int, 6>());
  EXPECT_EQ(tried, 6 * 2 * 27);
  EXPECT_EQ(expect_no_heap_in_three_bands<Rgb>() + expect_no_heap_in_three_bands<RgbD>(), 2 * 4);
}

TEST(Allocation, NoneInBatches) { EXPECT_EQ(expect_no_heap_in_batches(), 2 * 6 * 6); }

}  // namespace
}  // namespace zonal
