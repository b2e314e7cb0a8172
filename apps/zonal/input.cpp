#include "apps/zonal/input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/zonal/layouts.h"
#include "apps/zonal/numbers.h"
#include "zonal/light/orient.h"
#include "zonal/light/partial.h"
#include "zonal/light/rearrange.h"
#include "zonal/light/survey_words.h"
#include "zonal/report/warnings.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

ImageSize size_of(const Environment& e) { return {e.radiance.width(), e.radiance.height()}; }

/// The lens as described, the rest as it was.
Lens lens_of(const InputOptions& options, Lens lens) {
  if (options.lens) lens.model = *options.lens;
  if (options.fov_deg) lens.fov_deg = *options.fov_deg;
  if (!options.center.empty()) {
    const std::vector<double> center = numbers_in(options.center, 2, 2, "--center");
    lens.center_x_px = center[0], lens.center_y_px = center[1];
  }
  if (!options.radius.empty()) {
    const std::vector<double> radius = numbers_in(options.radius, 1, 2, "--radius");
    lens.radius_x_px = radius[0], lens.radius_y_px = radius.back();
  }
  return lens;
}

void describe_lens(const InputOptions& options, Projection& projection) {
  const Lens lens = lens_of(options, projection.lens);
  if (lens == projection.lens) return;
  if (!is_fisheye(projection.layout) && (options.lens || options.fov_deg)) {
    throw Error(ErrorKind::kUsage,
                fmt::format("--lens and --fov describe a fisheye, not {}", name_of(projection.layout)),
                "say --from fisheye or --from dual-fisheye, or leave them out");
  }
  if (!has_circle(projection.layout)) {
    throw Error(ErrorKind::kUsage,
                fmt::format("--center and --radius place a circle, which {} is not", name_of(projection.layout)),
                "say --from fisheye, dual-fisheye, mirror-ball, sphere-map or angular, or leave them out");
  }
  projection.lens = lens;
}

void check_finite(const Survey& survey, const std::filesystem::path& path) {
  const std::string words = non_finite_words(survey);
  if (words.empty()) return;
  throw Error(ErrorKind::kInput, path.string() + ": " + words, "--fix fills them with the mean of their neighbours");
}

}  // namespace

std::optional<Projection> projection_of(const InputOptions& options) {
  if (!options.from) return std::nullopt;
  Projection projection{*options.from};
  describe_lens(options, projection);
  return projection;
}

Rotation rotation_of(const InputOptions& options) {
  if (options.rotate.empty()) return {};
  std::vector<double> angles = numbers_in(options.rotate, 1, 3, "--rotate");
  angles.resize(3);
  return turned(angles[0], angles[1], angles[2]);
}

ResampleOptions resample_options_of(const InputOptions& options) {
  ResampleOptions resampling;
  resampling.world_from_source = rotation_of(options);
  if (!options.ground.empty()) {
    resampling.ground = color_in(options.ground, "--ground");
    resampling.uncovered = Uncovered::kConstant;
  }
  if (options.uncovered) resampling.uncovered = *options.uncovered;
  return resampling;
}

Input read_input(const InputOptions& options, Call& call, bool any_values) {
  EnvironmentLoadOptions loading;
  loading.picture = {options.max_pixels, options.encoding};
  loading.from = projection_of(options);
  Input input;
  input.loaded = options.paths.size() == 1 ? load_environment(options.paths[0], loading, call.run)
                                           : load_environment(options.paths, loading, call.run);
  Environment& environment = input.loaded.environment;
  if (!options.from) {
    describe_lens(options, environment.projection);
    call.console.note(
        fmt::format("projection {}: {}", name_of(environment.projection.layout), input.loaded.projection_reason));
  }
  for (const std::string& note : input.loaded.notes) call.console.note(note);

  input.file_size = size_of(environment);
  input.survey = survey(environment, call.run);
  if (options.fix) {
    input.repaired = repair(environment);
    call.console.note(fmt::format("--fix replaced {} texels that were not finite and raised {} negative ones to 0",
                                  input.repaired.non_finite, input.repaired.negative));
    if (input.repaired != Repairs{}) input.survey = survey(environment, call.run);
  } else if (!any_values) {
    check_finite(input.survey, options.paths[0]);
  }
  for (const auto& [what, detail] : warnings_of(input.survey)) call.console.warn(what + " " + detail);
  return input;
}

WholeLight whole_light(Input& input, const InputOptions& options, Call& call) {
  Environment source = std::move(input.loaded.environment);
  input.loaded.environment.projection = source.projection;  // what the record says about the input
  const ResampleOptions resampling = resample_options_of(options);
  const ImageSize size = size_of(source);
  if (!Mapping(source.projection, size).covers_sphere()) {
    const int rows = panorama_rows(source.projection, size);
    const Projection panorama = {Layout::kEquirect};
    WholeLight whole{resample(source, panorama, rows, resampling, call.run), {}, {}};
    if (resampling.uncovered == Uncovered::kBlack)
      whole.shown = resample(mask_of(source), panorama, rows, resampling, call.run);
    whole.survey = survey(whole.environment, call.run);
    return whole;
  }
  if (resampling.world_from_source == Rotation::identity()) return {std::move(source), {}, input.survey};
  // Quarter turns of cubes and yaws by whole texels change no value.
  std::optional<Environment> turned_light = rearranged(source, source.projection, size, resampling.world_from_source);
  WholeLight whole{
      turned_light ? std::move(*turned_light) : resample(source, source.projection, size, resampling, call.run),
      {},
      {}};
  whole.survey = survey(whole.environment, call.run);
  return whole;
}

int size_as_fine(Layout to, const Projection& from, ImageSize size) {
  const int rows = panorama_rows(from, size);
  return std::max(1, is_cube(to) ? rows / 2 : rows);
}

}  // namespace zonal
