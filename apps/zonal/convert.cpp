#include <CLI/CLI.hpp>
#include <memory>

#include "apps/zonal/conversion.h"
#include "apps/zonal/input_options.h"
#include "apps/zonal/output_options.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/verbs.h"

namespace zonal {
namespace {

struct ConvertOptions {
  InputOptions input;
  OutputOptions output;
  int supersample = 0;
};

void run_convert(const ConvertOptions& options, Call& call) {
  if (options.output.to) check_output(options.output, *options.output.to);
  Input input = read_input(options.input, call);
  const Environment& source = input.loaded.environment;
  write_map(converted(source, options.input, options.output, options.supersample, call.run), options.output, "radiance",
            "environment", call);
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
      "  zonal convert sunset.hdr --rotate 90 -o turned.hdr\n"
      "  zonal convert room.jpg --from mirror-ball --center 764,482 --radius 268 --to equirect -o room.exr");
  verb.callback([options, &call] { run_convert(*options, call); });
}

}  // namespace zonal
