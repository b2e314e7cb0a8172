#include "zonal/math/quadrature.h"

#include <cmath>

#include "zonal/base/check.h"
#include "zonal/math/legendre.h"
#include "zonal/math/vec.h"

namespace zonal {
namespace {

struct Node {
  double theta, weight;
};

/// The i-th zero of P_n(cos theta) from theta = 0, by Newton's method in theta, where the zeros are evenly spaced. `p`
/// holds n + 1.
Node gauss_node(int n, int i, std::vector<double>& p) {
  constexpr int kMaxSteps = 10;                 // three are enough from this start; the rest is a guard
  double theta = kPi * (i + 0.75) / (n + 0.5);  // Tricomi 1950
  double slope = 0;                             // sin(theta)^2 P_n'
  for (int step = 0; step < kMaxSteps; ++step) {
    const double half_sine = std::sin(theta / 2);
    legendre_from_versine(2 * half_sine * half_sine, p);
    slope = n * (p[n - 1] - std::cos(theta) * p[n]);
    const double move = p[n] * std::sin(theta) / slope;
    theta += move;
    if (std::abs(move) < 1e-15) break;  // below the spacing of doubles around 1
  }
  const double sine = std::sin(theta);
  return {theta, 2 * sine * sine / (slope * slope)};
}

}  // namespace

Quadrature gauss_legendre(int n, double a, double b) {
  check(n >= 1, "a quadrature needs a node");
  Quadrature rule{std::vector<double>(n), std::vector<double>(n)};
  std::vector<double> p(static_cast<std::size_t>(n) + 1);
  const double half = (b - a) / 2;
  for (int i = 0; i < (n + 1) / 2; ++i) {
    const Node node = gauss_node(n, i, p);
    // From the nearer end: b - 2 half sin^2(theta/2) keeps the digits of the distance to the end.
    const double inset = 2 * half * std::sin(node.theta / 2) * std::sin(node.theta / 2);
    const bool middle = 2 * i + 1 == n;
    rule.nodes[n - 1 - i] = middle ? a + half : b - inset;
    rule.nodes[i] = middle ? a + half : a + inset;
    rule.weights[i] = rule.weights[n - 1 - i] = half * node.weight;
  }
  return rule;
}

Quadrature gauss_legendre_panels(int n, const std::vector<double>& edges) {
  check(edges.size() >= 2, "panels lie between edges");
  const Quadrature unit = gauss_legendre(n);
  Quadrature joined;
  for (std::size_t panel = 0; panel + 1 < edges.size(); ++panel) {
    const double middle = (edges[panel + 1] + edges[panel]) / 2, half = (edges[panel + 1] - edges[panel]) / 2;
    for (std::size_t i = 0; i < unit.size(); ++i) {
      joined.nodes.push_back(middle + half * unit.nodes[i]);
      joined.weights.push_back(half * unit.weights[i]);
    }
  }
  return joined;
}

std::vector<double> fejer_weights(int rows) {
  check(rows >= 1, "a quadrature needs a node");
  // w_j = (2/n) (1 - 2 sum_{k=1}^{n/2} cos(2 k theta_j)/(4k^2-1)); every cosine is that of a multiple of pi/n.
  const int turn = 2 * rows;
  std::vector<double> cosines(turn), scales(rows / 2 + 1), weights(rows);
  for (int i = 0; i < turn; ++i) cosines[i] = std::cos(kPi * i / rows);
  for (int k = 1; k <= rows / 2; ++k) scales[k] = 1 / (4.0 * k * k - 1);
  for (int j = 0; j < (rows + 1) / 2; ++j) {
    const int step = 2 * j + 1;
    int angle = static_cast<int>(static_cast<long long>(rows / 2) * step % turn);
    double sum = 0;
    for (int k = rows / 2; k >= 1; --k) {  // the small terms first
      sum += cosines[angle] * scales[k];
      angle -= angle >= step ? step : step - turn;
    }
    weights[j] = weights[rows - 1 - j] = 2.0 / rows * (1 - 2 * sum);
  }
  return weights;
}

}  // namespace zonal
