#include "apps/zonal/merge_view.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <utility>

#include "apps/zonal/conversion.h"
#include "apps/zonal/input_options.h"
#include "apps/zonal/output_options.h"
#include "zonal/base/error.h"
#include "zonal/io/picture.h"
#include "zonal/io/picture_writer.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

/// The first option that needs a projection; empty: none was given.
std::string needs_projection(const MergeView& view) {
  const InputOptions& in = view.photographs;
  const OutputOptions& out = view.output;
  const std::pair<bool, const char*> given[] = {
      {out.to.has_value(), "--to"},        {out.size_px > 0, "--size"},
      {out.lens.has_value(), "--to-lens"}, {out.fov_deg.has_value(), "--to-fov"},
      {in.lens.has_value(), "--lens"},     {in.fov_deg.has_value(), "--fov"},
      {!in.center.empty(), "--center"},    {!in.radius.empty(), "--radius"},
      {!in.rotate.empty(), "--rotate"},    {in.uncovered.has_value(), "--uncovered"},
      {!in.ground.empty(), "--ground"},    {out.path.extension() == ".ktx2", "a KTX2 file"},
  };
  for (const auto& [is_given, name] : given) {
    if (is_given) return name;
  }
  return {};
}

/// What is written where no projection is asked for: the photographs' own, a placed circle alone.
OutputOptions with_default_projection(OutputOptions output, const Projection& from) {
  if (output.to) return output;
  if (has_circle(from.layout)) output.to = from.layout;
  if (is_fisheye(from.layout)) {
    output.lens = output.lens.value_or(from.lens.model);
    output.fov_deg = output.fov_deg.value_or(from.lens.fov_deg);
  }
  return output;
}

}  // namespace

void add_merge_view_options(CLI::App& verb, MergeView& view) {
  add_projection_options(verb, view.photographs);
  add_filling_options(verb, view.photographs);
  add_output_options(verb, view.output, "as fine as the photographs if not said");
  verb.get_option("--from")->description("how the photographs show the sphere; if not said, the merge is a picture");
  verb.get_option("--to")->description(
      "how the merge shows the sphere; if not said, as the photographs do, cut to their circle");
}

void check_merge_view(const MergeView& view) {
  const std::optional<Projection> from = projection_of(view.photographs);
  if (from) {
    resample_options_of(view.photographs);
    const OutputOptions output = with_default_projection(view.output, *from);
    check_output(output, output.to.value_or(from->layout));
    return;
  }
  const std::string needing = needs_projection(view);
  if (!needing.empty()) {
    throw Error(ErrorKind::kUsage, needing + " needs to know how the photographs show the sphere",
                "say --from fisheye, mirror-ball, equirect, ...");
  }
  require_picture_writer(view.output.path);
}

void check_merge_view(const MergeView& view, ImageSize size) {
  if (const std::optional<Projection> from = projection_of(view.photographs)) const Mapping checked(*from, size);
}

void write_merge_view(Image<Rgb> radiance, const MergeView& view, Call& call) {
  const OutputOptions& output = view.output;
  if (const std::optional<Projection> from = projection_of(view.photographs)) {
    const Environment source{std::move(radiance), *from};
    const OutputOptions to = with_default_projection(output, *from);
    write_map(converted(source, view.photographs, to, 0, call.run), to, "radiance", "radiance", call);
    return;
  }
  const SaveReport saved =
      save_picture(radiance, output.path, {.png_bits = output.png16 ? 16 : 8, .exr_half = output.half});
  if (saved.clipped_pixels > 0) {
    call.console.warn(fmt::format("{}: {} pixels are outside what the format holds and were clipped; EXR keeps them",
                                  output.path.string(), saved.clipped_pixels));
  }
  call.console.wrote(output.path, std::filesystem::file_size(output.path),
                     "radiance " + words_of({radiance.width(), radiance.height()}));
}

}  // namespace zonal
