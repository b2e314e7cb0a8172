#pragma once

namespace zonal {

/// A point of a picture in pixels: (0, 0) is the outer corner of the top left texel, texel (i, j) is centred at (i+½,
/// j+½).
struct PixelPoint {
  double x = 0, y = 0;
  bool operator==(const PixelPoint&) const = default;
};

/// A texel by column and row, (0, 0) at the top left.
struct Texel {
  int x = 0, y = 0;
  bool operator==(const Texel&) const = default;
};

constexpr PixelPoint center_of(Texel t) { return {t.x + 0.5, t.y + 0.5}; }

}  // namespace zonal
