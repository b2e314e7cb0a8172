#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "zonal/image/image.h"
#include "zonal/image/placement.h"
#include "zonal/math/vec.h"

namespace zonal {

/// What stands where a photograph holds no data: NaN.
inline constexpr float kNoCode = std::numeric_limits<float>::quiet_NaN();

/// A photograph's encoded values (not linear light: what the file holds, 0 black, 1 the largest code), in the fewest
/// bytes that keep each of them: one a channel when all are multiples of 1/255, two when of 1/65535, else floats.
class CodedPicture {
 public:
  CodedPicture() = default;
  /// Throws Error{kInput} when a value is not finite, with their number.
  explicit CodedPicture(const Image<Rgb>& encoded);

  int width() const { return width_; }
  int height() const { return height_; }
  PicturePoint center() const { return {width_ / 2.0, height_ / 2.0}; }
  /// How many codes a channel can have: 256, 65536, or 0 when the values are floats.
  int levels() const;
  /// Row y as 0..1; floats as they are. `into` has the picture's width.
  void row(int y, std::span<Rgb> into) const;
  /// Single texels as 0..1, y * width + x each.
  void pick(std::span<const std::size_t> texels, std::span<Rgb> into) const;

 private:
  int width_ = 0, height_ = 0;
  std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>> samples_;
};

/// A move by whole texels.
struct Shift {
  int dx = 0, dy = 0;
  bool operator==(const Shift&) const = default;
};

/// One photograph of a bracket.
struct Exposure {
  std::string name;    ///< for messages
  double seconds = 0;  ///< exposure time, at one aperture and sensitivity for the whole bracket
  CodedPicture picture;
  Placement placement = {};
  Image<std::uint8_t> missing = {};  ///< 1 where the photograph holds no data; empty: nowhere
};

/// A bracket: photographs of one scene that differ in their exposure only.
using Exposures = std::vector<Exposure>;

/// Puts the photographs in the order of their exposure, the shortest first. Throws Error{kInput}: fewer than two, sizes
/// that differ, an exposure time that is not positive and finite, two that are the same (within 1 %, which is finer
/// than any camera's steps and coarser than what EXIF rounds).
void arrange(Exposures&);

/// Row y of the aligned photograph as encoded values, those of the texels in which the centres of the row's lie: codes
/// are never mixed. kNoCode where it has no data: outside a moved frame, or missing.
void read_row(const Exposure&, int y, std::span<Rgb> into);

/// The move of a photograph that was placed by whole texels.
std::optional<Shift> whole_shift(const Exposure&);

/// Marks as missing what is within `tolerance` of an encoded colour in every channel: borders that a scanner or a
/// registration filled. Returns how many texels.
std::int64_t mark_missing(Exposure&, Rgb color, float tolerance);

}  // namespace zonal
