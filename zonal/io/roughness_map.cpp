#include "zonal/io/roughness_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "zonal/base/check.h"

namespace zonal {
namespace {

constexpr std::array kMaps = {RoughnessMap::kLinear, RoughnessMap::kFilament, RoughnessMap::kUnity,
                              RoughnessMap::kUnreal, RoughnessMap::kBabylon};
constexpr std::array<std::string_view, kMaps.size()> kNames = {"linear", "filament", "unity", "unreal", "babylon"};
constexpr double kSmoothest = 0.001;  // Unreal's floor under the logarithm; only keeps it finite

}  // namespace

std::string_view name_of(RoughnessMap map) { return kNames[static_cast<std::size_t>(map)]; }
std::span<const RoughnessMap> all_roughness_maps() { return kMaps; }
std::optional<RoughnessMap> roughness_map_named(std::string_view name) {
  for (const RoughnessMap map : kMaps) {
    if (name_of(map) == name) return map;
  }
  return std::nullopt;
}

double level_of_roughness(RoughnessMap map, double roughness, int levels) {
  check(levels >= 1 && roughness >= 0 && roughness <= 1, "level_of_roughness: levels >= 1, roughness in [0, 1]");
  const double last = levels - 1, r = roughness;
  const auto level = [&] {
    switch (map) {
      case RoughnessMap::kLinear:
        return last * r;
      case RoughnessMap::kFilament:
        return last * r * (2 - r);
      case RoughnessMap::kUnity:
        return last * r * (1.7 - 0.7 * r);
      case RoughnessMap::kUnreal:
        return last - 1 + 1.2 * std::log2(std::max(r, kSmoothest));
      case RoughnessMap::kBabylon:
        return 0.8 * (last + 2 * std::log2(std::max(r, kSmoothest)));
    }
    return 0.0;
  };
  return std::clamp(level(), 0.0, last);
}

double roughness_of_level(RoughnessMap map, double level, int levels) {
  check(levels >= 1 && level >= 0 && level <= levels - 1, "roughness_of_level: level in [0, levels - 1]");
  if (levels == 1) return 0;
  const double last = levels - 1, t = level / last;
  const auto roughness = [&] {
    switch (map) {
      case RoughnessMap::kLinear:
        return t;
      case RoughnessMap::kFilament:
        return 1 - std::sqrt(1 - t);
      case RoughnessMap::kUnity:
        return (1.7 - std::sqrt(1.7 * 1.7 - 4 * 0.7 * t)) / (2 * 0.7);
      case RoughnessMap::kUnreal:
        return std::exp2((level - last + 1) / 1.2);
      case RoughnessMap::kBabylon:
        return std::exp2((level / 0.8 - last) / 2);
    }
    return 0.0;
  };
  return std::min(roughness(), 1.0);
}

}  // namespace zonal
