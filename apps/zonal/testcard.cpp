#include <CLI/CLI.hpp>
#include <memory>

#include "apps/zonal/layouts.h"
#include "apps/zonal/output_options.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/verbs.h"
#include "zonal/light/synthetic.h"

namespace zonal {
namespace {

constexpr int kPanoramaHeight = 512, kFaceEdge = 256;

void run_testcard(const OutputOptions& options, Call& call) {
  const Projection to = target_of(options, Layout::kEquirect);
  check_output(options, to.layout);
  const int fallback = is_cube(to.layout) ? kFaceEdge : kPanoramaHeight;
  const ImageSize size = image_size(to.layout, options.size_px > 0 ? options.size_px : fallback);
  write_map(testcard(to, size, call.run), options, "radiance", "test card", call);
}

}  // namespace

void add_testcard(CLI::App& app, Call& call) {
  auto options = std::make_shared<OutputOptions>();
  CLI::App& verb = *app.add_subcommand(
      "testcard", "Labelled axes in any projection: shows at a glance what an engine mirrors or turns.");
  add_output_options(verb, *options, "512 for panoramas, 256 for cube faces if not said");
  add_run_options(verb, call);
  verb.footer(
      "Examples:\n"
      "  zonal testcard -o card.png\n"
      "  zonal testcard --to cube -o faces/\n"
      "  zonal testcard --to cube-cross --size 128 -o cross.png");
  verb.callback([options, &call] { run_testcard(*options, call); });
}

}  // namespace zonal
