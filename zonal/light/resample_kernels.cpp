#include "zonal/light/resample_kernel.h"

namespace zonal {

const ResampleKernels& resample_kernels(Isa isa) {
#if defined(__x86_64__)
  if (isa == Isa::kAvx512) return avx512::kResampleKernels;
  if (isa == Isa::kAvx2) return avx2::kResampleKernels;
#endif
  (void)isa;
  return baseline::kResampleKernels;
}

}  // namespace zonal
