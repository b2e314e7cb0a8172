#include <array>
#include <optional>

#include "zonal/math/vec.h"
#include "zonal/sphere/disc.h"

namespace zonal {
namespace {

/// An edge that cuts off a cap lower than this of the unit disc is taken as a tangent. The cap's area is about
/// half_chord³, 10^-18, and crossing points are known to 10^-10 or better everywhere else.
constexpr double kTangentHalfChord = 1e-6;

/// The solid angle along the rim from a point where the outline leaves the disc on to where it enters again.
double along_rim(const RadialLaw& law, DiscPoint from, DiscPoint to) {
  double turn = std::atan2(cross(from, to), dot(from, to));
  // A convex outline never goes back: a small negative turn is rounding, any other is more than half a turn.
  if (turn < -0.1 * kTangentHalfChord) turn += 2 * kPi;
  return law.rim_fan() * turn;
}

/// The part of the edge from a to b inside the unit circle; nullopt where it stays outside.
struct Chord {
  DiscPoint enter, leave;
};
std::optional<Chord> chord_of(DiscPoint a, DiscPoint b, bool a_inside, bool b_inside) {
  if (a_inside && b_inside) return Chord{a, b};
  const double edge = length(DiscPoint{b.x - a.x, b.y - a.y});
  const DiscPoint along{(b.x - a.x) / edge, (b.y - a.y) / edge};
  const double s0 = dot(a, along), s1 = dot(b, along), h = cross(a, along);
  const double half = std::sqrt(std::fmax(0, (1 - h) * (1 + h)));
  if (!a_inside && !b_inside && (half < kTangentHalfChord || s0 > 0 || s1 < 0)) return std::nullopt;
  const auto at = [&](double s) { return DiscPoint{a.x + (s - s0) * along.x, a.y + (s - s0) * along.y}; };
  return Chord{a_inside ? a : at(-half), b_inside ? b : at(half)};
}

}  // namespace

// Green's theorem on the sphere: Ω = ∮ (1 - cos θ) dφ around the rectangle's part inside the circle.
double clipped_solid_angle(const RadialLaw& law, DiscPoint low, DiscPoint high) {
  const std::array<DiscPoint, 4> corners = {low, DiscPoint{high.x, low.y}, high, DiscPoint{low.x, high.y}};
  std::array<bool, 4> inside;
  for (int i = 0; i < 4; ++i) inside[i] = dot(corners[i], corners[i]) <= 1;

  double sum = 0;
  DiscPoint first_entry, exit;  // where the outline first came in and last went out, if it did
  bool touched = false, entered = false, went_out = false;
  for (int i = 0; i < 4; ++i) {
    const int next = (i + 1) % 4;
    const auto chord = chord_of(corners[i], corners[next], inside[i], inside[next]);
    if (!chord) continue;
    touched = true;
    sum += law.fan(chord->enter, chord->leave);
    if (!inside[i]) {
      if (went_out) sum += along_rim(law, exit, chord->enter);
      if (!entered) first_entry = chord->enter;
      entered = true;
      went_out = false;
    }
    if (!inside[next]) {
      exit = chord->leave;
      went_out = true;
    }
  }
  if (entered && went_out) sum += along_rim(law, exit, first_entry);
  if (touched) return std::fmax(0, sum);
  const bool around = low.x < 0 && high.x > 0 && low.y < 0 && high.y > 0;
  return around ? 2 * kPi * law.rim_fan() : 0;
}

}  // namespace zonal
