#include <algorithm>
#include <cmath>
#include <string>

#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/io/engine.h"
#include "zonal/math/quadrature.h"
#include "zonal/sh/convention.h"
#include "zonal/sh/eval.h"

namespace zonal {
namespace {

/// The constants of the polynomials 1, y, z, x, xy, yz, 3z^2-1, xz, x^2-y^2 in the orthonormal basis.
std::vector<double> basis_constants() {
  const double linear = std::sqrt(3 / (4 * kPi)), mixed = std::sqrt(15 / (4 * kPi));
  return {std::sqrt(1 / (4 * kPi)), linear, linear, linear, mixed, mixed, std::sqrt(5 / (16 * kPi)), mixed, mixed / 2};
}

bool is_orthogonal(const Rotation& matrix) {
  const Rotation square = transpose(matrix) * matrix;
  double worst = 0;
  for (int i = 0; i < 3; ++i) worst = std::max(worst, length(square.rows[i] - Rotation().rows[i]));
  return worst < 1e-9;  // a matrix of floats would pass, one that scales would not
}

}  // namespace

Sh<RgbD> transformed(const Sh<RgbD>& sh, const Rotation& to_from) {
  check(is_orthogonal(to_from), "transformed: the matrix is not orthogonal");
  if (to_from == Rotation()) return sh;  // the same convention in and out changes no bit
  constexpr int kMaxBands = 32;
  const int bands = sh.bands();
  if (bands > kMaxBands) {
    throw Error(ErrorKind::kUsage, std::to_string(bands) + " bands are too many to change their axes",
                "at most " + std::to_string(kMaxBands));
  }
  // A product of two functions of `bands` bands has degree 2 bands - 2; these rows and columns integrate it exactly.
  const int rows = 2 * bands, columns = 2 * bands;
  const std::vector<double> row_weights = fejer_weights(rows);
  const Rotation from_to = transpose(to_from);
  Sh<RgbD> result(bands);
  for (int j = 0; j < rows; ++j) {
    const double theta = kPi * (j + 0.5) / rows, weight = row_weights[j] * 2 * kPi / columns;
    for (int i = 0; i < columns; ++i) {
      const double phi = 2 * kPi * i / columns;
      const Vec3 to{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
      const RgbD value = weight * evaluate(sh, from_to * to);
      visit_basis(bands, to, [&](int k, double y) { result[static_cast<std::size_t>(k)] += y * value; });
    }
  }
  return result;
}

std::vector<RgbD> engine_coefficients(const ShFile& file, const EngineConvention& engine) {
  const ShForm& form = engine.sh;
  const int bands = file.coefficients.bands();
  check(bands >= 1, "engine_coefficients: there are none");
  if (form.max_bands > 0 && bands > form.max_bands) {
    throw Error(ErrorKind::kUsage, std::string(engine.name) + " takes " + std::to_string(form.max_bands) +
                                       " bands, not " + std::to_string(bands));
  }
  Sh<RgbD> sh = transformed(to_quantity(file, form.quantity).coefficients, engine.sh_from_world());
  if (form.condon_shortley) sh = to_condon_shortley(sh);
  std::vector<RgbD> numbers(sh.values().begin(), sh.values().end());
  if (form.times_constants) {
    const std::vector<double> constants = basis_constants();
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = constants[i] * numbers[i];
  }
  if (form.order.empty()) return numbers;
  std::vector<RgbD> ordered(form.order.size());  // bands that are not there stay zero
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    const auto from = static_cast<std::size_t>(form.order[i]);
    if (from < numbers.size()) ordered[i] = numbers[from];
  }
  return ordered;
}

ShFile from_engine_coefficients(std::span<const RgbD> numbers, const EngineConvention& engine) {
  const ShForm& form = engine.sh;
  const auto count = static_cast<double>(numbers.size());
  const int bands = static_cast<int>(std::lround(std::sqrt(count)));
  const bool whole = bands >= 1 && numbers.size() == static_cast<std::size_t>(coefficient_count(bands));
  if (!whole || (form.max_bands > 0 && bands > form.max_bands) ||
      (!form.order.empty() && numbers.size() != form.order.size())) {
    throw Error(ErrorKind::kInput, std::to_string(numbers.size()) + " is not a number of coefficients that " +
                                       std::string(engine.name) + " stores");
  }
  const std::vector<double> constants = form.times_constants ? basis_constants() : std::vector<double>();
  Sh<RgbD> sh(bands);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t to = form.order.empty() ? i : static_cast<std::size_t>(form.order[i]);
    sh[to] = (constants.empty() ? 1 : 1 / constants[to]) * numbers[i];
  }
  if (form.condon_shortley) sh = from_condon_shortley(sh);
  return {form.quantity, transformed(sh, transpose(engine.sh_from_world()))};
}

}  // namespace zonal
