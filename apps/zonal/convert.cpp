#include <CLI/CLI.hpp>
#include <memory>
#include <utility>

#include "apps/zonal/input_options.h"
#include "apps/zonal/layouts.h"
#include "apps/zonal/output_options.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/verbs.h"
#include "zonal/light/rearrange.h"

namespace zonal {
namespace {

struct ConvertOptions {
  InputOptions input;
  OutputOptions output;
  int supersample = 0;
};

/// Texels that only move keep their values; the rest is resampled.
Environment converted(const Environment& source, const Projection& to, ImageSize size,
                      const ResampleOptions& resampling, const Run& run) {
  if (resampling.supersample == 0) {
    if (auto moved = rearranged(source, to, size, resampling.world_from_source)) return std::move(*moved);
  }
  return resample(source, to, size, resampling, run);
}

void run_convert(const ConvertOptions& options, Call& call) {
  if (options.output.to) check_output(options.output, *options.output.to);
  Input input = read_input(options.input, call);
  const Environment& source = input.loaded.environment;
  Projection target = target_of(options.output, source.projection.layout);
  const bool same = !options.output.to || target == source.projection;
  if (!options.output.to) target = source.projection;
  check_output(options.output, target.layout);

  ImageSize size = input.file_size;
  if (options.output.size_px > 0) {
    size = image_size(target.layout, options.output.size_px);
  } else if (!same) {
    size = image_size(target.layout, size_as_fine(target.layout, source.projection, size));
  }
  ResampleOptions resampling = resample_options_of(options.input);
  resampling.supersample = options.supersample;
  write_map(converted(source, target, size, resampling, call.run), options.output, "radiance", "environment", call);
}

}  // namespace

void add_convert(CLI::App& app, Call& call) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App& verb =
      *app.add_subcommand("convert", "The same light in another projection, size, orientation or file format.");
  add_input_options(verb, options->input);
  add_output_options(verb, options->output, "as fine as the input if not said");
  verb.add_option("--supersample", options->supersample,
                  "samples along each side of a texel; as many as its footprint needs if not said")
      ->check(CLI::Range(1, 64))
      ->group("Output");
  add_run_options(verb, call);
  verb.footer(
      "Examples:\n"
      "  zonal convert sunset.hdr --to cube-cross -o cross.exr\n"
      "  zonal convert sunset.hdr --to cube --size 512 -o faces/\n"
      "  zonal convert cross.png -o 'face_%s.hdr' --to cube\n"
      "  zonal convert sunset.hdr --rotate 90 -o turned.hdr");
  verb.callback([options, &call] { run_convert(*options, call); });
}

}  // namespace zonal
