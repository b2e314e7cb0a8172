#pragma once

#include "zonal/base/cpu.h"

/// ZONAL_KERNELS(Type, object, getter), in namespace zonal of a kernel's header: the kernel's file defines `object`, a
/// table of functions, in the namespace of each instruction set that it is compiled for, and getter(isa) returns that
/// one. Kernels are compiled with cmake/zonal.cmake; they include nothing with inline functions that they call, or the
/// linker might keep the strongest copy for everyone.
#if defined(__x86_64__)
#define ZONAL_KERNELS(Type, object, getter)         \
  namespace baseline {                              \
  extern const Type object;                         \
  }                                                 \
  namespace avx2 {                                  \
  extern const Type object;                         \
  }                                                 \
  namespace avx512 {                                \
  extern const Type object;                         \
  }                                                 \
  inline const Type& getter(Isa isa) {              \
    if (isa == Isa::kAvx512) return avx512::object; \
    if (isa == Isa::kAvx2) return avx2::object;     \
    return baseline::object;                        \
  }                                                 \
  static_assert(true)
#else
#define ZONAL_KERNELS(Type, object, getter)                   \
  namespace baseline {                                        \
  extern const Type object;                                   \
  }                                                           \
  inline const Type& getter(Isa) { return baseline::object; } \
  static_assert(true)
#endif
