#include "zonal/io/shader_program.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/io/json_text.h"
#include "zonal/io/shader_number.h"
#include "zonal/io/shader_program_skeletons.h"

namespace zonal {
namespace {

constexpr std::string_view kOrder[] = {"c00", "c1-1", "c10", "c11", "c2-2", "c2-1", "c20", "c21", "c22"};
constexpr int kBands = 3;

using Words = std::vector<std::pair<std::string_view, std::string>>;

/// The skeleton with each $word replaced; what replaces one may hold others that come later in the list.
std::string filled(std::string_view skeleton, const Words& words) {
  std::string text(skeleton);
  for (const auto& [word, value] : words) {
    for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + value.size())) {
      text.replace(at, word.size(), value);
    }
  }
  check(text.find('$') == text.npos, "shader_program: a $word was left over");
  return text;
}

std::string about(const ShaderProgramOptions& options) {
  return fmt::format(
      "// A matte surface in the light of sh: I_diff = (kdiff E) fscale, kdiff = albedo / pi. E(n) is the irradiance "
      "in the\n"
      "// form of Ramamoorthi & Hanrahan 2001 (k1 .. k5 there); between bright lights it may be slightly negative.\n"
      "// sh: coefficients of the radiance, real basis without the Condon-Shortley sign, in the order\n"
      "// {}.\n"
      "// Axes of sh, into which mg turns the normals: {}.",
      fmt::join(kOrder, ", "), options.frame);
}

/// Ramamoorthi & Hanrahan 2001, eq. 12: band factors of the cosine times constants of the basis. Computed, as the
/// printed digits of k3 are off in the sixth (docs/errata.md).
std::array<double, 5> irradiance_constants() {
  return {std::sqrt(15 * kPi) / 16, std::sqrt(3 * kPi) / 6, 3 * std::sqrt(5 * kPi) / 16, std::sqrt(kPi) / 2,
          std::sqrt(5 * kPi) / 16};
}

std::string uniform_c(const Sh<RgbD>& sh, int floats_apart) {
  std::string text = fmt::format("const float sh[9][{}] = {{\n", floats_apart);
  for (std::size_t i = 0; i < sh.size(); ++i) {
    const auto number = [](double value) { return shader_number(value, "f"); };
    text += fmt::format("    {{{}, {}, {}{}}},  // {}\n", number(sh[i].r), number(sh[i].g), number(sh[i].b),
                        floats_apart == 4 ? ", 0.0f" : "", kOrder[i]);
  }
  return text + "};\n";
}

std::string uniform_json(const Sh<RgbD>& sh, const std::string& frame) {
  JsonValue::Array order, colors;
  for (const std::string_view name : kOrder) order.emplace_back(name);
  for (const RgbD c : sh.values()) {
    const Rgb stored(c);
    colors.emplace_back(JsonValue::Array{stored.r, stored.g, stored.b});
  }
  return json_text(JsonValue::Object{{"uniform", "sh"},
                                     {"quantity", name_of(ShQuantity::kRadiance)},
                                     {"basis", "real"},
                                     {"condon_shortley", false},
                                     {"frame", frame},
                                     {"order", std::move(order)},
                                     {"values", std::move(colors)}});
}

void check_share(const char* what, double value) {
  if (!(value >= 0 && value <= std::numeric_limits<float>::max())) {
    throw Error(ErrorKind::kUsage, fmt::format("{} of a shader program is a number from 0 on, not {}", what, value));
  }
}

}  // namespace

ShaderProgram shader_program(const ShFile& file, const ShaderProgramOptions& options) {
  check(options.frame.find_first_of("\n\r\\$") == options.frame.npos,
        "shader_program: the frame is one line of a comment");
  if (file.coefficients.bands() < 1) throw Error(ErrorKind::kUsage, "a shader program needs coefficients");
  for (const double albedo : {options.albedo.r, options.albedo.g, options.albedo.b}) check_share("the albedo", albedo);
  check_share("the scale", options.scale);
  // First the bands, then the quantity: radiance can be had from three bands of irradiance, not from more.
  const ShFile three{file.quantity, with_bands(file.coefficients, kBands)};
  const Sh<RgbD> sh = to_quantity(three, ShQuantity::kRadiance).coefficients;

  const ProgramSkeleton& skeleton = program_skeleton(options.language);
  const auto number = [&](double value) { return shader_number(value, skeleton.suffix); };
  const bool at_vertex = options.stage == ShadingStage::kVertex;
  // HLSL, MSL and WGSL hand a struct v to the second stage.
  const bool plain = options.language == ShaderLanguage::kGlsl || options.language == ShaderLanguage::kCpp;
  const std::string varying = at_vertex ? "idiff" : "normal", received = (plain ? "" : "v.") + varying;
  const auto reflected = [&](std::string_view normal) {
    return fmt::format("zonal_reflected({}{})", normal, skeleton.sh_argument);
  };
  const RgbD k_diff = (1 / kPi) * options.albedo;
  const auto [k1, k2, k3, k4, k5] = irradiance_constants();
  const Words words = {{"$about", about(options)},
                       {"$shade_vertex", at_vertex ? std::string(skeleton.shade) : ""},
                       {"$shade_fragment", at_vertex ? "" : std::string(skeleton.shade)},
                       {"$sh_vertex", at_vertex ? std::string(skeleton.sh_parameter) : ""},
                       {"$sh_fragment", at_vertex ? "" : std::string(skeleton.sh_parameter)},
                       {"$to_varying", at_vertex ? reflected(skeleton.normal) : std::string(skeleton.normal)},
                       {"$from_varying", at_vertex ? received : reflected(received)},
                       {"$varying", varying},
                       {"$kdiff", fmt::format("{}, {}, {}", number(k_diff.r), number(k_diff.g), number(k_diff.b))},
                       {"$fscale", number(options.scale)},
                       {"$k1", number(k1)},
                       {"$k2", number(k2)},
                       {"$k3", number(k3)},
                       {"$k4", number(k4)},
                       {"$k5", number(k5)}};
  return {filled(skeleton.vertex, words), filled(skeleton.fragment, words), uniform_c(sh, skeleton.floats_apart),
          uniform_json(sh, options.frame)};
}

}  // namespace zonal
