#include "zonal/light/synthetic_stroke.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "zonal/base/check.h"

namespace zonal {
namespace {

/// A stroke in a box of 2 x 4 steps, (0, 0) at its lower left.
struct Line {
  int x0, y0, x1, y1;
};

constexpr Line kPlus[] = {{0, 2, 2, 2}, {1, 1, 1, 3}};
constexpr Line kMinus[] = {{0, 2, 2, 2}};
constexpr Line kX[] = {{0, 0, 2, 4}, {0, 4, 2, 0}};
constexpr Line kY[] = {{0, 4, 1, 2}, {2, 4, 1, 2}, {1, 2, 1, 0}};
constexpr Line kZ[] = {{0, 4, 2, 4}, {2, 4, 0, 0}, {0, 0, 2, 0}};
// Digits as on a seven-segment display: top, upper right, lower right, bottom, lower left, upper left, middle.
constexpr Line kSegments[] = {{0, 4, 2, 4}, {2, 2, 2, 4}, {2, 0, 2, 2}, {0, 0, 2, 0},
                              {0, 0, 0, 2}, {0, 2, 0, 4}, {0, 2, 2, 2}};
constexpr unsigned kDigits[] = {0b0111111, 0b0000110, 0b1011011, 0b1001111, 0b1100110,
                                0b1101101, 0b1111101, 0b0000111, 0b1111111, 0b1101111};

std::vector<Line> lines_of(char letter) {
  const auto all = [](std::span<const Line> lines) { return std::vector<Line>(lines.begin(), lines.end()); };
  switch (letter) {
    case '+':
      return all(kPlus);
    case '-':
      return all(kMinus);
    case 'X':
      return all(kX);
    case 'Y':
      return all(kY);
    case 'Z':
      return all(kZ);
    default:
      break;
  }
  check(letter >= '0' && letter <= '9', "the stroke font has no such letter");
  std::vector<Line> lines;
  for (int i = 0; i < 7; ++i) {
    if (kDigits[letter - '0'] >> i & 1) lines.push_back(kSegments[i]);
  }
  return lines;
}

}  // namespace

SphereText::SphereText(std::string_view word, Vec3 center, Vec3 up, double height) : center_(center) {
  const Vec3 right = cross(center, up);
  const double step = height / 4;  // letters are 2 steps wide and stand 3 apart
  const double left = -step * (3 * static_cast<double>(word.size()) - 1) / 2;
  double reach = 0;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const auto place = [&](int x, int y) {
      const double h = left + step * (3 * static_cast<double>(i) + x), v = step * (y - 2);
      reach = std::max(reach, std::hypot(h, v));
      return normalize(center + h * right + v * up);
    };
    for (const Line& line : lines_of(word[i])) strokes_.push_back({place(line.x0, line.y0), place(line.x1, line.y1)});
  }
  const double half_pen = height / 16;
  cos_half_pen_ = std::cos(half_pen);
  sin_half_pen_ = std::sin(half_pen);
  cos_reach_ = std::cos(std::atan(reach) + half_pen);
}

bool SphereText::covers(Vec3 d) const {
  if (dot(d, center_) < cos_reach_) return false;
  return std::any_of(strokes_.begin(), strokes_.end(), [&](const Stroke& s) {
    if (dot(d, s.from) > cos_half_pen_ || dot(d, s.to) > cos_half_pen_) return true;  // round ends
    const Vec3 normal = normalize(cross(s.from, s.to));
    const bool beside = dot(cross(normal, s.from), d) > 0 && dot(cross(s.to, normal), d) > 0;
    return beside && std::abs(dot(d, normal)) < sin_half_pen_;
  });
}

}  // namespace zonal
