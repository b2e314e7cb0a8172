#pragma once

#include <cstdint>

#include "zonal/image/image.h"
#include "zonal/image/tonemap.h"

namespace zonal {

/// What a target keeps of a pixel: what the shaders wrote, or colours for a screen.
enum class TargetTexels { kFloats, kBytes };

/// Samples of pictures for people: with four, an edge has five steps.
inline constexpr int kEdgeSamples = 4;

struct TargetOptions {
  TargetTexels texels = TargetTexels::kFloats;
  /// Places in a pixel at which it is asked what covers it: edges are means of so many. Fewer where the driver has
  /// fewer. Measurements take one, for a mean of two surfaces is neither.
  int samples = 1;
};

/// A picture to draw into, with depth.
class DrawTarget {
 public:
  /// Throws Error{kUsage} for sizes that the driver refuses.
  DrawTarget(int width, int height, const TargetOptions& = {});
  ~DrawTarget();
  DrawTarget(const DrawTarget&) = delete;
  DrawTarget& operator=(const DrawTarget&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }
  /// Draw calls go here from now on, over all of it.
  void bind() const;
  /// These rows, the lowest of all being row 0, into another target of this size and these texels: of each pixel the
  /// mean of its samples.
  void copy_to(const DrawTarget& single, int first_row, int rows) const;
  /// OpenGL's name of it as a frame.
  std::uint32_t frame() const { return frame_; }

  /// Red, green, blue; the top row first. Of a target without samples.
  Image<Rgb> read() const;
  /// The same in bytes.
  Image<Rgb8> read_bytes() const;

 private:
  void release();
  template <class Texel>
  Image<Texel> read_as(std::uint32_t type) const;

  int width_, height_;
  std::uint32_t frame_ = 0, color_ = 0, depth_ = 0;
};

}  // namespace zonal
