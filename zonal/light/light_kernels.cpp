#include "zonal/light/distribution_kernel.h"
#include "zonal/light/render_kernel.h"

namespace zonal {

#if defined(__x86_64__)
#define ZONAL_FOR_EACH_ISA(X) X(baseline) X(avx2) X(avx512)
#else
#define ZONAL_FOR_EACH_ISA(X) X(baseline)
#endif

#define ZONAL_DECLARE(isa)                     \
  namespace isa {                              \
  extern const RenderKernels kRenderKernels;   \
  extern const TallyRow kTallyRow;             \
  }
ZONAL_FOR_EACH_ISA(ZONAL_DECLARE)
#undef ZONAL_DECLARE

#define ZONAL_RENDER(isa) &isa::kRenderKernels,
#define ZONAL_TALLY(isa) &isa::kTallyRow,

const RenderKernels& render_kernels(Isa isa) {
  static constexpr const RenderKernels* kTable[] = {ZONAL_FOR_EACH_ISA(ZONAL_RENDER)};
  return *kTable[static_cast<int>(isa)];
}

TallyRow tally_row(Isa isa) {
  static constexpr const TallyRow* kTable[] = {ZONAL_FOR_EACH_ISA(ZONAL_TALLY)};
  return *kTable[static_cast<int>(isa)];
}

}  // namespace zonal
