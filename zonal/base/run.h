#pragma once

#include <functional>
#include <stop_token>
#include <string_view>

#include "zonal/base/cpu.h"

namespace zonal {

/// Runs tasks 0..count-1, in any order and on any threads, and returns when all are done. A host program that has its
/// own job system supplies one of these; tasks never wait for each other.
using Executor = std::function<void(int count, const std::function<void(int task)>& task)>;

/// How a long verb runs. Only verbs that take a Run may be slow, parallel or cancelled. Results do not depend on
/// `threads`.
struct Run {
  int threads = 0;            ///< 0: one for each hardware thread
  std::stop_token stop = {};  ///< when requested, the verb throws Error{kCancelled}
  std::function<void(std::string_view stage, double fraction)> progress = {};  ///< called from one thread at a time
  Executor executor = {};                                                      ///< empty: our own threads
  Isa isa = best_isa();  ///< a weaker one repeats the bits of a weaker machine
};

}  // namespace zonal
