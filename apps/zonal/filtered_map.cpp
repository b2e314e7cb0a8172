#include "apps/zonal/filtered_map.h"

#include <fmt/format.h>

#include "zonal/light/partial.h"

namespace zonal {

Convolved filtered_map(const InputOptions& options, const Lobe& lobe, const Projection& to, ImageSize size,
                       Call& call) {
  Input input = read_input(options, call);
  const WholeLight light = whole_light(input, options, call);
  Convolved result = convolve(light.environment, lobe, to, size, {}, call.run);
  if (light.shown) renormalise(result, convolve(*light.shown, lobe, to, size, {}, call.run));
  const ConvolveReport& report = result.report;
  call.console.field("bands", report.bands);
  call.console.field("points", report.points);
  if (report.widened_deg > 0) {
    call.console.note(fmt::format("the lobe is too sharp for {} bands: it was widened by {:.2g} degrees", report.bands,
                                  report.widened_deg));
  }
  call.console.field("widened_deg", report.widened_deg);
  call.console.field("bound_to_mean", report.bound_to_mean);
  call.console.field("bound_to_peak", report.bound_to_peak);
  return result;
}

ImageSize target_size(const OutputOptions& options, const Projection& to, int fallback_px) {
  return image_size(to.layout, options.size_px > 0 ? options.size_px : fallback_px);
}

}  // namespace zonal
