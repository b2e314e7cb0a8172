#include "zonal/sh/gaunt.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>

#include "zonal/base/check.h"
#include "zonal/sh/basis_constants.h"

namespace zonal {
namespace {

constexpr int kBands = kMaxStaticBands;
constexpr int kCoefficients = coefficient_count(kBands);
/// Gauss-Legendre nodes in z: the product of three functions is a polynomial of degree 3 (kBands-1) < 2 kNodes.
constexpr int kNodes = (3 * (kBands - 1)) / 2 + 1;

struct Lm {
  int l = 0, m = 0;
};

struct Node {
  double z = 0, weight = 0;
  /// y_{l,m} without the cosine or sine of m phi and without sin(theta)^m.
  std::array<std::array<double, kBands>, kBands> q = {};
};

/// The largest zero of P_n below the `found` ones: Newton with those divided out (Maehly 1954), from the right, where
/// it cannot overshoot. math/quadrature.h has more digits for large n, but not at compile time.
constexpr Node gauss_node(const std::array<Node, kNodes>& nodes, int found) {
  constexpr int kMaxSteps = 100;  // each step at least takes 1/n of the way, near the end it squares the error
  double z = 1, slope = 0;
  for (int step = 0; step < kMaxSteps; ++step) {
    double before = 0, now = 1;
    for (int l = 0; l < kNodes; ++l) {
      const double next = ((2 * l + 1) * z * now - l * before) / (l + 1);
      before = now;
      now = next;
    }
    if (z == 1) {
      slope = kNodes * (kNodes + 1) / 2.0;
    } else {
      slope = kNodes * (before - z * now) / (1 - z * z);
    }
    double rate = slope / now;
    for (int i = 0; i < found; ++i) rate -= 1 / (z - nodes[static_cast<std::size_t>(i)].z);
    if (now == 0) break;
    const double next = z - 1 / rate;
    if (next == z) break;
    z = next;
  }
  return {z, 2 / ((1 - z * z) * slope * slope)};
}

constexpr std::array<Node, kNodes> gauss_nodes() {
  constexpr const BasisConstants<kBands>& k = kBasisConstants<kBands>;
  std::array<Node, kNodes> nodes;
  for (std::size_t i = 0; i < kNodes; ++i) {
    Node& node = nodes[i];
    node = gauss_node(nodes, static_cast<int>(i));
    for (std::size_t m = 0; m < kBands; ++m) {
      node.q[m][m] = k.start[m];
      for (std::size_t l = m + 1; l < kBands; ++l) {
        const double before = l >= m + 2 ? node.q[l - 2][m] : 0;
        node.q[l][m] = k.slope[l][m] * node.z * node.q[l - 1][m] - k.offset[l][m] * before;
      }
    }
  }
  return nodes;
}

constexpr int magnitude(int m) { return m < 0 ? -m : m; }

/// The integral over phi of three factors cos(m phi), or sin(-m phi) for negative m; 0 unless the sines pair up and the
/// largest |m| is the sum of the others.
constexpr double phi_integral(int m1, int m2, int m3) {
  const int largest = std::max({magnitude(m1), magnitude(m2), magnitude(m3)});
  const int sum = magnitude(m1) + magnitude(m2) + magnitude(m3);
  const int sines = (m1 < 0) + (m2 < 0) + (m3 < 0);
  if (sum != 2 * largest || sines % 2 != 0) return 0;
  if (largest == 0) return 2 * std::numbers::pi;
  if (m1 == 0 || m2 == 0 || m3 == 0) return std::numbers::pi;
  // cos a cos b holds +cos(a+b)/2, sin a sin b holds -cos(a+b)/2, sin a cos b holds sin(a+b)/2.
  const bool sum_is_cosine = m1 == largest || m2 == largest || m3 == largest;
  return sines == 2 && sum_is_cosine ? -std::numbers::pi / 2 : std::numbers::pi / 2;
}

constexpr double gaunt(const std::array<Node, kNodes>& nodes, Lm a, Lm b, Lm c) {
  if ((a.l + b.l + c.l) % 2 != 0 || c.l > a.l + b.l) return 0;  // parity, triangle; c.l is the largest
  const double phi = phi_integral(a.m, b.m, c.m);
  if (phi == 0) return 0;
  const int p = magnitude(a.m), q = magnitude(b.m), r = magnitude(c.m);
  double sum = 0;
  for (const Node& node : nodes) {
    double term = node.weight * node.q[a.l][p] * node.q[b.l][q] * node.q[c.l][r];
    for (int i = 0; i < (p + q + r) / 2; ++i) term *= 1 - node.z * node.z;
    sum += term;
  }
  return phi * sum;
}

struct Candidates {
  std::array<GauntIntegral, kCoefficients*(kCoefficients + 1) * (kCoefficients + 2) / 6> entries = {};
  std::size_t count = 0;
};

constexpr Candidates every_integral() {
  const std::array<Node, kNodes> nodes = gauss_nodes();
  std::array<Lm, kCoefficients> lm;
  for (int l = 0; l < kBands; ++l) {
    for (int m = -l; m <= l; ++m) lm[static_cast<std::size_t>(coefficient_index(l, m))] = {l, m};
  }
  Candidates found;
  for (std::uint8_t k = 0; k < kCoefficients; ++k) {
    for (std::uint8_t j = 0; j <= k; ++j) {
      for (std::uint8_t i = 0; i <= j; ++i) {
        const double value = gaunt(nodes, lm[i], lm[j], lm[k]);
        // The smallest integral is 0.0096, rounding leaves 1e-15 of a zero: ten pairs pass the rules and vanish.
        if (value > 1e-9 || value < -1e-9) found.entries[found.count++] = {i, j, k, value};
      }
    }
  }
  return found;
}

constexpr std::size_t kCount = every_integral().count;

constexpr std::array<GauntIntegral, kCount> kIntegrals = [] {
  const Candidates all = every_integral();
  std::array<GauntIntegral, kCount> list = {};
  for (std::size_t i = 0; i < kCount; ++i) list[i] = all.entries[i];
  return list;
}();

/// k leads the order, so the integrals of fewer bands come first.
constexpr std::array<std::size_t, kBands + 1> kCounts = [] {
  std::array<std::size_t, kBands + 1> counts = {};
  for (int bands = 1; bands <= kBands; ++bands) {
    for (const GauntIntegral& g : kIntegrals) counts[static_cast<std::size_t>(bands)] += g.k < coefficient_count(bands);
  }
  return counts;
}();

}  // namespace

std::span<const GauntIntegral> gaunt_integrals(int bands) {
  check(1 <= bands && bands <= kBands, "Gaunt integrals are listed for 1 to 6 bands");
  return std::span(kIntegrals).first(kCounts[static_cast<std::size_t>(bands)]);
}

}  // namespace zonal
