#include "zonal/sh/batch.h"

#include <algorithm>
#include <array>

#include "zonal/base/check.h"
#include "zonal/sh/batch_kernels.h"
#include "zonal/sh/rotate.h"

namespace zonal {
namespace {

/// The index of the kernel.
std::size_t checked(int bands, BatchLayout layout) {
  check(1 <= bands && bands <= kMaxStaticBands, "batches are of 1 to 6 bands");
  check(layout.stride >= layout.count, "the rows of a batch must not overlap");
  return static_cast<std::size_t>(bands - 1);
}

std::size_t coefficients(int bands) { return static_cast<std::size_t>(coefficient_count(bands)); }

template <class T>
BatchRows<T> rows_of(BatchLayout layout, std::size_t rows, std::span<T> values) {
  check(values.size() == layout.size(rows), "a batch is as large as its layout says");
  return {values.data(), static_cast<long>(layout.stride)};
}

long count_of(BatchLayout layout) { return static_cast<long>(layout.count); }

}  // namespace

void basis_batch(int bands, BatchLayout layout, std::span<const float> directions, std::span<float> basis, Isa isa) {
  const std::size_t kernel = checked(bands, layout);
  const BatchIn from = rows_of(layout, 3, directions);
  const BatchOut to = rows_of(layout, coefficients(bands), basis);
  batch_evaluate_kernels(isa).basis[kernel](from, count_of(layout), to);
}

void evaluate_batch(int bands, std::span<const float> sh, BatchLayout layout, std::span<const float> directions,
                    std::span<float> values, Isa isa) {
  const std::size_t kernel = checked(bands, layout), channels = sh.size() / coefficients(bands);
  check(sh.size() == channels * coefficients(bands), "each channel has its square of bands");
  const BatchIn from = rows_of(layout, 3, directions);
  const BatchOut to = rows_of(layout, channels, values);
  batch_evaluate_kernels(isa).evaluate[kernel](sh.data(), static_cast<int>(channels), from, count_of(layout), to);
}

void rotate_batch(int bands, const Rotation& rotation, BatchLayout layout, std::span<const float> from,
                  std::span<float> to, Isa isa) {
  const std::size_t kernel = checked(bands, layout);
  constexpr auto kMost = static_cast<std::size_t>(rotation_entries(kMaxStaticBands));
  std::array<double, kMost> exact;
  const std::span entries = std::span(exact).first(static_cast<std::size_t>(rotation_entries(bands)));
  rotation_blocks(rotation, bands, entries);
  std::array<float, kMost> blocks;
  std::ranges::transform(entries, blocks.begin(), [](double entry) { return static_cast<float>(entry); });
  const BatchIn in = rows_of(layout, coefficients(bands), from);
  const BatchOut out = rows_of(layout, coefficients(bands), to);
  batch_rotate_kernels(isa).by_one[kernel](blocks.data(), in, count_of(layout), out);
}

void rotate_batch(int bands, std::span<const float> rotations, BatchLayout layout, std::span<const float> from,
                  std::span<float> to, Isa isa) {
  const std::size_t kernel = checked(bands, layout);
  const BatchIn turns = rows_of(layout, 9, rotations), in = rows_of(layout, coefficients(bands), from);
  const BatchOut out = rows_of(layout, coefficients(bands), to);
  check(batch_rotate_kernels(isa).by_each[kernel](turns, in, count_of(layout), out), "a rotation must be orthogonal");
}

void product_batch(int bands, BatchLayout layout, std::span<const float> f, std::span<const float> g,
                   std::span<float> result, Isa isa) {
  const std::size_t kernel = checked(bands, layout), rows = coefficients(bands);
  batch_product_kernels(isa).product[kernel](rows_of(layout, rows, f), rows_of(layout, rows, g), count_of(layout),
                                             rows_of(layout, rows, result));
}

void product_matrix_batch(int bands, BatchLayout layout, std::span<const float> f, std::span<float> matrices, Isa isa) {
  const std::size_t kernel = checked(bands, layout);
  const BatchIn in = rows_of(layout, coefficients(bands), f);
  const BatchOut out = rows_of(layout, product_matrix_entries(bands), matrices);
  batch_matrix_kernels(isa).matrices[kernel](in, count_of(layout), out);
}

}  // namespace zonal
