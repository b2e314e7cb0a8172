#include "zonal/sh/rotate.h"

#include <array>
#include <vector>

#include "zonal/sh/rotate_kernel.h"

namespace zonal {
namespace {

const RotateKernels& best_kernels() {
  static const RotateKernels& kernels = rotate_kernels(best_isa());
  return kernels;
}

template <class T>
void turn(void (*const (&kernels)[3])(const double*, const T*, T*, long), const Rotation& rotation, int bands,
          int count, std::span<const T> from, std::span<T> to) {
  const auto size = static_cast<std::size_t>(count * coefficient_count(bands));
  check(4 <= bands && bands <= 6 && from.size() == size && to.size() == size,
        "rotate_by_turns takes functions of 4 to 6 bands");
  static_assert(sizeof rotation.rows == 9 * sizeof(double), "a rotation is read as a run of numbers");
  kernels[bands - 4](&rotation.rows[0].x, from.data(), to.data(), count);
}

}  // namespace

void rotation_blocks(const Rotation& rotation, int bands, std::span<double> blocks) {
  check(bands >= 1 && blocks.size() == static_cast<std::size_t>(rotation_entries(bands)),
        "rotation_blocks needs room for each entry");
  check_orthogonal(rotation);
  blocks[0] = 1;
  if (bands == 1) return;
  // Band 1 is the vector (y, z, x) up to a factor.
  const auto& [x, y, z] = rotation.rows;
  const std::array<double, 9> first = {y.y, y.z, y.x, z.y, z.z, z.x, x.y, x.z, x.x};
  for (std::size_t i = 0; i < 9; ++i) blocks[1 + i] = first[i];
  if (bands <= kMaxStaticBands) {
    rotation_detail::grow_few(blocks, bands);
  } else {
    const auto widest = static_cast<std::size_t>(2 * bands - 1);
    std::vector<rotation_detail::Terms> terms(widest);
    std::vector<double> rows(3 * widest);
    rotation_detail::grow(blocks, bands, {terms, rows});
  }
}

void rotate_by_turns(const Rotation& rotation, int bands, int count, std::span<const float> from, std::span<float> to) {
  turn(best_kernels().in_float, rotation, bands, count, from, to);
}
void rotate_by_turns(const Rotation& rotation, int bands, int count, std::span<const double> from,
                     std::span<double> to) {
  turn(best_kernels().in_double, rotation, bands, count, from, to);
}

}  // namespace zonal
