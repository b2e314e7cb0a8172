#include "zonal/light/survey.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "zonal/base/parallel.h"
#include "zonal/light/survey_sun.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What some rows hold together; rows join in order.
struct Tally {
  Survey survey;
  RgbD energy;  // Σ radiance * solid angle over finite texels
  double negative = 0;
  double finite_angle = 0;
  double min_luminance = kInfinity, max_luminance = -kInfinity;
  float max_channel = -std::numeric_limits<float>::infinity();
  std::vector<std::pair<int, float>> row_max_luminance, row_max_channel;

  void join(const Tally& part) {
    survey.shown += part.survey.shown;
    survey.texels += part.survey.texels;
    survey.nan_texels += part.survey.nan_texels;
    survey.inf_texels += part.survey.inf_texels;
    survey.negative_texels += part.survey.negative_texels;
    for (int i = 0; i < kLuminanceBins; ++i) survey.histogram[i] += part.survey.histogram[i];
    energy += part.energy;
    negative += part.negative;
    finite_angle += part.finite_angle;
    min_luminance = std::min(min_luminance, part.min_luminance);
    max_luminance = std::max(max_luminance, part.max_luminance);
    max_channel = std::max(max_channel, part.max_channel);
    const auto append = [](auto& all, const auto& more) { all.insert(all.end(), more.begin(), more.end()); };
    append(row_max_luminance, part.row_max_luminance);
    append(row_max_channel, part.row_max_channel);
  }
};

float luminance_of(Rgb c) { return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b; }

int bin_of(float light) {
  if (!(light > 0)) return 0;
  return std::clamp(std::ilogb(light) - kFirstBinLog2, 0, kLuminanceBins - 1);
}

/// A row of texels of one solid angle, none of them NaN or infinite.
void count_even_row(const RowCount& row, int y, int width, double solid_angle, Tally& tally) {
  const double angle = width * solid_angle;
  tally.survey.shown += angle;
  tally.survey.texels += width;
  tally.survey.negative_texels += row.negative_texels;
  for (int i = 0; i < kLuminanceBins; ++i) tally.survey.histogram[i] += row.bins[i] * solid_angle;
  tally.energy += solid_angle * RgbD{row.sum[0], row.sum[1], row.sum[2]};
  tally.negative += solid_angle * row.negative_sum;
  tally.finite_angle += angle;
  tally.min_luminance = std::min<double>(tally.min_luminance, row.min_luminance);
  tally.max_luminance = std::max<double>(tally.max_luminance, row.max_luminance);
  tally.max_channel = std::max(tally.max_channel, row.max_channel);
  tally.row_max_luminance.emplace_back(y, row.max_luminance);
  tally.row_max_channel.emplace_back(y, row.max_channel);
}

void count_any_row(const Environment& e, const Mapping& mapping, int y, Tally& tally) {
  float row_luminance = -std::numeric_limits<float>::infinity(), row_channel = row_luminance;
  for (int x = 0; x < e.radiance.width(); ++x) {
    const double solid_angle = mapping.solid_angle(x, y);
    if (solid_angle <= 0) continue;
    tally.survey.shown += solid_angle;
    ++tally.survey.texels;
    const Rgb c = e.radiance(x, y);
    if (std::isnan(c.r) || std::isnan(c.g) || std::isnan(c.b)) {
      ++tally.survey.nan_texels;
      continue;
    }
    if (std::isinf(c.r) || std::isinf(c.g) || std::isinf(c.b)) {
      ++tally.survey.inf_texels;
      continue;
    }
    const float light = luminance_of(c);
    tally.survey.negative_texels += c.r < 0 || c.g < 0 || c.b < 0;
    tally.survey.histogram[bin_of(light)] += solid_angle;
    tally.energy += solid_angle * RgbD(c);
    tally.negative += solid_angle * (std::min<double>(c.r, 0) + std::min<double>(c.g, 0) + std::min<double>(c.b, 0));
    tally.finite_angle += solid_angle;
    tally.min_luminance = std::min<double>(tally.min_luminance, light);
    row_luminance = std::max(row_luminance, light);
    row_channel = std::max(row_channel, max_channel(c));
  }
  tally.max_luminance = std::max<double>(tally.max_luminance, row_luminance);
  tally.max_channel = std::max(tally.max_channel, row_channel);
  tally.row_max_luminance.emplace_back(y, row_luminance);
  tally.row_max_channel.emplace_back(y, row_channel);
}

/// The first shown, finite texel in reading order with the largest luminance.
std::optional<Texel> brightest_texel(const Environment& e, const Mapping& mapping, const Tally& tally) {
  std::optional<Texel> found;
  float most = -std::numeric_limits<float>::infinity();
  for (const auto& [y, light] : tally.row_max_luminance) {
    if (!(light > most)) continue;
    for (int x = 0; x < e.radiance.width(); ++x) {
      const Rgb c = e.radiance(x, y);
      const float here = luminance_of(c);
      if (!(here > most) || !std::isfinite(here) || mapping.solid_angle(x, y) <= 0) continue;
      most = here;
      found = Texel{x, y};
    }
  }
  return found;
}

std::int64_t texels_at_ceiling(const Environment& e, const Mapping& mapping, const Tally& tally) {
  std::int64_t count = 0;
  for (const auto& [y, highest] : tally.row_max_channel) {
    if (highest != tally.max_channel) continue;
    for (int x = 0; x < e.radiance.width(); ++x) {
      count += max_channel(e.radiance(x, y)) == tally.max_channel && mapping.solid_angle(x, y) > 0;
    }
  }
  return count;
}

}  // namespace

Survey survey(const Environment& e, const Run& run) {
  const ImageSize size = {e.radiance.width(), e.radiance.height()};
  const Mapping mapping(e.projection, size);
  const bool even_rows = e.projection.layout == Layout::kEquirect;
  const SurveyKernels& kernels = survey_kernels(run.isa);
  const Tally tally = reduce_blocks(
      run, "survey", size.height, 16, Tally{},
      [&](Block block) {
        Tally part;
        for (int y = block.begin; y < block.end; ++y) {
          RowCount row;
          row.finite = false;
          if (even_rows) kernels.count_row(e.radiance.row(y).data(), size.width, &row);
          if (row.finite) {
            count_even_row(row, y, size.width, mapping.solid_angle(0, y), part);
          } else {
            count_any_row(e, mapping, y, part);
          }
        }
        return part;
      },
      [](Tally& total, const Tally& part) { total.join(part); });

  Survey result = tally.survey;
  result.size = size;
  const auto brightest = brightest_texel(e, mapping, tally);
  if (!brightest) return result;  // nothing finite is shown
  result.mean = (1 / tally.finite_angle) * tally.energy;
  result.min_luminance = tally.min_luminance;
  result.max_luminance = tally.max_luminance;
  result.toward_max = *mapping.texel_direction(brightest->x, brightest->y);
  const double positive = tally.energy.r + tally.energy.g + tally.energy.b - tally.negative;
  result.negative_energy_share = positive > 0 ? -tally.negative / positive : 0;
  result.plateau_texels = texels_at_ceiling(e, mapping, tally);
  const double mean = luminance(result.mean);
  result.clipped_sun = looks_clipped(e, mapping, *brightest, tally.max_channel, mean);
  result.sun = estimate_sun(e, mapping, *brightest, mean, luminance(tally.energy));
  return result;
}

}  // namespace zonal
