#pragma once

#include <cstddef>
#include <span>

#include "zonal/base/cpu.h"
#include "zonal/math/vec.h"
#include "zonal/sh/sh.h"

namespace zonal {

// The algebra for many functions or directions at once, as a volume of probes needs it: in float, for 1 to 6 bands, on
// the widest SIMD the machine has, one item in each lane. No heap (but 120 kB of stack) and no threads; give each
// thread its own items. An item comes out with the same bits wherever in the batch it is, and whatever is beside it;
// another instruction set may round otherwise. A colour is three functions. What is wrong with a call throws
// std::logic_error: a number of bands, a span that is not of the layout's size. NaN or infinity in an item stays in
// that item.

/// Where the numbers of a batch are: a structure of arrays. Number i of item j is values[i * stride + j], j < count;
/// what lies between count and stride is not touched. All batches of one call have the same layout.
struct BatchLayout {
  std::size_t count = 0;
  std::size_t stride = 0;  ///< from row to row, at least count

  /// Rows one behind the other.
  static constexpr BatchLayout dense(std::size_t count) { return {count, count}; }
  /// Rows an odd number of cache lines (of 64 bytes) long, so that they do not compete for the same places of a cache.
  /// Three times as fast as dense where count is a multiple of 256, as it often is.
  static constexpr BatchLayout padded(std::size_t count) { return {count, ((count + 15) / 16 / 2 * 2 + 1) * 16}; }

  constexpr std::size_t size(std::size_t rows) const { return rows * stride; }
};

/// The bands^2 basis functions at each unit direction. `directions` has rows x, y, z, `basis` a row for each function.
/// Results of more than 32 MB go to memory past the caches where that is possible (64-byte rows, counts of 16).
void basis_batch(int bands, BatchLayout layout, std::span<const float> directions, std::span<float> basis,
                 Isa isa = best_isa());

/// The values of functions at each unit direction: sh[channel * bands^2 + coefficient] holds one function or more (the
/// channels of a colour, say), `values` has a row for each.
void evaluate_batch(int bands, std::span<const float> sh, BatchLayout layout, std::span<const float> directions,
                    std::span<float> values, Isa isa = best_isa());

/// All functions turned by one rotation, as rotate() does. `from` and `to` have a row for each coefficient; they may be
/// the same.
void rotate_batch(int bands, const Rotation& rotation, BatchLayout layout, std::span<const float> from,
                  std::span<float> to, Isa isa = best_isa());

/// Each function turned by a rotation of its own, with or without a mirror. `rotations` has nine rows, the entries of
/// the matrix, its rows first. Throws std::logic_error, after the work, unless each is orthogonal to 1e-6.
void rotate_batch(int bands, std::span<const float> rotations, BatchLayout layout, std::span<const float> from,
                  std::span<float> to, Isa isa = best_isa());

/// The products of pairs, projected on the bands of the factors, as product() does. `result` may be `f` or `g`.
void product_batch(int bands, BatchLayout layout, std::span<const float> f, std::span<const float> g,
                   std::span<float> result, Isa isa = best_isa());

/// Entries of a product matrix that is stored once for (i, j) and (j, i), and the place of one of them.
constexpr std::size_t product_matrix_entries(int bands) {
  const auto n = static_cast<std::size_t>(coefficient_count(bands));
  return n * (n + 1) / 2;
}
constexpr std::size_t product_matrix_entry(std::size_t i, std::size_t j) {
  return i < j ? j * (j + 1) / 2 + i : i * (i + 1) / 2 + j;
}

/// The matrices that multiply by each function, M_ij = int f y_i y_j, as ProductMatrix is: a row for each entry.
void product_matrix_batch(int bands, BatchLayout layout, std::span<const float> f, std::span<float> matrices,
                          Isa isa = best_isa());

}  // namespace zonal
