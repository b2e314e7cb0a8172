#include "zonal/sht/transform.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "zonal/base/parallel.h"
#include "zonal/base/pool.h"
#include "zonal/sht/kernels.h"
#include "zonal/sht/ring_sums.h"
#include "zonal/sht/spectrum.h"

namespace zonal {
namespace {

constexpr int kAmplitudes = 6;  // three channels, cosine and sine
// Columns of neighbouring m are done together, so that coefficients are read and written in runs of 2 kColumns.
constexpr int kColumns = 8;

/// cos θ and sin θ of the northern rings, padded to whole blocks with rings on the equator whose data are zero.
struct RingAngles {
  RingAngles(RingGrid grid, int padded) : aligned(2UL * padded), count(padded) {
    for (int j = 0; j < padded; ++j) {
      const bool real = j < grid.pairs();
      // sin(π/2 - θ) rather than cos θ: exactly zero on the middle ring.
      aligned.data()[j] = real ? std::sin(kPi * (grid.height - 2 * j - 1) / (2.0 * grid.height)) : 0;
      aligned.data()[padded + j] = real ? std::sin(grid.theta(j)) : 1;
    }
  }
  const double* x() const { return aligned.data(); }
  const double* sine() const { return aligned.data() + count; }

  AlignedDoubles aligned;
  int count;
};

/// The recurrence P_l = a_l x P_{l-1} - (a_l / a_{l-1}) P_{l-2}, a_l² = (4l² - 1) / (l² - m²), in the scale where its
/// second factor is one.
struct Column {
  std::vector<double> step, scale;  // [l - m]; step has two entries more, which the kernels may read ahead

  Column(int m, int bands) : step(bands - m + 2), scale(bands - m + 2, 1.0) {
    double before = 1;
    for (int l = m + 1; l < bands; ++l) {
      const int i = l - m;
      const double a = std::sqrt((4.0 * l * l - 1) / (static_cast<double>(l - m) * (l + m)));
      if (i >= 2) scale[i] = a / before * scale[i - 2];
      step[i] = a * scale[i - 1] / scale[i];
      before = a;
    }
  }
};

/// q_m / sin^m θ for each m: sqrt((2 - δ_m0) (2m + 1) / 4π · Π (2k - 1) / 2k).
std::vector<double> seeds(int bands) {
  std::vector<double> seeds(bands);
  double product = 1 / (4 * kPi);
  for (int m = 0; m < bands; ++m) {
    if (m > 0) product *= (2.0 * m - 1) / (2.0 * m);
    seeds[m] = std::sqrt((m == 0 ? 1 : 2) * (2.0 * m + 1) * product);
  }
  return seeds;
}

template <class T>
Sh<RgbD> analyze_map(const Grid<T>& map, int bands, RingWeights weights, const Run& run,
                     std::span<const GridTexel> left_out) {
  check(bands >= 1, "analyze: bands must be at least 1");
  check(!map.empty(), "analyze: the map is empty");
  const LegendreKernels& kernels = legendre_kernels(run.isa);
  const RingGrid grid{map.width(), map.height()};
  RingSpectrum spectrum(grid, bands, kernels.lanes);
  analyze_rings(map, bands, weights, left_out, spectrum, run);

  const RingAngles angles(grid, spectrum.blocks() * kernels.lanes);
  const std::vector<double> seed = seeds(bands);
  Sh<RgbD> coefficients(bands);
  struct Scratch {
    AlignedDoubles sums;    // [l - m][6][lanes] of one column
    AlignedDoubles totals;  // [m - first][l - first][6]
  };
  const std::size_t longest = static_cast<std::size_t>(bands) * kAmplitudes;
  Pool<Scratch> pool([&] {
    return std::make_unique<Scratch>(
        Scratch{AlignedDoubles(longest * kernels.lanes), AlignedDoubles(longest * kColumns)});
  });
  for_each_block(run, "bands", bands, kColumns, [&](Block columns) {
    typename Pool<Scratch>::Loan scratch(pool);
    AlignedDoubles& sums = scratch->sums;
    AlignedDoubles& totals = scratch->totals;
    const int lanes = kernels.lanes, first = columns.begin;
    const std::size_t column_size = static_cast<std::size_t>(bands - first) * kAmplitudes;
    for (int m = first; m < columns.end; ++m) {
      std::fill_n(sums.data(), static_cast<std::size_t>(bands - m) * kAmplitudes * lanes, 0.0);
      const Column column(m, bands);
      kernels.analyze({m, bands, seed[m], column.step.data()}, spectrum.blocks(), angles.x(), angles.sine(),
                      spectrum.at(m, 0), sums.data());
      double* total = totals.data() + (m - first) * column_size;
      for (int l = m; l < bands; ++l) {
        for (int a = 0; a < kAmplitudes; ++a) {
          const double* lane_sums = sums.data() + (static_cast<std::size_t>(l - m) * kAmplitudes + a) * lanes;
          double sum = 0;
          for (int lane = 0; lane < lanes; ++lane) sum += lane_sums[lane];
          total[static_cast<std::size_t>(l - first) * kAmplitudes + a] = sum * column.scale[l - m];
        }
      }
    }
    for (int l = first; l < bands; ++l) {
      for (int m = first; m < std::min(columns.end, l + 1); ++m) {
        const double* t = totals.data() + (m - first) * column_size + static_cast<std::size_t>(l - first) * kAmplitudes;
        coefficients(l, m) = {t[0], t[2], t[4]};
        if (m > 0) coefficients(l, -m) = {t[1], t[3], t[5]};
      }
    }
  });
  return coefficients;
}

template <class T>
void synthesize_map(const Sh<RgbD>& coefficients, Grid<T>& map, const Run& run) {
  check(!map.empty(), "synthesize: the map is empty");
  const RingGrid grid{map.width(), map.height()};
  const LegendreKernels& kernels = legendre_kernels(run.isa);
  const int bands = coefficients.bands();
  RingSpectrum spectrum(grid, bands, kernels.lanes);
  const RingAngles angles(grid, spectrum.blocks() * kernels.lanes);
  const std::vector<double> seed = seeds(bands);
  Pool<AlignedDoubles> pool(
      [&] { return std::make_unique<AlignedDoubles>(static_cast<std::size_t>(bands) * kAmplitudes * kColumns); });
  for_each_block(run, "bands", bands, kColumns, [&](Block columns) {
    const int first = columns.begin;
    const std::size_t column_size = static_cast<std::size_t>(bands - first) * kAmplitudes;
    Pool<AlignedDoubles>::Loan loan(pool);
    AlignedDoubles& scaled = *loan;  // [m - first][l - first][6]
    for (int l = first; l < bands; ++l) {
      for (int m = first; m < std::min(columns.end, l + 1); ++m) {
        double* t = scaled.data() + (m - first) * column_size + static_cast<std::size_t>(l - first) * kAmplitudes;
        const RgbD cosine = coefficients(l, m), sine = m > 0 ? coefficients(l, -m) : RgbD{};
        t[0] = cosine.r, t[1] = sine.r, t[2] = cosine.g, t[3] = sine.g, t[4] = cosine.b, t[5] = sine.b;
      }
    }
    for (int m = first; m < columns.end; ++m) {
      const Column column(m, bands);
      double* t = scaled.data() + (m - first) * column_size + static_cast<std::size_t>(m - first) * kAmplitudes;
      for (int l = m; l < bands; ++l) {
        for (int a = 0; a < kAmplitudes; ++a)
          t[static_cast<std::size_t>(l - m) * kAmplitudes + a] *= column.scale[l - m];
      }
      kernels.synthesize({m, bands, seed[m], column.step.data()}, spectrum.blocks(), angles.x(), angles.sine(), t,
                         spectrum.at(m, 0));
    }
  });
  synthesize_rings(spectrum, bands, map, run);
}

}  // namespace

Sh<RgbD> analyze(const Grid<Rgb>& map, int bands, RingWeights weights, const Run& run,
                 std::span<const GridTexel> left_out) {
  return analyze_map(map, bands, weights, run, left_out);
}
Sh<RgbD> analyze(const Grid<RgbD>& map, int bands, RingWeights weights, const Run& run) {
  return analyze_map(map, bands, weights, run, {});
}
void synthesize(const Sh<RgbD>& coefficients, Grid<Rgb>& map, const Run& run) {
  synthesize_map(coefficients, map, run);
}
void synthesize(const Sh<RgbD>& coefficients, Grid<RgbD>& map, const Run& run) {
  synthesize_map(coefficients, map, run);
}
Grid<Rgb> synthesize(const Sh<RgbD>& coefficients, RingGrid grid, const Run& run) {
  Grid<Rgb> map(grid.width, grid.height);
  synthesize(coefficients, map, run);
  return map;
}
Grid<RgbD> synthesize_double(const Sh<RgbD>& coefficients, RingGrid grid, const Run& run) {
  Grid<RgbD> map(grid.width, grid.height);
  synthesize(coefficients, map, run);
  return map;
}

}  // namespace zonal
