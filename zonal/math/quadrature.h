#pragma once

#include <cstddef>
#include <vector>

namespace zonal {

/// Sum of weights[i] f(nodes[i]) stands for an integral of f. Nodes ascend.
struct Quadrature {
  std::vector<double> nodes;
  std::vector<double> weights;

  std::size_t size() const { return nodes.size(); }
};

/// Gauss-Legendre on [a, b]: exact for polynomials of degree below 2n. n >= 1; O(n^2), so thousands of nodes are fine.
Quadrature gauss_legendre(int n, double a = -1, double b = 1);

/// The same rule on each of the intervals [edges[i], edges[i + 1]] in turn, joined.
Quadrature gauss_legendre_panels(int n, const std::vector<double>& edges);

/// Fejer's first rule (Fejer 1933), for the rows of an equirectangular image: weights[j] belongs to theta = pi (j +
/// 1/2)/rows, and sum weights[j] f(theta_j) = integral of f sin(theta) over [0, pi], exactly for f a polynomial in
/// cos(theta) of degree below `rows`. All weights are positive and sum to 2. O(rows^2).
std::vector<double> fejer_weights(int rows);

}  // namespace zonal
