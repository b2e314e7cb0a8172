// An item of a batch has the same bits wherever it is and however the rows lie.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "zonal/sh/batch.h"

namespace zonal {
namespace {

constexpr int kBands = 6;
constexpr std::size_t kFunctions = 36, kKinds = 61;

/// What a verb does with the rows it reads and writes.
struct Verb {
  const char* name;
  std::size_t in, out;
  bool in_place;
  std::function<void(BatchLayout, std::span<const float> in, std::span<float> out, Isa)> run;
};

/// All verbs. Their inputs are one behind the other.
std::vector<Verb> verbs() {
  static const std::vector<float> sh = [] {
    std::vector<float> values(5 * kFunctions);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::sin(1.3f * static_cast<float>(i));
    return values;
  }();
  const Rotation turn = Rotation::about(normalize({1, 2, 3}), 0.8);
  return {
      {"basis", 3, kFunctions, false,
       [](BatchLayout l, auto in, auto out, Isa isa) { basis_batch(kBands, l, in, out, isa); }},
      {"evaluate", 3, 5, false,
       [](BatchLayout l, auto in, auto out, Isa isa) { evaluate_batch(kBands, sh, l, in, out, isa); }},
      {"rotate by one", kFunctions, kFunctions, true,
       [turn](BatchLayout l, auto in, auto out, Isa isa) { rotate_batch(kBands, turn, l, in, out, isa); }},
      {"rotate by each", 9 + kFunctions, kFunctions, true,
       [](BatchLayout l, auto in, auto out, Isa isa) {
         rotate_batch(kBands, in.first(l.size(9)), l, in.subspan(l.size(9)), out, isa);
       }},
      {"product", 2 * kFunctions, kFunctions, true,
       [](BatchLayout l, auto in, auto out, Isa isa) {
         product_batch(kBands, l, in.first(l.size(kFunctions)), in.subspan(l.size(kFunctions)), out, isa);
       }},
      {"matrices", kFunctions, product_matrix_entries(kBands), false,
       [](BatchLayout l, auto in, auto out, Isa isa) { product_matrix_batch(kBands, l, in, out, isa); }},
  };
}

/// Number `row` of an item of one of kKinds kinds. The first nine of a rotation by each are rotations.
float number(const Verb& verb, std::size_t row, std::size_t kind) {
  if (verb.in == 9 + kFunctions && row < 9) {
    const Rotation turn =
        Rotation::about(normalize({1, 2, static_cast<double>(kind)}), 0.3 * static_cast<double>(kind));
    const Vec3 v = turn.rows[row / 3];
    return static_cast<float>(row % 3 == 0 ? v.x : row % 3 == 1 ? v.y : v.z);
  }
  return std::sin(static_cast<float>(row * row + 3 * kind) + 0.5f);
}

constexpr float kUntouched = 12345.0f;

struct Arrangement {
  BatchLayout layout;
  std::size_t offset;  // floats before the first: odd ones are not aligned to anything
};

/// Runs the verb on items of kind (first + j) % kKinds, checks that nothing else was written, and returns the rows.
std::vector<float> run(const Verb& verb, const Arrangement& arrangement, std::size_t first, Isa isa, bool in_place) {
  const auto& [layout, offset] = arrangement;
  std::vector<float> in(offset + layout.size(verb.in), kUntouched), out(offset + layout.size(verb.out), kUntouched);
  for (std::size_t row = 0; row < verb.in; ++row) {
    for (std::size_t j = 0; j < layout.count; ++j) {
      in[offset + row * layout.stride + j] = number(verb, row, (first + j) % kKinds);
    }
  }
  const std::span<float> source = std::span(in).subspan(offset);
  const std::span<float> target = in_place ? source.last(layout.size(verb.out)) : std::span(out).subspan(offset);
  verb.run(layout, source, target, isa);
  for (std::size_t i = 0; i < offset; ++i) EXPECT_EQ(out[i], kUntouched) << verb.name;
  for (std::size_t row = 0; row < verb.out; ++row) {
    for (std::size_t j = layout.count; j < layout.stride; ++j) {
      EXPECT_EQ(target[row * layout.stride + j], kUntouched) << verb.name << ": written between rows";
    }
  }
  return {target.begin(), target.end()};
}

TEST(BatchLayout, BitsDoNotDependOnThePlace) {
  const std::vector<Arrangement> arrangements = {
      {BatchLayout::dense(0), 0},     {BatchLayout::dense(1), 0},
      {BatchLayout::dense(3), 1},     {{5, 9}, 1},
      {BatchLayout::dense(16), 0},    {BatchLayout::dense(37), 3},
      {BatchLayout::padded(37), 0},   {BatchLayout::dense(256), 0},
      {BatchLayout::dense(512), 1},   {{300, 512}, 0},
      {BatchLayout::padded(512), 16}, {BatchLayout::dense(301), 5},
  };
  std::size_t compared = 0, items = 0;
  for (const Isa isa : available_isas()) {
    for (const Verb& verb : verbs()) {
      const std::vector<float> each = run(verb, {BatchLayout::dense(kKinds), 0}, 0, isa, false);
      std::size_t first = 0;
      for (const Arrangement& arrangement : arrangements) {
        const BatchLayout& layout = arrangement.layout;
        for (const bool in_place : {false, true}) {
          if (in_place && !verb.in_place) continue;
          first += 17;
          const std::vector<float> rows = run(verb, arrangement, first, isa, in_place);
          items += layout.count * verb.out;
          for (std::size_t row = 0; row < verb.out; ++row) {
            for (std::size_t j = 0; j < layout.count; ++j, ++compared) {
              const float expected = each[row * kKinds + (first + j) % kKinds];
              ASSERT_EQ(rows[row * layout.stride + j], expected) << verb.name << " " << layout.count << " " << j;
            }
          }
        }
      }
    }
  }
  EXPECT_EQ(compared, items);
  EXPECT_GT(compared, 1000000u);
}

TEST(BatchLayout, ResultsThatPassTheCachesAreTheSame) {
  const BatchLayout layout = BatchLayout::padded(240000);  // 36 rows of it are more than 32 MB
  ASSERT_GT(layout.size(kFunctions) * sizeof(float), 32u << 20);
  std::vector<float> in(layout.size(3)), store(layout.size(kFunctions) + 16);
  // Where vectors can be stored past the caches.
  const auto misaligned = reinterpret_cast<std::uintptr_t>(store.data()) % 64 / sizeof(float);
  const std::span<float> out = std::span(store).subspan((16 - misaligned) % 16, layout.size(kFunctions));
  const std::vector<Verb> all = verbs();
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t j = 0; j < layout.count; ++j) in[row * layout.stride + j] = number(all[0], row, j % kKinds);
  }
  std::size_t compared = 0;
  for (const Isa isa : available_isas()) {
    const std::vector<float> each = run(all[0], {BatchLayout::dense(kKinds), 0}, 0, isa, false);
    basis_batch(kBands, layout, in, out, isa);
    std::size_t different = 0;
    for (std::size_t row = 0; row < kFunctions; ++row) {
      for (std::size_t j = 0; j < layout.count; ++j, ++compared) {
        different += out[row * layout.stride + j] != each[row * kKinds + j % kKinds];
      }
    }
    EXPECT_EQ(different, 0u) << name_of(isa);
  }
  EXPECT_EQ(compared, available_isas().size() * 36 * 240000);
}

TEST(BatchLayout, WhatIsNoNumberStaysInItsItem) {
  const BatchLayout layout = BatchLayout::dense(40);
  std::size_t compared = 0;
  for (const Isa isa : available_isas()) {
    for (const float wrong : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
      std::vector<float> f(layout.size(kFunctions), 1.0f), g = f, result(f.size());
      f[5 * layout.stride + 21] = wrong;
      product_batch(kBands, layout, f, g, result, isa);
      for (std::size_t row = 0; row < kFunctions; ++row) {
        for (std::size_t j = 0; j < layout.count; ++j, ++compared) {
          EXPECT_TRUE(j == 21 || std::isfinite(result[row * layout.stride + j]));
        }
      }
      EXPECT_FALSE(std::isfinite(result[5 * layout.stride + 21]));
    }
  }
  EXPECT_EQ(compared, available_isas().size() * 2 * 36 * 40);
}

TEST(BatchLayout, PaddedRowsStartOnLinesAndSpread) {
  for (std::size_t count = 0; count < 5000; ++count) {
    const BatchLayout layout = BatchLayout::padded(count);
    ASSERT_GE(layout.stride, count);
    ASSERT_LT(layout.stride, count + 48);
    ASSERT_EQ(layout.stride % 32, 16u);
  }
}

}  // namespace
}  // namespace zonal
