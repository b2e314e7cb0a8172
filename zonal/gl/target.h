#pragma once

#include <cstdint>

#include "zonal/image/image.h"

namespace zonal {

/// A picture to draw into, with depth: floats, so that what comes back is what the shaders wrote.
class DrawTarget {
 public:
  /// Throws Error{kUsage} for sizes that the driver refuses.
  DrawTarget(int width, int height);
  ~DrawTarget();
  DrawTarget(const DrawTarget&) = delete;
  DrawTarget& operator=(const DrawTarget&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }
  /// Draw calls go here from now on.
  void bind() const;
  /// Red, green, blue; the top row first.
  Image<Rgb> read() const;

 private:
  int width_, height_;
  std::uint32_t frame_ = 0, color_ = 0, depth_ = 0;
};

}  // namespace zonal
