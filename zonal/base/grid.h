#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "zonal/base/check.h"

namespace zonal {

/// Width x height values in rows, the top row first. A plain value: copies copy.
template <class T>
class Grid {
 public:
  Grid() = default;
  Grid(int width, int height, const T& fill = T{}) : width_(width), height_(height) {
    check(width >= 0 && height >= 0, "a grid's sides must not be negative");
    values_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill);
  }

  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t size() const { return values_.size(); }
  bool empty() const { return values_.empty(); }

  T& operator()(int x, int y) { return values_[index(x, y)]; }
  const T& operator()(int x, int y) const { return values_[index(x, y)]; }

  std::span<T> row(int y) { return {values_.data() + index(0, y), static_cast<std::size_t>(width_)}; }
  std::span<const T> row(int y) const { return {values_.data() + index(0, y), static_cast<std::size_t>(width_)}; }
  std::span<T> values() { return values_; }
  std::span<const T> values() const { return values_; }

  bool operator==(const Grid&) const = default;

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<T> values_;
};

}  // namespace zonal
