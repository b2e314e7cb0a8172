#include "zonal/light/ambient_reflectance.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "zonal/base/error.h"
#include "zonal/base/parallel.h"
#include "zonal/math/quadrature.h"

namespace zonal {
namespace {

constexpr int kFineNodes = 10, kCoarseNodes = 7;
constexpr std::size_t kMostCells = 13400;  // of 149 values each: two million

/// The two rules on [0, 1], shared by all entries of a table.
struct Rules {
  Quadrature fine = gauss_legendre(kFineNodes, 0, 1), coarse = gauss_legendre(kCoarseNodes, 0, 1);
};

/// Where light comes from: psi from the mirror direction r, chi = t chi_max(psi) around it from the side of the normal,
/// t in [-1, 1]. kWhole: circles above the horizon, a = psi in [0, pi/2 - theta_v]. kCut: those that the horizon cuts,
/// psi = middle - half cos(a) with a in [0, pi], as chi_max leaves both ends of the range like a square root. And t =
/// w^2 (3 - 2w) of w = |u|: dense where something may change fast, at the horizon and in the plane of v and n.
enum class Circles { kWhole, kCut };

struct Cell {
  Circles circles;
  double a, u, width_a, width_u;
  RgbD value = {};
  double error = 0;
};

class Hemisphere {
 public:
  Hemisphere(const Rules& rules, const Brdf& brdf, double n_dot_v)
      : rules_(rules), brdf_(brdf), cosine_(n_dot_v), sine_(std::sqrt((1 - n_dot_v) * (1 + n_dot_v))) {}

  /// The angle from the mirror direction to the horizon.
  double whole() const { return std::asin(cosine_); }

  /// The integrals of both rules, their difference as error.
  Cell measured(Cell cell) const {
    cell.value = sum(rules_.fine, cell);
    const RgbD difference = cell.value - sum(rules_.coarse, cell);
    cell.error = std::max({std::abs(difference.r), std::abs(difference.g), std::abs(difference.b)});
    return cell;
  }

 private:
  RgbD sum(const Quadrature& rule, const Cell& cell) const {
    RgbD total;
    for (std::size_t i = 0; i < rule.size(); ++i) {
      const double a = cell.a + rule.nodes[i] * cell.width_a, half = std::acos(cosine_);
      const bool cut = cell.circles == Circles::kCut;
      const double psi = cut ? kPi / 2 - half * std::cos(a) : a;
      const double stretch = cut ? half * std::sin(a) : 1;
      const double cos_psi = std::cos(psi), sin_psi = std::sin(psi);
      const double chi_max = cut ? std::acos(std::clamp(-cosine_ * cos_psi / (sine_ * sin_psi), -1.0, 1.0)) : kPi;
      RgbD circle;
      for (std::size_t k = 0; k < rule.size(); ++k) {
        const double u = cell.u + rule.nodes[k] * cell.width_u, w = std::abs(u);
        const double chi = chi_max * std::copysign(w * w * (3 - 2 * w), u);
        circle += rule.weights[k] * 6 * w * (1 - w) * reflected(cos_psi, sin_psi, chi);
      }
      total += (rule.weights[i] * stretch * sin_psi * chi_max) * circle;
    }
    return (cell.width_a * cell.width_u) * total;
  }

  /// f n.l at one direction of light.
  RgbD reflected(double cos_psi, double sin_psi, double chi) const {
    const double towards_normal = sin_psi * std::cos(chi);
    // Rounding may take light from the horizon's edge below it.
    const double n_dot_l = std::max(1e-300, cosine_ * cos_psi + sine_ * towards_normal);
    const Vec3 l = {cosine_ * towards_normal - sine_ * cos_psi, sin_psi * std::sin(chi), n_dot_l};
    const RgbD f = brdf_(l, {sine_, 0, cosine_});
    if (!std::isfinite(f.r) || !std::isfinite(f.g) || !std::isfinite(f.b)) {
      throw Error(ErrorKind::kInput,
                  "the BRDF is not finite at n.v = " + std::to_string(cosine_) + ", n.l = " + std::to_string(n_dot_l));
    }
    return n_dot_l * f;
  }

  const Rules& rules_;
  const Brdf& brdf_;
  double cosine_, sine_;
};

struct Interval {
  double from, to;
};

/// Intervals between `edge` and `end`, on either side of it, that halve towards the edge until they are no wider than
/// `finest`.
void add_graded(std::vector<Interval>& intervals, double edge, double end, double finest) {
  for (double far = std::abs(end - edge), near = 0; far > 0; far = near) {
    near = far > finest ? far / 2 : 0;
    intervals.push_back(end > edge ? Interval{edge + near, edge + far} : Interval{edge - far, edge - near});
  }
}

/// Where to begin. Around the mirror direction and at the horizon anything may be small. Where v grazes, a lobe of half
/// vectors is a needle in the plane of v and n, as thin as n.v, and chi_max changes as fast at both ends of its range.
std::vector<Cell> first_cells(double whole, double n_dot_v) {
  std::vector<Interval> whole_a, cut_a, around;
  add_graded(whole_a, 0, whole / 2, 1e-5);
  add_graded(whole_a, whole, whole / 2, 1e-4);
  if (whole < kPi / 2) {
    add_graded(cut_a, 0, kPi / 2, 1e-3);  // psi grows with the square of the distance, as t does with that of u
    add_graded(cut_a, kPi, kPi / 2, 1e-3);
  }
  const double finest = std::max(1e-3, std::sqrt(n_dot_v));
  for (const double side : {-1.0, 1.0}) {
    add_graded(around, 0, side / 2, finest);
    add_graded(around, side, side / 2, finest);
  }
  std::vector<Cell> cells;
  for (const auto& [u, u_end] : around) {
    for (const auto& [a, end] : whole_a) cells.push_back({Circles::kWhole, a, u, end - a, u_end - u});
    for (const auto& [a, end] : cut_a) cells.push_back({Circles::kCut, a, u, end - a, u_end - u});
  }
  return cells;
}

Reflectance reflectance(const Rules& rules, const Brdf& brdf, double n_dot_v, double tolerance) {
  const Hemisphere hemisphere(rules, brdf, n_dot_v);
  std::vector<Cell> cells = first_cells(hemisphere.whole(), n_dot_v);
  double error = 0;
  for (Cell& cell : cells) {
    cell = hemisphere.measured(cell);
    error += cell.error;
  }
  std::ranges::make_heap(cells, {}, &Cell::error);
  while (error > tolerance && cells.size() < kMostCells) {
    std::ranges::pop_heap(cells, {}, &Cell::error);
    const Cell worst = cells.back();
    cells.pop_back();
    error -= worst.error;
    const double width_a = worst.width_a / 2, width_u = worst.width_u / 2;
    for (int quarter = 0; quarter < 4; ++quarter) {
      const double a = worst.a + (quarter % 2) * width_a, u = worst.u + (quarter / 2) * width_u;
      cells.push_back(hemisphere.measured({worst.circles, a, u, width_a, width_u}));
      error += cells.back().error;
      std::ranges::push_heap(cells, {}, &Cell::error);
    }
  }
  // Afresh: the running sum carries the roundings of all that was taken back. 1e-14: those of the sum itself.
  Reflectance result{{}, 1e-14};
  for (const Cell& cell : cells) {
    result.value += cell.value;
    result.error += cell.error;
  }
  return result;
}

void check_tolerance(double tolerance) {
  if (!(tolerance >= 1e-12 && tolerance <= 1)) {
    throw Error(ErrorKind::kUsage, "the tolerance of the reflectance is out of its range", "1e-12 to 1; 1e-6 is usual");
  }
}

}  // namespace

Reflectance ambient_reflectance(const Brdf& brdf, double n_dot_v, double tolerance) {
  if (!(n_dot_v > 0 && n_dot_v <= 1)) {
    throw Error(ErrorKind::kUsage, "n.v is out of its range: " + std::to_string(n_dot_v), "it lies in (0, 1]");
  }
  check_tolerance(tolerance);
  return reflectance(Rules(), brdf, n_dot_v, tolerance);
}

ReflectanceTable ambient_reflectance_table(const Brdf& brdf, int size, double tolerance, const Run& run) {
  if (size < 1 || size > 4096) {
    throw Error(ErrorKind::kUsage, "the size of the reflectance table is out of range: " + std::to_string(size),
                "give a size from 1 to 4096");
  }
  check_tolerance(tolerance);
  const Rules rules;
  std::vector<Reflectance> entries(static_cast<std::size_t>(size));
  for_each_block(run, "reflectance", size, 1, [&](Block entry) {
    entries[static_cast<std::size_t>(entry.begin)] = reflectance(rules, brdf, (entry.begin + 0.5) / size, tolerance);
  });
  ReflectanceTable table;
  for (const Reflectance& entry : entries) {
    table.values.push_back(entry.value);
    table.error = std::max(table.error, entry.error);
  }
  return table;
}

}  // namespace zonal
