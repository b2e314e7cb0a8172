#include "zonal/sht/kernels.h"

namespace zonal {

#if defined(__x86_64__)
#define ZONAL_FOR_EACH_ISA(X) X(baseline) X(avx2) X(avx512)
#else
#define ZONAL_FOR_EACH_ISA(X) X(baseline)
#endif

#define ZONAL_DECLARE(isa)                         \
  namespace isa {                                  \
  extern const RingKernels kRingKernels;           \
  extern const MomentKernels kMomentKernels;       \
  extern const LegendreKernels kLegendreKernels;   \
  }
ZONAL_FOR_EACH_ISA(ZONAL_DECLARE)
#undef ZONAL_DECLARE

#define ZONAL_RING(isa) &isa::kRingKernels,
#define ZONAL_MOMENT(isa) &isa::kMomentKernels,
#define ZONAL_LEGENDRE(isa) &isa::kLegendreKernels,

const RingKernels& ring_kernels(Isa isa) {
  static constexpr const RingKernels* kTable[] = {ZONAL_FOR_EACH_ISA(ZONAL_RING)};
  return *kTable[static_cast<int>(isa)];
}

const MomentKernels& moment_kernels(Isa isa) {
  static constexpr const MomentKernels* kTable[] = {ZONAL_FOR_EACH_ISA(ZONAL_MOMENT)};
  return *kTable[static_cast<int>(isa)];
}

const LegendreKernels& legendre_kernels(Isa isa) {
  static constexpr const LegendreKernels* kTable[] = {ZONAL_FOR_EACH_ISA(ZONAL_LEGENDRE)};
  return *kTable[static_cast<int>(isa)];
}

}  // namespace zonal
