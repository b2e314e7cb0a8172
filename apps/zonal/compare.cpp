#include "zonal/image/compare.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <memory>

#include "apps/zonal/choices.h"
#include "apps/zonal/layouts.h"
#include "apps/zonal/output.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/verbs.h"
#include "zonal/base/error.h"
#include "zonal/image/color.h"
#include "zonal/image/tonemap.h"
#include "zonal/io/file.h"
#include "zonal/io/picture.h"
#include "zonal/report/compare_page.h"
#include "zonal/report/text.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

struct CompareOptions {
  std::filesystem::path picture, reference, difference;
  std::optional<Layout> from;
  bool flat = false;
  std::optional<double> max_error;
  std::int64_t max_pixels = LoadOptions{}.max_pixels;
};

/// Solid angles row by row, when the pictures show the sphere in a way that is known; else none.
std::vector<double> weights_for(const CompareOptions& options, ImageSize size, Console& console) {
  if (options.flat) return {};
  Projection projection;
  if (options.from) {
    projection.layout = *options.from;
  } else {
    const std::optional<Guess> guess = guess_projection(size, options.reference.filename().string());
    if (!guess) {
      console.note("all pixels count alike: nothing says how the pictures show the sphere");
      return {};
    }
    projection = guess->projection;
    console.note(
        fmt::format("pixels count by solid angle, projection {}: {}", name_of(projection.layout), guess->reason));
  }
  const Mapping mapping(projection, size);
  std::vector<double> weights;
  weights.reserve(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) weights.push_back(mapping.solid_angle(x, y));
  }
  return weights;
}

/// Linear values whose sRGB codes are those of the false colours, for files.
Image<Rgb> as_colors(const Image<float>& error, double full_scale) {
  const Image<Rgb8> shown = false_color(error, full_scale);
  Image<Rgb> colors(shown.width(), shown.height());
  for (int y = 0; y < shown.height(); ++y) {
    for (int x = 0; x < shown.width(); ++x) {
      const Rgb8 c = shown(x, y);
      colors(x, y) =
          srgb_decode(Rgb{static_cast<float>(c.r) / 255, static_cast<float>(c.g) / 255, static_cast<float>(c.b) / 255});
    }
  }
  return colors;
}

void write_difference(const CompareOptions& options, Image<Rgb> picture, Image<Rgb> reference, const Comparison& result,
                      Console& console) {
  const std::filesystem::path& path = options.difference;
  if (path.extension() == ".html") {
    const ComparePage page{options.picture.filename().string() + " against " + options.reference.filename().string(),
                           std::move(reference),
                           std::move(picture),
                           {{"relative RMS error", number(result.relative_rmse)}}};
    write_file(path, compare_page_html(page));
    console.wrote(path, std::filesystem::file_size(path), "a page with both pictures and their difference");
    return;
  }
  const Image<float> error = difference(picture, reference);
  const bool colors = path.extension() == ".png";
  Image<Rgb> shown;
  if (colors) {
    shown = as_colors(error, result.max_error > 0 ? result.max_error : 1);
  } else {
    shown = Image<Rgb>(error.width(), error.height());
    for (std::size_t i = 0; i < error.size(); ++i)
      shown.values()[i] = {error.values()[i], error.values()[i], error.values()[i]};
  }
  save_picture(shown, path);
  console.wrote(
      path, std::filesystem::file_size(path),
      colors ? fmt::format("difference in false colours, white is {:.4g}", result.max_error) : "absolute difference");
}

void answer(const Comparison& c, const RgbD& got, const RgbD& expected, Console& console) {
  console.field("pixels", c.texels);
  console.field("not_finite", c.not_finite);
  console.field("rmse", c.rmse);
  console.field("relative_rmse", c.relative_rmse);
  console.field("mean_error", c.mean_error);
  console.field("psnr_db", std::isfinite(c.psnr_db) ? JsonValue(c.psnr_db) : JsonValue());
  console.field("max_error", c.max_error);
  console.field("max_relative_error", c.max_relative_error);
  console.field("worst", JsonValue::Object{{"x", c.worst_x}, {"y", c.worst_y}});
  const auto row = [&](const char* name, const std::string& value) {
    console.answer(fmt::format("{:<14} {}", name, value));
  };
  row("pixels", fmt::format("{} compared, {} not finite", c.texels, c.not_finite));
  row("RMS error", fmt::format("{:.6g}, {:.6g} of the reference's RMS", c.rmse, c.relative_rmse));
  row("mean error", fmt::format("{:.6g}", c.mean_error));
  row("PSNR",
      std::isfinite(c.psnr_db) ? fmt::format("{:.2f} dB", c.psnr_db) : std::string("infinite, the pictures are equal"));
  row("worst pixel", fmt::format("({}, {}): {:.6g} {:.6g} {:.6g}, reference {:.6g} {:.6g} {:.6g}", c.worst_x, c.worst_y,
                                 got.r, got.g, got.b, expected.r, expected.g, expected.b));
  row("worst error", fmt::format("{:.6g}, relative {:.6g}", c.max_error, c.max_relative_error));
}

void run_compare(const CompareOptions& options, Call& call) {
  if (!options.difference.empty() && options.difference.extension() != ".html" &&
      !can_save_picture(options.difference)) {
    throw Error(ErrorKind::kUsage, options.difference.string() + ": this extension names no format that can be written",
                "use .png (false colours), .exr, .hdr, .pfm or .html");
  }
  const LoadOptions loading{.max_pixels = options.max_pixels};
  Picture picture = load_picture(options.picture, loading, call.run),
          reference = load_picture(options.reference, loading, call.run);
  const ImageSize size{reference.pixels.width(), reference.pixels.height()};
  if (picture.pixels.width() != size.width || picture.pixels.height() != size.height) {
    throw Error(ErrorKind::kInput,
                fmt::format("{} is {}, {} is {}", options.picture.string(),
                            words_of({picture.pixels.width(), picture.pixels.height()}), options.reference.string(),
                            words_of(size)),
                "bring them to one size and projection first: zonal convert");
  }
  for (const std::string& note : reference.notes) call.console.note(note);
  const Comparison result = compare(picture.pixels, reference.pixels, weights_for(options, size, call.console));
  answer(result, RgbD(picture.pixels(result.worst_x, result.worst_y)),
         RgbD(reference.pixels(result.worst_x, result.worst_y)), call.console);
  if (!options.difference.empty()) {
    write_difference(options, std::move(picture.pixels), std::move(reference.pixels), result, call.console);
  }
  if (!options.max_error) return;
  const bool differ = !(result.relative_rmse <= *options.max_error) || result.not_finite > 0 || result.texels == 0;
  call.console.field("within_max_error", !differ);
  call.console.answer(
      fmt::format("{:<14} {}", "verdict", differ ? "the pictures differ" : "the same within --max-error"));
  if (differ) call.exit_code = 1;
}

}  // namespace

void add_compare(CLI::App& app, Call& call) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App& verb =
      *app.add_subcommand("compare", "How far one picture is from another: RMS and relative error, PSNR, worst pixel.");
  verb.add_option("PICTURE", options->picture, "the picture to judge")->required();
  verb.add_option("REFERENCE", options->reference, "what it should be")->required();
  add_choice(verb, "--from", options->from, layout_or_alias, layout_names(), "how both show the sphere, if not guessed")
      ->group("Input");
  verb.add_flag("--flat", options->flat, "all pixels count alike, not by solid angle")->group("Input");
  verb.add_option("--max-pixels", options->max_pixels, "refuse larger pictures")
      ->check(CLI::PositiveNumber)
      ->group("Input");
  verb.add_option("-o,--output", options->difference,
                  "the difference: .png in false colours, .exr/.hdr/.pfm as numbers, .html a page")
      ->group("Output");
  verb.add_option("--max-error", options->max_error,
                  "exit with code 1 when the relative RMS error is above this, or a pixel is not finite")
      ->check(CLI::NonNegativeNumber)
      ->group("Output");
  add_run_options(verb, call);
  verb.footer(
      "Examples:\n"
      "  zonal compare new.exr old.exr\n"
      "  zonal compare new.exr old.exr -o difference.png\n"
      "  zonal compare new.exr old.exr --max-error 1e-3 && echo same");
  verb.callback([options, &call] { run_compare(*options, call); });
}

}  // namespace zonal
