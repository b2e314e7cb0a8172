#include "bench/machine.h"

#include <algorithm>
#include <chrono>
#include <limits>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace zonal::bench {
namespace {

constexpr int kChains = 12;  // more than latency times units, fewer than registers
constexpr int kSteps = 4000;

/// The shortest of some runs.
template <class Work>
double shortest_ns(int rounds, Work&& work) {
  using Clock = std::chrono::steady_clock;
  double best = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round) {
    const auto begin = Clock::now();
    work();
    best = std::min(best, std::chrono::duration<double, std::nano>(Clock::now() - begin).count());
  }
  return best;
}

template <int Lanes>
struct VectorOf {
  typedef float Type __attribute__((vector_size(Lanes * sizeof(float))));
};

/// The body of each instruction set's function: inlined into it, and compiled as it is.
template <int Lanes>
[[gnu::always_inline]] inline float multiply_and_add() {
  using Vec = typename VectorOf<Lanes>::Type;
  Vec chains[kChains];
  for (Vec& chain : chains) chain = Vec{} + 1;
  const Vec factor = Vec{} + 0.999f;
  for (int step = 0; step < kSteps; ++step) {
#pragma GCC unroll 12
    for (int i = 0; i < kChains; ++i) chains[i] = chains[i] * factor + factor;
  }
  Vec sum = {};
  for (const Vec& chain : chains) sum += chain;
  return sum[0];
}

template <int Lanes>
[[gnu::always_inline]] inline void fill(std::span<float> memory) {
  using Vec = typename VectorOf<Lanes>::Type;
  const Vec value = Vec{} + 1;
  for (std::size_t i = 0; i + Lanes <= memory.size(); i += Lanes) {
    *reinterpret_cast<Vec*>(memory.data() + i) = value;
    asm volatile("" ::: "memory");  // not as memset
  }
}

float multiply_baseline() { return multiply_and_add<4>(); }
void fill_baseline(std::span<float> memory) { fill<4>(memory); }

#if defined(__x86_64__)
[[gnu::target("avx2,fma")]] float multiply_avx2() { return multiply_and_add<8>(); }
[[gnu::target("avx2,fma")]] void fill_avx2(std::span<float> memory) { fill<8>(memory); }
[[gnu::target("avx512f,fma,prefer-vector-width=512")]] float multiply_avx512() { return multiply_and_add<16>(); }
[[gnu::target("avx512f,fma,prefer-vector-width=512")]] void fill_avx512(std::span<float> memory) { fill<16>(memory); }

void fill_past_caches(std::span<float> memory) {
  for (std::size_t i = 0; i + 4 <= memory.size(); i += 4) _mm_stream_ps(memory.data() + i, _mm_set1_ps(1));
  _mm_sfence();
}
#endif

}  // namespace

double multiplications_per_ns(Isa isa) {
  float (*multiply)() = multiply_baseline;
  int lanes = 4;
#if defined(__x86_64__)
  if (isa == Isa::kAvx2) multiply = multiply_avx2, lanes = 8;
  if (isa == Isa::kAvx512) multiply = multiply_avx512, lanes = 16;
#endif
  volatile float consumed = 0;
  return 1.0 * lanes * kChains * kSteps / shortest_ns(400, [&] { consumed = consumed + multiply(); });
}

double bytes_written_per_ns(Isa isa, std::span<float> memory) {
  void (*fill_with)(std::span<float>) = fill_baseline;
#if defined(__x86_64__)
  if (isa == Isa::kAvx2) fill_with = fill_avx2;
  if (isa == Isa::kAvx512) fill_with = fill_avx512;
#endif
  const std::size_t passes = std::max<std::size_t>(1, (std::size_t{1} << 18) / memory.size());
  const auto write = [&](void (*with)(std::span<float>)) {
    return shortest_ns(passes > 1 ? 400 : 20,
                       [&] {
                         for (std::size_t i = 0; i < passes; ++i) with(memory);
                       }) /
           static_cast<double>(passes);
  };
  double best = write(fill_with);
#if defined(__x86_64__)
  best = std::min(best, write(fill_past_caches));
#endif
  return static_cast<double>(memory.size_bytes()) / best;
}

}  // namespace zonal::bench
