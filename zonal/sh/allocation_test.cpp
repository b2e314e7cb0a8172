// Verbs on static bands take no heap, so that they can run in a game's frame.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <vector>

#include "zonal/sh/gradient.h"
#include "zonal/sh/half_space.h"
#include "zonal/sh/product.h"
#include "zonal/sh/product_matrix.h"
#include "zonal/sh/rotate.h"

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
  const std::vector<double> zonal = {1, 0.5, 0.25, 0.1};
  int tried = 0;
  Sh<T, N> sink;
  const auto expect = [&](auto&& work, const char* verb) {
    EXPECT_EQ(allocations_of([&] { sink += work(); }), 0) << verb << " " << N;
    ++tried;
  };
  expect([&] { return rotate(sh, turn); }, "rotate");
  expect([&] { return rotate(sh, Rotation::about_z(1)); }, "rotate about z");
  expect([&] { return ShRotation<N>(turn).apply_inverse(sh); }, "ShRotation");
  expect([&] { return cast<T>(product(sh, plain)); }, "product");
  expect([&] { return ProductMatrix<N>(plain).apply(sh); }, "ProductMatrix");
  expect([&] { return product_with_zonal(sh, zonal, axis); }, "product_with_zonal");
  expect([&] { return multiply_by_half_space(sh, axis); }, "multiply_by_half_space");
  expect([&] { return multiply_by_clamped_cosine(sh, axis); }, "multiply_by_clamped_cosine");
  EXPECT_EQ(allocations_of([&] { plain[0] += gradient(plain, axis).x; }), 0) << "gradient " << N;
  EXPECT_NE(sink[0], T());
  return tried + 1;
}

TEST(Allocation, NoneInVerbsOnStaticBands) {
  EXPECT_GT(allocations_of([] { EXPECT_GT(Sh<double>(4).size(), 0u); }), 0) << "the counter sees nothing";
  int tried = 0;
  [&]<int... n>(std::integer_sequence<int, n...>) {
    ((tried += expect_no_heap<float, n + 1>() + expect_no_heap<Rgb, n + 1>()), ...);
  }
  (std::make_integer_sequence<int, 6>());
  EXPECT_EQ(tried, 6 * 2 * 9);
}

}  // namespace
}  // namespace zonal
