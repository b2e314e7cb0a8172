#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace zonal {

/// Disjoint sets of 0..count-1, each known by one of them (Tarjan 1975, with path halving).
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  int root(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Both are roots; the first stays one.
  void join(int root, int child) { parent_[child] = root; }

 private:
  std::vector<int> parent_;
};

}  // namespace zonal
