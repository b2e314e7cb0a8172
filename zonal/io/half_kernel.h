#pragma once

#include <cstddef>
#include <cstdint>

#include "zonal/base/kernel.h"

namespace zonal {

/// The loops of half.h, which has their contracts.
struct HalfKernels {
  std::size_t (*halves_from_floats)(const float* in, std::uint16_t* out, std::size_t count);
  void (*floats_from_halves)(const std::uint16_t* in, float* out, std::size_t count);
};
ZONAL_KERNELS(HalfKernels, kHalfKernels, half_kernels);

}  // namespace zonal
