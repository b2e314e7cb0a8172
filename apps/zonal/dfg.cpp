#include "zonal/light/dfg.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "apps/zonal/choices.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/verbs.h"
#include "zonal/base/error.h"
#include "zonal/io/ktx2.h"
#include "zonal/io/picture.h"

namespace zonal {
namespace {

struct DfgOptions {
  std::filesystem::path path;
  int size_px = 128;
  DfgVariant variant = DfgVariant::kStandard;
  bool float32 = false;
};

std::optional<DfgVariant> variant_named(std::string_view name) {
  if (name == "standard") return DfgVariant::kStandard;
  if (name == "multiscatter") return DfgVariant::kMultiscatter;
  return std::nullopt;
}

void run_dfg(const DfgOptions& options, Call& call) {
  const bool ktx2 = options.path.extension() == ".ktx2";
  if (!ktx2 && !can_save_picture(options.path)) {
    throw Error(ErrorKind::kUsage, options.path.string() + ": this extension names no format that can be written",
                "use .exr, .hdr, .pfm, .png or .ktx2");
  }
  const Image<Rgb> table = dfg_table(options.size_px, options.variant, call.run);
  if (ktx2) {
    Ktx2Options encoding{.format = options.float32 ? TexelFormat::kRgba32f : TexelFormat::kRgba16f, .writer = kProgram};
    save_ktx2(options.path, {TextureShape::kPicture, {table}}, encoding);
  } else {
    const SaveReport report = save_picture(table, options.path, {.png_bits = 16, .png_linear = true});
    if (report.clipped_pixels > 0) {
      call.console.warn(
          fmt::format("{}: {} texels are above 1 (a smooth sheen at grazing angles) and were clipped; EXR keeps them",
                      options.path.string(), report.clipped_pixels));
    }
  }
  const bool standard = options.variant == DfgVariant::kStandard;
  const char* channels = standard ? "scale, bias, Charlie" : "bias, scale + bias, Charlie";
  call.console.field("size", options.size_px);
  call.console.field("channels", channels);
  call.console.wrote(options.path, std::filesystem::file_size(options.path),
                     fmt::format("split-sum table {}x{}: {}", options.size_px, options.size_px, channels));
}

}  // namespace

void add_dfg(CLI::App& app, Call& call) {
  auto options = std::make_shared<DfgOptions>();
  CLI::App& verb = *app.add_subcommand("dfg", "The split-sum table of GGX, with Charlie's sheen in blue.");
  verb.add_option("-o,--output", options->path, "OUT.exr, .pfm, .ktx2, .png (16 bits, linear) or .hdr")
      ->required()
      ->group("Output");
  verb.add_option("--size", options->size_px, "side of the table")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024))
      ->group("Output");
  add_choice(verb, "--variant", options->variant, variant_named, "standard or multiscatter",
             "(scale, bias), or (bias, scale + bias) for energy compensation")
      ->group("Output");
  verb.add_flag("--float32", options->float32, "KTX2: 32 bit floats in place of 16")->group("Output");
  add_run_options(verb, call);
  verb.footer(
      "n.v rises from left to right, perceptual roughness from top to bottom.\n\n"
      "Examples:\n"
      "  zonal dfg -o dfg.ktx2\n"
      "  zonal dfg --variant multiscatter --size 64 -o dfg.exr");
  verb.callback([options, &call] { run_dfg(*options, call); });
}

}  // namespace zonal
