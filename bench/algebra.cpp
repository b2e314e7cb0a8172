// The algebra of few bands, in float, one core: single calls, and batches on each instruction set. Evaluation is set
// beside what the machine allows.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <new>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "bench/machine.h"
#include "bench/sprint.h"
#include "zonal/sh/batch.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/product.h"
#include "zonal/sh/product_matrix.h"
#include "zonal/sh/rotate.h"

namespace {

using namespace zonal;

constexpr std::size_t kNear = 200;          // directions whose basis stays in the first cache
constexpr std::size_t kCached = 1000;       // a batch that stays in the second cache
constexpr std::size_t kProbes = 4096;       // a volume of 16^3
constexpr std::size_t kStreamed = 1 << 20;  // directions whose basis goes to memory
constexpr std::size_t kSingles = 250;       // functions for single calls: a first cache full

/// Floats on cache lines.
class Rows {
 public:
  explicit Rows(std::size_t count) : store_(count + 16) {
    const auto misaligned = reinterpret_cast<std::uintptr_t>(store_.data()) % 64 / sizeof(float);
    values_ = std::span(store_).subspan((16 - misaligned) % 16, count);
    std::mt19937 random(1);
    std::normal_distribution<float> normal;
    for (float& value : values_) value = normal(random);
  }
  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;
  operator std::span<float>() const { return values_; }
  operator std::span<const float>() const { return values_; }
  float operator[](std::size_t i) const { return values_[i]; }
  float& operator[](std::size_t i) { return values_[i]; }
  double ends() const { return values_.front() + values_.back(); }

 private:
  std::vector<float> store_;
  std::span<float> values_;
};

/// A number that counts how often it is multiplied: additions come free with that.
struct Counted {
  static inline int multiplications = 0;
  friend Counted operator*(Counted, Counted) { return ++multiplications, Counted(); }
  friend Counted operator*(double, Counted) { return ++multiplications, Counted(); }
  friend Counted operator+(Counted, Counted) { return {}; }
  friend Counted operator+(Counted, double) { return {}; }
  friend Counted operator-(Counted, Counted) { return {}; }
  friend Counted operator-(Counted, double) { return {}; }
};

template <int N>
int multiplications_of_basis() {
  Counted y[N * N];
  Counted::multiplications = 0;
  basis_unrolled<N, Counted, double>({}, {}, {}, y);
  return Counted::multiplications;
}

std::string per_isa(const char* what, Isa isa) { return std::string(what) + ", " + std::string(name_of(isa)); }

/// All basis functions at many directions, and what bounds that.
template <int N>
void race_basis(std::size_t count, const char* where) {
  const BatchLayout layout = BatchLayout::padded(count);
  const Rows directions(layout.size(3)), basis(layout.size(N * N));
  const std::size_t passes = std::max<std::size_t>(1, 20 * kCached / count);  // a clock's tick is nothing beside them
  const auto items = static_cast<long>(count * passes);
  std::vector<bench::Runner> runners = {{"one direction at a time", items, [&] {
                                           const std::span<float> out = basis;
                                           for (std::size_t i = 0; i < passes * count; ++i) {
                                             const std::size_t j = i % count;
                                             basis_unrolled<N, float>(directions[j], directions[layout.stride + j],
                                                                      directions[2 * layout.stride + j],
                                                                      out.data() + j * N * N);
                                           }
                                           return basis.ends();
                                         }}};
  for (const Isa isa : available_isas()) {
    runners.push_back({per_isa("batch", isa), items, [&, isa] {
                         for (std::size_t i = 0; i < passes; ++i) basis_batch(N, layout, directions, basis, isa);
                         return basis.ends();
                       }});
  }
  const std::string title = "evaluate " + std::to_string(N) + " bands, " + where;
  const double taken = bench::sprint(title, runners, count > kProbes ? 20 : 400).back();
  const Isa isa = best_isa();
  const double by_multiplying = multiplications_of_basis<N>() / bench::multiplications_per_ns(isa);
  const double by_writing = N * N * sizeof(float) / bench::bytes_written_per_ns(isa, basis);
  std::printf("  %d multiplications take %.2f ns, writing %d bytes %.2f ns: bound by %s, at %.2f of the bound\n",
              multiplications_of_basis<N>(), by_multiplying, N * N * static_cast<int>(sizeof(float)), by_writing,
              by_multiplying > by_writing ? "multiplying" : "writing", taken / std::max(by_multiplying, by_writing));
}

/// Functions of one and of three channels at many directions.
template <int N>
void race_evaluate() {
  const BatchLayout layout = BatchLayout::padded(kCached);
  const Rows directions(layout.size(3)), values(layout.size(3)), sh(3 * N * N);
  Sh<float, N> one;
  for (std::size_t i = 0; i < one.size(); ++i) one[i] = sh[i];
  std::vector<bench::Runner> runners = {
      {"one channel, one direction at a time", kCached, [&] {
         const std::span<float> out = values;
         for (std::size_t j = 0; j < layout.count; ++j) {
           const Vec3 d = {directions[j], directions[layout.stride + j], directions[2 * layout.stride + j]};
           out[j] = evaluate(one, d);
         }
         return values.ends();
       }}};
  for (const Isa isa : available_isas()) {
    for (const std::size_t channels : {1, 3}) {
      runners.push_back({per_isa(channels == 1 ? "one channel" : "three channels", isa), kCached, [&, isa, channels] {
                           evaluate_batch(N, std::span<const float>(sh).first(channels * N * N), layout, directions,
                                          std::span<float>(values).first(layout.size(channels)), isa);
                           return values.ends();
                         }});
    }
  }
  bench::sprint("values of a function of " + std::to_string(N) + " bands", runners);
}

/// Functions one by one, as a program without batches has them; results are written in place.
template <class T, int N>
struct Singles {
  std::vector<Sh<T, N>> f = std::vector<Sh<T, N>>(kSingles), g = f, result = f;
  std::vector<Rotation> turns;

  Singles() {
    std::mt19937 random(1);
    std::normal_distribution<float> normal;
    for (std::size_t j = 0; j < kSingles; ++j) {
      for (std::size_t i = 0; i < f[j].size(); ++i) f[j][i] = normal(random), g[j][i] = normal(random);
      turns.push_back(Rotation::about(normalize({normal(random), normal(random), normal(random)}), normal(random)));
    }
  }
  /// result[j] = verb(j)
  template <class Verb>
  double each(Verb&& verb) {
    for (std::size_t j = 0; j < kSingles; ++j) new (&result[j]) Sh<T, N>(verb(j));
    return static_cast<double>(result.front()[0] + result.back()[N * N - 1]);
  }
};

template <int N>
void race_rotate() {
  Singles<float, N> singles;
  Singles<double, N> doubles;
  const BatchLayout layout = BatchLayout::padded(kProbes), dense = BatchLayout::dense(kProbes);
  const Rows from(layout.size(N * N)), to(layout.size(N * N));
  Rows turns(layout.size(9));
  for (std::size_t j = 0; j < layout.stride; ++j) {
    const auto& rows = singles.turns[j % kSingles].rows;
    for (std::size_t i = 0; i < 9; ++i) {
      const Vec3 row = rows[i / 3];
      turns[i * layout.stride + j] = static_cast<float>(i % 3 == 0 ? row.x : i % 3 == 1 ? row.y : row.z);
    }
  }
  std::vector<bench::Runner> runners = {
      {"by matrices: build and apply", kSingles,
       [&] {
         return singles.each([&](std::size_t j) { return ShRotation<N>(singles.turns[j]).apply(singles.f[j]); });
       }},
      {"single call", kSingles,
       [&] { return singles.each([&](std::size_t j) { return rotate(singles.f[j], singles.turns[j]); }); }},
      {"single call, double", kSingles,
       [&] { return doubles.each([&](std::size_t j) { return rotate(doubles.f[j], doubles.turns[j]); }); }}};
  for (const Isa isa : available_isas()) {
    runners.push_back({per_isa("batch by one rotation", isa), kProbes, [&, isa] {
                         rotate_batch(N, singles.turns[0], layout, from, to, isa);
                         return to.ends();
                       }});
    runners.push_back({per_isa("batch by a rotation each", isa), kProbes, [&, isa] {
                         rotate_batch(N, turns, layout, from, to, isa);
                         return to.ends();
                       }});
  }
  runners.push_back({"batch by one rotation, dense rows of 4096", kProbes, [&] {
                       rotate_batch(N, singles.turns[0], dense, std::span<const float>(from).first(dense.size(N * N)),
                                    std::span<float>(to).first(dense.size(N * N)));
                       return to.ends();
                     }});
  bench::sprint("rotate " + std::to_string(N) + " bands", runners);
}

template <int N>
void race_product() {
  Singles<float, N> singles;
  Singles<double, N> doubles;
  const BatchLayout layout = BatchLayout::padded(kProbes);
  const Rows f(layout.size(N * N)), g(layout.size(N * N)), result(layout.size(N * N));
  std::vector<bench::Runner> runners = {
      {"by matrix: build and apply", kSingles,
       [&] { return singles.each([&](std::size_t j) { return ProductMatrix<N>(singles.f[j]).apply(singles.g[j]); }); }},
      {"single call", kSingles,
       [&] { return singles.each([&](std::size_t j) { return product(singles.f[j], singles.g[j]); }); }},
      {"single call, double", kSingles,
       [&] { return doubles.each([&](std::size_t j) { return product(doubles.f[j], doubles.g[j]); }); }}};
  for (const Isa isa : available_isas()) {
    runners.push_back({per_isa("batch", isa), kProbes, [&, isa] {
                         product_batch(N, layout, f, g, result, isa);
                         return result.ends();
                       }});
  }
  bench::sprint("multiply pairs of " + std::to_string(N) + " bands", runners);
}

template <int N>
void race_matrix(std::size_t count) {
  Singles<float, N> singles;
  const BatchLayout layout = BatchLayout::padded(count);
  const Rows f(layout.size(N * N)), matrices(layout.size(product_matrix_entries(N)));
  std::vector<bench::Runner> runners = {{"single call, double, every entry", kSingles, [&] {
                                           double sum = 0;
                                           for (const Sh<float, N>& one : singles.f) {
                                             const ProductMatrix<N> matrix(one);
                                             sum += matrix(0, 0) + matrix(N * N - 1, N * N - 1);
                                           }
                                           return sum;
                                         }}};
  for (const Isa isa : available_isas()) {
    runners.push_back({per_isa("batch", isa), static_cast<long>(count), [&, isa] {
                         product_matrix_batch(N, layout, f, matrices, isa);
                         return matrices.ends();
                       }});
  }
  const std::string title =
      "product matrices of " + std::to_string(N) + " bands, " + std::to_string(count) + " functions";
  const double taken = bench::sprint(title, runners, 40).back();
  const std::size_t bytes = product_matrix_entries(N) * sizeof(float);
  const double by_writing = static_cast<double>(bytes) / bench::bytes_written_per_ns(best_isa(), matrices);
  std::printf("  writing %zu bytes takes %.2f ns: at %.2f of that\n", bytes, by_writing, taken / by_writing);
}

}  // namespace

int main() {
  for (const Isa isa : available_isas()) {
    std::printf("%s: %.1f float multiplications with additions a nanosecond\n", std::string(name_of(isa)).c_str(),
                bench::multiplications_per_ns(isa));
  }
  race_basis<3>(kNear, "results in the first cache");
  race_basis<6>(kNear, "results in the first cache");
  race_basis<6>(kCached, "results in the second cache");
  race_basis<3>(kStreamed, "results to memory");
  race_basis<6>(kStreamed, "results to memory");
  race_evaluate<3>();
  race_evaluate<6>();
  race_rotate<3>();
  race_rotate<6>();
  race_product<3>();
  race_product<6>();
  race_matrix<3>(kProbes);
  race_matrix<6>(kProbes);
}
