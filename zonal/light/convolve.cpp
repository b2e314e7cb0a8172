#include "zonal/light/convolve.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "zonal/base/parallel.h"
#include "zonal/light/distribution.h"
#include "zonal/light/render.h"
#include "zonal/light/resample.h"
#include "zonal/light/row_directions.h"
#include "zonal/light/truncation.h"
#include "zonal/sh/zonal.h"
#include "zonal/sht/transform.h"

namespace zonal {
namespace {

constexpr int kRowsPerBlock = 4;
// A texel with more than this share of the map's energy is a point: below it, what a texel can do to a bound is small.
constexpr double kPointShare = 1e-4;
// The bands' tail: |λ_l| below this from the last band on, whatever the bound says.
constexpr double kTail = 1e-5;
// Rough lobes have a kink at the horizon and converge slowly there; up to this many bands cost next to nothing.
constexpr int kFreeBands = 128;
// What interpolation may add to the error, relative to the mean.
constexpr double kInterpolation = 1e-5;

/// Steps in which bands are added until the bound is met.
int next_bands(int bands) { return bands + std::max(16, bands / 4 / 16 * 16); }

/// The first band from which on the factors stay below the tail; factors.size() when the last one does not.
int bands_for_tail(const std::vector<double>& factors) {
  int bands = static_cast<int>(factors.size());
  while (bands > 1 && std::abs(factors[bands - 1]) < kTail) --bands;
  return bands;
}

/// Cosine and GGX as the vector kernel knows them; nullopt for the rest.
std::optional<RationalLobe> rational(const Lobe& lobe) {
  const double peak = lobe.kernel(1);
  if (lobe.kind() == LobeKind::kCosine) return RationalLobe{peak, 1, 0};
  if (lobe.kind() == LobeKind::kGgx) {
    const double a2 = lobe.parameter() * lobe.parameter();
    return RationalLobe{peak * 4 * a2 * a2, 2 * a2, 1 - a2};
  }
  return std::nullopt;
}

/// How one lobe is convolved.
struct Plan {
  Lobe lobe;
  std::vector<double> factors;  // one for each band
  double truncation_bound = 0;
  double widening = 0;  // radians; 0: not widened, and the points are taken out
  int bands() const { return static_cast<int>(factors.size()); }
};

/// A lobe that is still there at the last band, times a Gaussian that is not. Nothing rings, for it is positive, so
/// points need not be taken out; what lies beyond the last band is ∫ 2l exp(-l²w²/2) dl = 2/w² kEdge of the mean at
/// most.
Plan widened_plan(const Lobe& lobe, std::vector<double> factors, double mean) {
  constexpr double kEdge = 1e-9;
  const auto bands = static_cast<double>(factors.size());
  const double width = std::sqrt(-2 * std::log(kEdge)) / bands;
  for (std::size_t l = 0; l < factors.size(); ++l) {
    factors[l] *= std::exp(-0.5 * width * width * static_cast<double>(l * (l + 1)));
  }
  return {lobe, std::move(factors), 2 / (width * width) * kEdge * mean, width};
}

Plan plan_for(const Lobe& lobe, const Distribution& map, double tolerance, int most) {
  const double mean = map.energy() / (4 * kPi);
  std::vector<double> factors = band_factors(lobe, most);
  const int tail = bands_for_tail(factors);
  if (tail == most && lobe.kind() != LobeKind::kCone) return widened_plan(lobe, std::move(factors), mean);

  int bands = std::min(most, std::max(kFreeBands, tail));
  const int last = std::max(bands, std::min(most, 4 * kFreeBands));
  Truncation truncation(lobe, last);
  truncation.extend(bands);
  double bound = rearrangement_bound(map.rest(), truncation.errors(), truncation.solid_angles());
  while (bound > tolerance * mean && bands < last) {
    bands = std::min(last, next_bands(bands));
    truncation.extend(bands);
    bound = rearrangement_bound(map.rest(), truncation.errors(), truncation.solid_angles());
  }
  factors.resize(bands);
  return {lobe, std::move(factors), bound};
}

/// Rows of an equirectangular map with texels no larger than the picture's, on the average.
int equirect_rows(ImageSize size, const Projection& projection) {
  const double texels = coverage(projection, size) > 0 ? static_cast<double>(size.width) * size.height : 1;
  return static_cast<int>(std::ceil(std::sqrt(texels / 2) * 1.25 / 16)) * 16;
}

}  // namespace

Environment as_equirect(const Environment& environment, const Run& run) {
  if (environment.projection.layout == Layout::kEquirect) return environment;
  const ImageSize size{environment.radiance.width(), environment.radiance.height()};
  return resample(environment, {Layout::kEquirect}, equirect_rows(size, environment.projection), {}, run);
}

struct Convolution::State {
  double mean = 0, peak = 0;  // brightness of the whole map
  bool any_negative = false;
  std::vector<Plan> plans;
  std::vector<PointLight> points;
  Sh<RgbD> rest;   // without the points
  Sh<RgbD> whole;  // with them, for widened lobes
  GridWeight one;  // what the grid takes the constant 1 for

  const Sh<RgbD>& coefficients(const Plan& plan) const { return plan.widening > 0 ? whole : rest; }
};

Convolution::Convolution(const Environment& environment, std::span<const Lobe> lobes, const ConvolveOptions& options,
                         const Run& run) {
  check(!lobes.empty(), "a convolution needs a lobe");
  Environment resampled;
  const bool equirect = environment.projection.layout == Layout::kEquirect;
  if (!equirect) resampled = as_equirect(environment, run);
  const Image<Rgb>& map = equirect ? environment.radiance : resampled.radiance;
  const RingGrid grid{map.width(), map.height()};
  const std::vector<double> weights = grid.weights(RingWeights::kTexelArea);

  auto state = std::make_unique<State>();
  const Distribution distribution(map, weights, kPointShare, options.max_points, run);
  state->mean = distribution.energy() / (4 * kPi);
  state->peak = distribution.maximum();
  state->any_negative = distribution.any_negative();

  std::vector<GridTexel> left_out;
  const Mapping mapping({Layout::kEquirect}, {grid.width, grid.height});
  for (const Distribution::Peak& peak : distribution.peaks()) {
    const auto [x, y] = peak.texel;
    const Vec3 toward = *mapping.direction({x + 0.5, y + 0.5});
    const Rgb light = static_cast<Rgb>(weights[y] * static_cast<RgbD>(map(x, y)));
    left_out.push_back(peak.texel);
    state->points.push_back({toward.x, toward.y, toward.z, light.r, light.g, light.b});
  }

  const int most_bands = std::min(options.max_bands, std::max(512, 2 * grid.height));
  std::vector<std::optional<Plan>> plans(lobes.size());
  for_each_block(run, {}, static_cast<int>(lobes.size()), 1, [&](Block one) {
    plans[one.begin] = plan_for(lobes[one.begin], distribution, options.tolerance, most_bands);
  });
  int bands_of_rest = 0, bands_of_whole = 0;
  for (std::optional<Plan>& planned : plans) {
    const Plan& plan = state->plans.emplace_back(std::move(*planned));
    int& bands = plan.widening > 0 ? bands_of_whole : bands_of_rest;
    bands = std::max(bands, plan.bands());
  }
  const auto analyzed = [&](int bands, std::span<const GridTexel> without) {
    return bands > 0 ? analyze(map, bands, RingWeights::kTexelArea, run, without) : Sh<RgbD>(0);
  };
  state->rest = analyzed(bands_of_rest, left_out);
  state->whole = analyzed(bands_of_whole, {});
  const int bands = std::max(bands_of_rest, bands_of_whole);
  if (bands <= grid.width) {
    state->one.zonal = grid.response_to_one(RingWeights::kTexelArea, bands);
  } else {
    state->one.whole = analyze(Grid<Rgb>(grid.width, grid.height, {1, 1, 1}), bands, RingWeights::kTexelArea, run);
  }
  state_ = std::move(state);
}

Convolution::~Convolution() = default;
Convolution::Convolution(Convolution&&) noexcept = default;

const Sh<RgbD>& Convolution::coefficients() const { return state_->rest.bands() > 0 ? state_->rest : state_->whole; }

Convolved Convolution::render(int i, const Projection& projection, ImageSize size, const Run& run) const {
  check(i >= 0 && i < static_cast<int>(state_->plans.size()), "no such lobe");
  const Plan& plan = state_->plans[i];
  const Mapping mapping(projection, size);
  const Sh<RgbD> filtered = convolve(with_bands(state_->coefficients(plan), plan.bands()), plan.factors);
  const bool with_points = plan.widening == 0 && !state_->points.empty();
  GridWeight total_weight;
  if (state_->one.zonal.empty()) {
    total_weight.whole = convolve(with_bands(state_->one.whole, plan.bands()), plan.factors);
  } else {
    for (int l = 0; l < plan.bands(); ++l) total_weight.zonal.push_back(plan.factors[l] * state_->one.zonal[l]);
  }
  const RingReader reader(filtered, kInterpolation * state_->mean, run, total_weight);
  const std::optional<RationalLobe> fast = rational(plan.lobe);

  Convolved result{{Image<Rgb>(size.width, size.height), projection}, {}};
  const auto add_points = [&](const RowDirections& at, std::span<Rgb> row) {
    if (fast) {
      render_kernels(run.isa).add_points(*fast, state_->points.data(), static_cast<int>(state_->points.size()),
                                         at.x.data(), at.y.data(), at.z.data(), size.width, &row.data()->r);
      return;
    }
    for (int x = 0; x < size.width; ++x) {
      RgbD sum;
      for (const PointLight& p : state_->points) {
        const Vec3 gap = Vec3{at.x[x], at.y[x], at.z[x]} - Vec3{p.x, p.y, p.z};
        sum += plan.lobe.kernel_from_versine(0.5 * dot(gap, gap)) * RgbD{p.r, p.g, p.b};
      }
      row[x] += static_cast<Rgb>(sum);
    }
  };

  struct Zeroed {
    std::int64_t texels = 0;
    float depth = 0;
  };
  const Zeroed zeroed = reduce_blocks(
      run, "texels", size.height, kRowsPerBlock, Zeroed{},
      [&](Block rows) {
        Zeroed found;
        RowDirections directions(size.width);
        std::vector<float> total(size.width);
        for (int y = rows.begin; y < rows.end; ++y) {
          directions.set_row(mapping, y);
          const std::span<Rgb> row = result.map.radiance.row(y);
          reader.read(directions.x.data(), directions.y.data(), directions.z.data(), size.width, &row.data()->r,
                      total.data());
          if (with_points) add_points(directions, row);
          for (int x = 0; x < size.width; ++x) row[x] = (1 / total[x]) * row[x];
          directions.blacken_hidden(row);
          if (state_->any_negative) continue;
          // The truth is not negative, so the nearest value it can have is zero.
          for (Rgb& texel : row) {
            const float lowest = std::min({texel.r, texel.g, texel.b});
            if (lowest >= 0) continue;
            ++found.texels;
            found.depth = std::max(found.depth, -lowest);
            texel = {std::max(texel.r, 0.0f), std::max(texel.g, 0.0f), std::max(texel.b, 0.0f)};
          }
        }
        return found;
      },
      [](Zeroed& sum, const Zeroed& part) {
        sum.texels += part.texels;
        sum.depth = std::max(sum.depth, part.depth);
      });

  ConvolveReport& report = result.report;
  report.bands = plan.bands();
  report.points = with_points ? static_cast<int>(state_->points.size()) : 0;
  report.widened_deg = degrees(plan.widening);
  report.error_bound = plan.truncation_bound + reader.error_bound();
  report.bound_to_mean = state_->mean > 0 ? report.error_bound / state_->mean : 0;
  report.bound_to_peak = state_->peak > 0 ? report.error_bound / state_->peak : 0;
  report.zeroed_texels = zeroed.texels;
  report.zeroed_depth = zeroed.depth;
  return result;
}

Convolved convolve(const Environment& environment, const Lobe& lobe, const Projection& projection, ImageSize size,
                   const ConvolveOptions& options, const Run& run) {
  return Convolution(environment, {&lobe, 1}, options, run).render(0, projection, size, run);
}

}  // namespace zonal
