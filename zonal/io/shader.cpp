#include "zonal/io/shader.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/io/shader_number.h"
#include "zonal/sh/basis_constants.h"

namespace zonal {
namespace {

constexpr int kMaxBands = 6;

// sum c_lm y_lm = sum_m p_m(z) t_m(x, y), where t_m = sin^m(theta) cos(m phi) and t_-m = sin^m(theta) sin(m phi) are
// polynomials of x and y, and p_m gathers column m of the basis: y_lm = q_l|m|(z) t_m.

/// powers[k] z^k
using ColorPolynomial = std::vector<RgbD>;

/// q_lm for l = m .. bands-1: columns[l - m][k] z^k.
std::vector<std::vector<double>> basis_column(int m, int bands) {
  static constexpr BasisConstants<kMaxBands> k;
  std::vector<std::vector<double>> column;
  for (int l = m; l < bands; ++l) {
    std::vector<double> q(static_cast<std::size_t>(l - m) + 1);
    if (l == m) q[0] = k.start[m];
    for (std::size_t power = 1; l > m && power < q.size(); ++power) q[power] = k.slope[l][m] * column.back()[power - 1];
    for (std::size_t power = 0; l > m + 1 && power + 2 < q.size(); ++power) {
      q[power] -= k.offset[l][m] * column[column.size() - 2][power];
    }
    column.push_back(std::move(q));
  }
  return column;
}

ColorPolynomial column_polynomial(const Sh<RgbD>& sh, int m) {
  const int first = std::abs(m);
  ColorPolynomial p(static_cast<std::size_t>(sh.bands() - first));
  const std::vector<std::vector<double>> column = basis_column(first, sh.bands());
  for (int l = first; l < sh.bands(); ++l) {
    const std::vector<double>& q = column[static_cast<std::size_t>(l - first)];
    for (std::size_t power = 0; power < q.size(); ++power) p[power] += q[power] * sh(l, m);
  }
  return p;
}

bool is_zero(RgbD c) { return c == RgbD(); }

/// How a language spells the few things that the function is made of.
struct Dialect {
  std::string_view name, head, tail, let, vector, suffix;
};
constexpr Dialect kDialects[] = {
    {"glsl", "highp vec3 ", "(highp vec3 n)", "highp float ", "vec3", ""},
    {"hlsl", "float3 ", "(float3 n)", "float ", "float3", ""},
    {"msl", "inline float3 ", "(float3 n)", "float ", "float3", "f"},
    {"wgsl", "fn ", "(n: vec3<f32>) -> vec3<f32>", "let ", "vec3<f32>", "f"},
    {"cpp", "template <class Vec3>\nVec3 ", "(const Vec3& n)", "const float ", "Vec3", "f"},
};

class Writer {
 public:
  explicit Writer(const Dialect& dialect) : dialect_(dialect) {}

  void let(const std::string& name, const std::string& value) {
    text += fmt::format("  {}{} = {};\n", dialect_.let, name, value);
  }
  std::string number(double value) const { return shader_number(value, dialect_.suffix); }
  std::string color(RgbD c) const {
    return fmt::format("{}({}, {}, {})", dialect_.vector, number(c.r), number(c.g), number(c.b));
  }
  /// Horner's scheme; a power that is missing (odd bands of irradiance) costs no constant. "" for the zero polynomial.
  std::string horner(const ColorPolynomial& p, std::size_t from = 0) const {
    std::string factors;  // z * z * for the powers skipped
    for (std::size_t k = from; k < p.size(); ++k, factors += "z * ") {
      if (is_zero(p[k])) continue;
      const std::string rest = horner(p, k + 1);
      if (rest.empty()) return factors + color(p[k]);
      return fmt::format("{}({} + z * {})", factors, color(p[k]), rest);
    }
    return {};
  }

  std::string text;

 private:
  const Dialect& dialect_;
};

std::string function_name(ShQuantity quantity) {
  if (quantity == ShQuantity::kRadiance) return "zonal_radiance";
  return quantity == ShQuantity::kIrradiance ? "zonal_irradiance" : "zonal_irradiance_over_pi";
}

std::string comment(const ShaderOptions& options, int bands) {
  std::string meaning;
  switch (options.returns) {
    case ShQuantity::kRadiance:
      meaning = "Radiance from direction n, in the units of the picture.";
      break;
    case ShQuantity::kIrradiance:
      meaning =
          "Irradiance E on a surface with normal n: radiance of the picture times steradian.\n"
          "// A matte surface reflects albedo / pi * E.";
      break;
    case ShQuantity::kIrradianceOverPi:
      meaning =
          "Irradiance over pi on a surface with normal n, in the units of the picture's radiance.\n"
          "// A matte surface reflects albedo times this.";
      break;
  }
  return fmt::format(
      "// {}\n// n: unit vector; axes: {}.\n"
      "// {} band{} of spherical harmonics; between bright lights the sum may be slightly negative.\n",
      meaning, options.frame, bands, bands > 1 ? "s" : "");
}

}  // namespace

std::string_view name_of(ShaderLanguage language) { return kDialects[static_cast<std::size_t>(language)].name; }

std::optional<ShaderLanguage> shader_language_named(std::string_view name) {
  for (std::size_t i = 0; i < std::size(kDialects); ++i) {
    if (kDialects[i].name == name) return static_cast<ShaderLanguage>(i);
  }
  return std::nullopt;
}

std::string shader_text(const ShFile& file, const ShaderOptions& options) {
  check(options.frame.find_first_of("\n\r\\") == options.frame.npos, "shader_text: the frame is one line of a comment");
  const int bands = file.coefficients.bands();
  if (bands < 1 || bands > kMaxBands) {
    throw Error(ErrorKind::kUsage, "shader code is written for 1 to 6 bands, not " + std::to_string(bands),
                "3 bands give irradiance to 1 % on average (Ramamoorthi & Hanrahan 2001)");
  }
  const Sh<RgbD> sh = to_quantity(file, options.returns).coefficients;
  const Dialect& dialect = kDialects[static_cast<std::size_t>(options.language)];
  Writer writer(dialect);

  std::string sum;
  int highest = 0;  // the largest m that is used
  for (int m = 0; m < bands; ++m) {
    for (const int sign : {1, -1}) {
      if (m == 0 && sign < 0) continue;
      const std::string p = writer.horner(column_polynomial(sh, sign * m));
      if (p.empty()) continue;
      if (!sum.empty()) sum += "\n      + ";
      if (m == 1) sum += sign > 0 ? "x * " : "y * ";
      if (m > 1) sum += fmt::format("{}{} * ", sign > 0 ? 'c' : 's', m);
      sum += p;
      highest = m;
    }
  }
  for (const char axis : {'x', 'y', 'z'}) writer.let({axis}, std::string("n.") + axis);
  std::string cosine = "x", sine = "y";
  for (int m = 2; m <= highest; ++m) {
    const std::string c = fmt::format("c{}", m), s = fmt::format("s{}", m);
    writer.let(c, fmt::format("x * {} - y * {}", cosine, sine));
    writer.let(s, fmt::format("x * {} + y * {}", sine, cosine));
    cosine = c;
    sine = s;
  }
  if (sum.empty()) sum = writer.color({});
  return fmt::format("{}{}{}{} {{\n{}  return {};\n}}\n", comment(options, bands), dialect.head,
                     function_name(options.returns), dialect.tail, writer.text, sum);
}

}  // namespace zonal
