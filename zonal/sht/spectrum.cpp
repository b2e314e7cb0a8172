#include "zonal/sht/spectrum.h"

#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace zonal {

double* AlignedDoubles::allocate(std::size_t bytes) {
  constexpr std::size_t kCacheLine = 64, kLargePage = 2UL << 20;
  const std::size_t alignment = bytes >= 2 * kLargePage ? kLargePage : kCacheLine;
  const std::size_t padded = (bytes + alignment - 1) / alignment * alignment;
  void* memory = std::aligned_alloc(alignment, padded);
  if (memory == nullptr) throw std::bad_alloc();
#if defined(__linux__)
  if (alignment == kLargePage) madvise(memory, padded, MADV_HUGEPAGE);  // advice: a refusal changes nothing
#endif
  return static_cast<double*>(memory);
}

}  // namespace zonal
