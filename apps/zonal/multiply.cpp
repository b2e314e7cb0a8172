#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "apps/zonal/coefficients.h"
#include "apps/zonal/numbers.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/verbs.h"
#include "zonal/base/error.h"
#include "zonal/light/model_argument.h"
#include "zonal/sh/half_space.h"
#include "zonal/sh/product.h"

namespace zonal {
namespace {

struct MultiplyOptions {
  std::filesystem::path light, factor, path;
  std::optional<int> bands;
  std::string half_space, cosine;  // "X,Y,Z", the axis
};

ShFile radiance_in(const std::filesystem::path& path) {
  ShFile sh = read_sh_file(path);
  if (sh.quantity == ShQuantity::kRadiance) return sh;
  throw Error(ErrorKind::kInput,
              fmt::format("{} holds {}, which has gathered light from all sides", path.string(), name_of(sh.quantity)),
              "what hides or colours the light has to act on it before: multiply the radiance, then zonal sh "
              "--quantity irradiance");
}

/// A visibility or transfer lies in [0, 1], so its mean does too.
bool may_be_factor(const Sh<RgbD>& sh) {
  const double scale = 1 / std::sqrt(4 * kPi);
  constexpr double kRounding = 1e-6;  // of coefficients that were floats once
  for (const double mean : {scale * sh[0].r, scale * sh[0].g, scale * sh[0].b}) {
    if (!(mean >= -kRounding && mean <= 1 + kRounding)) return false;
  }
  return true;
}

Vec3 axis_in(const std::string& text, const char* option) {
  const std::vector<double> v = numbers_in(text, 3, 3, option);
  return direction_of({v[0], v[1], v[2]}, option);
}

Sh<RgbD> times_file(const Sh<RgbD>& light, const MultiplyOptions& options, Call& call) {
  const Sh<RgbD> factor = radiance_in(options.factor).coefficients;
  const int full = light.bands() + factor.bands() - 1,
            bands = options.bands.value_or(std::max(light.bands(), factor.bands()));
  if (!may_be_factor(light) && !may_be_factor(factor)) {
    call.console.warn(
        "Neither mean lies between 0 and 1, as that of a visibility or transfer does: radiance times radiance is no "
        "light.");
  }
  if (bands < full) call.console.note(fmt::format("the product has {} bands, of which {} are kept", full, bands));
  if (bands > full) call.console.note(fmt::format("the product has {} bands: those from there on are zero", full));
  return product_to(light, factor, bands);
}

/// By a function of infinitely many bands; the bands of the result are exact.
Sh<RgbD> times_axial(const Sh<RgbD>& light, const MultiplyOptions& options) {
  const bool half = !options.half_space.empty();
  const Vec3 axis = half ? axis_in(options.half_space, "--half-space") : axis_in(options.cosine, "--cosine");
  const int bands = options.bands.value_or(light.bands());
  constexpr int kMaxBands = 256;  // O(bands^3), and a turn there and back
  if (std::max(bands, light.bands()) > kMaxBands) {
    throw Error(ErrorKind::kUsage,
                fmt::format("products with --half-space and --cosine have {} bands at most", kMaxBands),
                "leave out bands with zonal sh --bands first");
  }
  const Sh<RgbD> wide = with_bands(light, std::max(bands, light.bands()));
  return with_bands(half ? multiply_by_half_space(wide, axis) : multiply_by_clamped_cosine(wide, axis), bands);
}

void run_multiply(const MultiplyOptions& options, Call& call) {
  const int factors = !options.factor.empty() + !options.half_space.empty() + !options.cosine.empty();
  if (factors != 1) {
    throw Error(ErrorKind::kUsage, "multiply takes a light and one factor: a second file, --half-space or --cosine",
                "as in zonal multiply sky.json visibility.json");
  }
  if (options.light == "-" && options.factor == "-") {
    throw Error(ErrorKind::kUsage, "only one of the two can come from standard input", "name a file for the other");
  }
  const Sh<RgbD> light = radiance_in(options.light).coefficients;
  const Sh<RgbD> result = options.factor.empty() ? times_axial(light, options) : times_file(light, options, call);
  write_coefficients({ShQuantity::kRadiance, result}, options.path, call);
}

}  // namespace

void add_multiply(CLI::App& app, Call& call) {
  auto options = std::make_shared<MultiplyOptions>();
  CLI::App& verb = *app.add_subcommand(
      "multiply", "Light times visibility, or any two functions on the sphere: the exact product, by channel.");
  verb.add_option("LIGHT", options->light, "coefficients of radiance, - for standard input")->required();
  verb.add_option("FACTOR", options->factor, "coefficients of a visibility or transfer, - for standard input");
  constexpr const char* kGroup = "Product";
  verb.add_option("--bands", options->bands,
                  "of the result: those of the input that has more if not said. All of a product of A and B bands are "
                  "A + B - 1")
      ->check(CLI::Range(1, 1024))
      ->group(kGroup);
  verb.add_option("--half-space", options->half_space,
                  "in place of FACTOR, with all its infinitely many bands: 1 in the half of the axis X,Y,Z, 0 in the "
                  "other")
      ->group(kGroup);
  verb.add_option("--cosine", options->cosine,
                  "likewise: the cosine of the angle to X,Y,Z, 0 where that is negative, as light falls on a surface")
      ->group(kGroup);
  add_text_output(verb, options->path);
  add_run_options(verb, call);
  verb.footer(
      "Both inputs are functions of the direction that light comes from, stored as radiance. The product is radiance "
      "when one of them is read as a number without unit: how much of the light gets through, 0 to 1 (zonal light "
      "draws such masks with a radiance of 1). Irradiance is refused: it has gathered light from all sides, so it is "
      "too late to hide some.\n\n"
      "Examples:\n"
      "  zonal light cone --elevation 60 --half-angle 30 --bands 6 -o hole.json\n"
      "  zonal multiply sky.json hole.json -o through.json\n"
      "  zonal multiply sky.json --half-space 0,0,1 | zonal sh - --quantity irradiance\n"
      "  zonal multiply a.json b.json --bands 11 -o all.json");
  verb.callback([options, &call] { run_multiply(*options, call); });
}

}  // namespace zonal
