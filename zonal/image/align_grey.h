#pragma once

#include <array>
#include <cstdint>

#include "zonal/image/exposures.h"

namespace zonal {

// What the steps of an alignment see of a photograph.

using Grey = Image<std::uint8_t>;
inline constexpr int kGreyLevels = 256;
using GreyHistogram = std::array<std::int64_t, kGreyLevels>;

/// The green of a photograph as it was taken, in codes of 255. Unlike a mean of the channels, which clip one by one,
/// its order of brightness is the same in every exposure. Floats are spread by sRGB's curve first: as they are, most of
/// a linear picture lies in its lowest codes.
Grey grey_of(const CodedPicture&);

/// Half as wide and high, each texel the mean of four.
Grey halved(const Grey&);

/// A part of a picture, ends excluded.
struct Part {
  int left, top, right, bottom;
};
/// What `fixed` shows of `moving` when (x, y) of one is (x + dx, y + dy) of the other, and where that lies in `moving`.
Part shared_part(const Grey& fixed, const Grey& moving, Shift);
inline Part moved(Part part, Shift s) {
  return {part.left + s.dx, part.top + s.dy, part.right + s.dx, part.bottom + s.dy};
}

GreyHistogram histogram_of(const Grey&, Part);

}  // namespace zonal
