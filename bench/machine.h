#pragma once

#include <span>

#include "zonal/base/cpu.h"

namespace zonal::bench {

/// What one core can do at best, in this run.

/// Float multiplications, each with an addition, a nanosecond.
double multiplications_per_ns(Isa);

/// Bytes a nanosecond that vector stores write to `memory`, over and over: through the caches or past them, whichever
/// is faster.
double bytes_written_per_ns(Isa, std::span<float> memory);

}  // namespace zonal::bench
