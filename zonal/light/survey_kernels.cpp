#include "zonal/light/survey_kernel.h"

namespace zonal {

const SurveyKernels& survey_kernels(Isa isa) {
#if defined(__x86_64__)
  if (isa == Isa::kAvx512) return avx512::kSurveyKernels;
  if (isa == Isa::kAvx2) return avx2::kSurveyKernels;
#endif
  (void)isa;
  return baseline::kSurveyKernels;
}

}  // namespace zonal
