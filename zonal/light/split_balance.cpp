#include "zonal/light/split_balance.h"

#include <algorithm>
#include <cmath>

#include "zonal/base/parallel.h"

namespace zonal {
namespace {

std::array<double, 3> channels(RgbD c) { return {c.r, c.g, c.b}; }

void add(SphereSum& sum, RgbD energy, Vec3 toward) {
  sum.energy += energy;
  const std::array<double, 3> parts = channels(energy);
  for (int c = 0; c < 3; ++c) sum.vector[c] += parts[c] * toward;
}

void join(SphereSum& sum, const SphereSum& part) {
  sum.energy += part.energy;
  for (int c = 0; c < 3; ++c) sum.vector[c] += part.vector[c];
}

/// A row of a panorama: one solid angle, one height, and azimuths whose cosines are at hand.
void add_even_row(SphereSum& sum, std::span<const Rgb> row, std::span<const Vec3> around, double polar,
                  double solid_angle) {
  SphereSum level;  // as if all lay on the horizon
  for (std::size_t x = 0; x < row.size(); ++x) {
    const double r = row[x].r, g = row[x].g, b = row[x].b, east = around[x].x, north = around[x].y;
    level.energy += RgbD{r, g, b};
    level.vector[0].x += r * east, level.vector[0].y += r * north;
    level.vector[1].x += g * east, level.vector[1].y += g * north;
    level.vector[2].x += b * east, level.vector[2].y += b * north;
  }
  const std::array<double, 3> parts = channels(level.energy);
  sum.energy += solid_angle * level.energy;
  for (int c = 0; c < 3; ++c) {
    sum.vector[c] += solid_angle * (std::sin(polar) * level.vector[c] + Vec3{0, 0, std::cos(polar) * parts[c]});
  }
}

/// The largest over channels; over `fallback` where a whole is not positive.
double relative(const std::array<double, 3>& difference, const std::array<double, 3>& whole, double fallback) {
  double worst = 0;
  for (int c = 0; c < 3; ++c) {
    const double scale = whole[c] > 0 ? whole[c] : std::abs(fallback);
    if (difference[c] != 0) worst = std::max(worst, scale > 0 ? difference[c] / scale : HUGE_VAL);
  }
  return worst;
}

Vec3 luminance_of(const SphereSum& sum) {
  return luminance(Color3<double>(1, 0, 0)) * sum.vector[0] + luminance(Color3<double>(0, 1, 0)) * sum.vector[1] +
         luminance(Color3<double>(0, 0, 1)) * sum.vector[2];
}

}  // namespace

SphereSum sphere_sum(const Environment& e, const Mapping& mapping, const Run& run) {
  const ImageSize size = mapping.size();
  const bool even_rows = mapping.projection().layout == Layout::kEquirect;
  std::vector<Vec3> around;
  if (even_rows) {
    for (int x = 0; x < size.width; ++x) {
      const double azimuth = 2 * kPi * (0.5 - (x + 0.5) / size.width);
      around.push_back({std::cos(azimuth), std::sin(azimuth), 0});
    }
  }
  return reduce_blocks(
      run, "split: energy", size.height, 16, SphereSum{},
      [&](Block block) {
        SphereSum part;
        for (int y = block.begin; y < block.end; ++y) {
          if (even_rows) {
            add_even_row(part, e.radiance.row(y), around, kPi * (y + 0.5) / size.height, mapping.solid_angle(0, y));
            continue;
          }
          for (int x = 0; x < size.width; ++x) {
            const auto toward = mapping.texel_direction(x, y);
            if (toward) add(part, mapping.solid_angle(x, y) * RgbD(e.radiance(x, y)), *toward);
          }
        }
        return part;
      },
      [](SphereSum& total, const SphereSum& part) { join(total, part); });
}

SphereSum sphere_sum(const std::vector<SplitLight>& lights) {
  SphereSum sum;
  for (const SplitLight& light : lights) {
    sum.energy += light.energy;
    const std::array<double, 3> irradiance = channels(light.irradiance);
    for (int c = 0; c < 3; ++c) sum.vector[c] += irradiance[c] * light.direction;
  }
  return sum;
}

double SplitBalance::energy_difference() const {
  const RgbD d = whole.energy - (lights.energy + rest.energy);
  return relative({std::abs(d.r), std::abs(d.g), std::abs(d.b)}, channels(whole.energy), luminance(whole.energy));
}

double SplitBalance::vector_difference() const {
  const double difference = length(luminance_of(whole) - luminance_of(lights) - luminance_of(rest));
  const double energy = luminance(whole.energy);
  return relative({difference, 0, 0}, {energy, energy, energy}, energy);
}

double SplitBalance::vector_difference_rgb() const {
  std::array<double, 3> difference;
  for (int c = 0; c < 3; ++c) difference[c] = length(whole.vector[c] - lights.vector[c] - rest.vector[c]);
  return relative(difference, channels(whole.energy), luminance(whole.energy));
}

}  // namespace zonal
