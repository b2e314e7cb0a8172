#include "apps/zonal/conversion.h"

#include <utility>

#include "zonal/light/rearrange.h"

namespace zonal {

Environment converted(const Environment& source, const InputOptions& input, const OutputOptions& output,
                      int supersample, const Run& run) {
  Projection target = target_of(output, source.projection.layout);
  const bool same = !output.to || target == source.projection;
  if (!output.to) target = source.projection;
  check_output(output, target.layout);

  ImageSize size{source.radiance.width(), source.radiance.height()};
  if (output.size_px > 0) {
    size = image_size(target.layout, output.size_px);
  } else if (!same) {
    size = image_size(target.layout, size_as_fine(target.layout, source.projection, size));
  }
  ResampleOptions resampling = resample_options_of(input);
  resampling.supersample = supersample;
  if (supersample == 0) {
    // Texels that only move keep their values.
    if (auto moved = rearranged(source, target, size, resampling.world_from_source)) return std::move(*moved);
  }
  return resample(source, target, size, resampling, run);
}

}  // namespace zonal
