#include "zonal/light/rearrange.h"

#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

// Directions are right to a few roundings; texels of the largest pictures are 1e-5 apart.
constexpr double kSameDirection = 1e-10;

}  // namespace

std::optional<Environment> rearranged(const Environment& source, const Projection& to, ImageSize size,
                                      const Rotation& world_from_source) {
  const Mapping from(source.projection, {source.radiance.width(), source.radiance.height()}), target(to, size);
  const Rotation source_from_world = transpose(world_from_source);
  Environment result{Image<Rgb>(size.width, size.height), to};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const std::optional<Vec3> toward = target.texel_direction(x, y);
      if (!toward) continue;
      const Vec3 wanted = source_from_world * *toward;
      const Texel texel = from.nearest(wanted);
      const std::optional<Vec3> found = from.direction(center_of(texel));
      if (!found || length(*found - wanted) > kSameDirection) return std::nullopt;
      result.radiance(x, y) = source.radiance(texel.x, texel.y);
    }
  }
  return result;
}

}  // namespace zonal
