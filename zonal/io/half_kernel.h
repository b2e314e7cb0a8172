#pragma once

#include <cstddef>
#include <cstdint>

// half_kernel.cpp is compiled once per instruction set, each copy in a namespace of that name. The contracts are in
// half.h.
#define ZONAL_HALF_KERNEL(isa)                                                            \
  namespace zonal::isa {                                                                  \
  std::size_t halves_from_floats(const float* in, std::uint16_t* out, std::size_t count); \
  void floats_from_halves(const std::uint16_t* in, float* out, std::size_t count);        \
  }

ZONAL_HALF_KERNEL(baseline)
ZONAL_HALF_KERNEL(avx2)
ZONAL_HALF_KERNEL(avx512)

#undef ZONAL_HALF_KERNEL
