#include "zonal/sht/transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <type_traits>

#include "zonal/base/parallel.h"
#include "zonal/sht/kernels.h"
#include "zonal/sht/ring_fft.h"
#include "zonal/sht/ring_moments.h"
#include "zonal/sht/spectrum.h"

namespace zonal {
namespace {

constexpr int kMaxLanes = 8;
constexpr int kAmplitudes = 6;  // three channels, cosine and sine
// Columns of neighbouring m are done together, so that coefficients are read and written in runs of 2 kColumns.
constexpr int kColumns = 8;

template <class T>
using Scalar = decltype(T{}.r);

/// The rows of the ring pairs of one block: the ring j and its mirror image height-1-j. The middle ring of an odd height is its own
/// mirror image: its south is null, and so are the lanes past the last pair.
template <class Row>
struct PairRows {
  std::array<Row, kMaxLanes> north{}, south{};

  template <class RowOf>
  PairRows(int height, int first_pair, int lanes, RowOf row_of) {
    for (int lane = 0; lane < lanes; ++lane) {
      const int j = first_pair + lane, mirror = height - 1 - j;
      if (j > mirror) continue;
      north[lane] = row_of(j);
      if (mirror != j) south[lane] = row_of(mirror);
    }
  }
};

/// The rows of a map, those with left-out texels as copies in which they are zero.
template <class T>
class RowReader {
 public:
  RowReader(const Grid<T>& map, std::span<const GridTexel> left_out) : map_(map), left_out_(left_out) {}

  const Scalar<T>* operator()(int y) {
    std::vector<T>* copy = nullptr;
    for (const GridTexel& texel : left_out_) {
      if (texel.y != y) continue;
      if (copy == nullptr) copy = &copies_.emplace_back(map_.row(y).begin(), map_.row(y).end());
      (*copy)[texel.x] = T{};
    }
    return copy != nullptr ? &copy->data()->r : &map_.row(y).data()->r;
  }

 private:
  const Grid<T>& map_;
  std::span<const GridTexel> left_out_;
  std::deque<std::vector<T>> copies_;
};

/// exp(-i m φ_0), φ_0 = π - π/width the azimuth of texel 0, as (re, im) pairs.
std::vector<double> azimuth_phases(int bands, int width) {
  std::vector<double> phases;
  for (int m = 0; m < bands; ++m) {
    // -mφ_0 = πm (1/width - 1), reduced to one turn in integers first.
    const long turn = static_cast<long>(m) * (1L - width) % (2L * width);
    const double angle = kPi * static_cast<double>(turn) / width;
    phases.push_back(std::cos(angle));
    phases.push_back(std::sin(angle));
  }
  return phases;
}

/// cos θ and sin θ of the northern rings, padded to whole blocks with rings on the equator whose data are zero.
struct RingAngles {
  std::vector<double> cosines, sines;
  AlignedDoubles aligned;

  RingAngles(RingGrid grid, int padded) : aligned(2UL * padded) {
    for (int j = 0; j < padded; ++j) {
      const bool real = j < grid.pairs();
      // sin(π/2 - θ) rather than cos θ: exactly zero on the middle ring.
      aligned.data()[j] = real ? std::sin(kPi * (grid.height - 2 * j - 1) / (2.0 * grid.height)) : 0;
      aligned.data()[padded + j] = real ? std::sin(grid.theta(j)) : 1;
    }
    count = padded;
  }
  const double* x() const { return aligned.data(); }
  const double* sine() const { return aligned.data() + count; }
  int count;
};

/// The recurrence P_l = a_l x P_{l-1} - (a_l / a_{l-1}) P_{l-2}, a_l² = (4l² - 1) / (l² - m²), in the scale where its second factor is one.
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

/// Two buffers for one block of rings on one thread.
struct RingBuffers {
  RingBuffers(const RingFft& fft, int lanes) : values(2UL * lanes * fft.capacity()), scratch(2UL * lanes * fft.capacity()) {}
  AlignedDoubles values, scratch;
};

template <class T>
void analyze_rings(const Grid<T>& map, int bands, RingWeights weights_kind, std::span<const GridTexel> left_out,
                   RingSpectrum& spectrum, const Run& run) {
  const RingKernels& kernels = ring_kernels(run.isa);
  const RingGrid grid{map.width(), map.height()};
  const RingFft fft(grid.width);
  const std::vector<double> weights = grid.weights(weights_kind);
  const std::vector<double> phases = azimuth_phases(bands, grid.width);
  const int lanes = kernels.lanes;
  for_each_block(run, "rings", spectrum.blocks(), 1, [&](Block b) {
    RingBuffers buffers(fft, lanes);
    RowReader<T> reader(map, left_out);
    const PairRows<const Scalar<T>*> rows(grid.height, b.index * lanes, lanes, [&](int y) { return reader(y); });
    alignas(64) std::array<double, kMaxLanes> ring_weights{};
    for (int lane = 0; lane < lanes; ++lane) {
      const int j = b.index * lanes + lane;
      ring_weights[lane] = j < grid.pairs() ? weights[j] : 0;
    }
    for (int channel = 0; channel < 3; ++channel) {
      if constexpr (std::is_same_v<T, Rgb>) {
        kernels.load_float(rows.north.data(), rows.south.data(), channel, grid.width, buffers.values.data());
      } else {
        kernels.load_double(rows.north.data(), rows.south.data(), channel, grid.width, buffers.values.data());
      }
      const double* transformed = fft.forward(kernels, buffers.values.data(), buffers.scratch.data());
      kernels.unpack(transformed, grid.width, channel, bands, phases.data(), ring_weights.data(),
                     spectrum.at(0, b.index), spectrum.stride());
    }
  });
}

/// The same for at most six bands.
void analyze_few_bands(const Grid<Rgb>& map, int bands, RingWeights weights_kind, std::span<const GridTexel> left_out,
                       RingSpectrum& spectrum, const Run& run) {
  const RingGrid grid{map.width(), map.height()};
  const RingMoments moments(grid.width, bands, run.isa);
  const std::vector<double> weights = grid.weights(weights_kind);
  const std::vector<double> phases = azimuth_phases(bands, grid.width);
  const int lanes = spectrum.lanes();
  for_each_block(run, "rings", spectrum.blocks(), 1, [&](Block b) {
    RowReader<Rgb> reader(map, left_out);
    const PairRows<const float*> rows(grid.height, b.index * lanes, lanes, [&](int y) { return reader(y); });
    for (int lane = 0; lane < lanes; ++lane) {
      RingMoments::Values values = {};
      if (rows.north[lane] != nullptr) moments(rows.north[lane], rows.south[lane], values);
      const double weight = rows.north[lane] != nullptr ? weights[b.index * lanes + lane] : 0;
      for (int m = 0; m < bands; ++m) {
        double* target = spectrum.at(m, b.index) + lane;
        const double phase_re = phases[2 * m], phase_im = phases[2 * m + 1];
        for (int i = 0; i < 6; ++i) {  // [symmetric, antisymmetric][channel]
          const int c = i % 3;
          const double sign = i < 3 ? 1 : -1;
          const double re = weight * (values[0][m][0][c] + sign * values[1][m][0][c]);
          const double im = weight * (values[0][m][1][c] + sign * values[1][m][1][c]);
          // conj(sum) turned by the phase of texel 0, as in RingKernels::unpack.
          target[2 * i * lanes] = re * phase_re + im * phase_im;
          target[(2 * i + 1) * lanes] = im * phase_re - re * phase_im;
        }
      }
    }
  });
}

template <class T>
void synthesize_rings(RingSpectrum& spectrum, int bands, Grid<T>& map, const Run& run) {
  const RingKernels& kernels = ring_kernels(run.isa);
  const RingFft fft(map.width());
  const std::vector<double> phases = azimuth_phases(bands, map.width());
  const int lanes = kernels.lanes;
  for_each_block(run, "rings", spectrum.blocks(), 1, [&](Block b) {
    RingBuffers buffers(fft, lanes);
    const PairRows<Scalar<T>*> rows(map.height(), b.index * lanes, lanes, [&](int y) { return &map.row(y).data()->r; });
    for (int channel = 0; channel < 3; ++channel) {
      kernels.pack(spectrum.at(0, b.index), spectrum.stride(), channel, bands, phases.data(), map.width(),
                   buffers.values.data());
      const double* result = fft.forward(kernels, buffers.values.data(), buffers.scratch.data());
      if constexpr (std::is_same_v<T, Rgb>) {
        kernels.store_float(result, channel, map.width(), rows.north.data(), rows.south.data());
      } else {
        kernels.store_double(result, channel, map.width(), rows.north.data(), rows.south.data());
      }
    }
  });
}


template <class T>
Sh<RgbD> analyze_map(const Grid<T>& map, int bands, RingWeights weights, const Run& run,
                     std::span<const GridTexel> left_out) {
  check(bands >= 1, "analyze: bands must be at least 1");
  check(!map.empty(), "analyze: the map is empty");
  const LegendreKernels& kernels = legendre_kernels(run.isa);
  const RingGrid grid{map.width(), map.height()};
  RingSpectrum spectrum(grid, bands, kernels.lanes);
  if constexpr (std::is_same_v<T, Rgb>) {
    if (RingMoments::serves(grid.width, bands)) {
      analyze_few_bands(map, bands, weights, left_out, spectrum, run);
    } else {
      analyze_rings(map, bands, weights, left_out, spectrum, run);
    }
  } else {
    analyze_rings(map, bands, weights, left_out, spectrum, run);
  }

  const RingAngles angles(grid, spectrum.blocks() * kernels.lanes);
  const std::vector<double> seed = seeds(bands);
  Sh<RgbD> coefficients(bands);
  for_each_block(run, "bands", bands, kColumns, [&](Block columns) {
    const int lanes = kernels.lanes, first = columns.begin;
    const std::size_t column_size = static_cast<std::size_t>(bands - first) * kAmplitudes;
    AlignedDoubles sums(column_size * lanes);
    std::vector<double> totals(column_size * kColumns);  // [m - first][l - first][6]
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
Grid<T> synthesize_map(const Sh<RgbD>& coefficients, RingGrid grid, const Run& run) {
  check(grid.width >= 1 && grid.height >= 1, "synthesize: the grid is empty");
  const LegendreKernels& kernels = legendre_kernels(run.isa);
  const int bands = coefficients.bands();
  RingSpectrum spectrum(grid, bands, kernels.lanes);
  const RingAngles angles(grid, spectrum.blocks() * kernels.lanes);
  const std::vector<double> seed = seeds(bands);
  for_each_block(run, "bands", bands, kColumns, [&](Block columns) {
    const int first = columns.begin;
    const std::size_t column_size = static_cast<std::size_t>(bands - first) * kAmplitudes;
    std::vector<double> scaled(column_size * kColumns);  // [m - first][l - first][6]
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
        for (int a = 0; a < kAmplitudes; ++a) t[static_cast<std::size_t>(l - m) * kAmplitudes + a] *= column.scale[l - m];
      }
      kernels.synthesize({m, bands, seed[m], column.step.data()}, spectrum.blocks(), angles.x(), angles.sine(), t,
                         spectrum.at(m, 0));
    }
  });
  Grid<T> map(grid.width, grid.height);
  synthesize_rings(spectrum, bands, map, run);
  return map;
}

}  // namespace

Sh<RgbD> analyze(const Grid<Rgb>& map, int bands, RingWeights weights, const Run& run,
                 std::span<const GridTexel> left_out) {
  return analyze_map(map, bands, weights, run, left_out);
}
Sh<RgbD> analyze(const Grid<RgbD>& map, int bands, RingWeights weights, const Run& run) {
  return analyze_map(map, bands, weights, run, {});
}
Grid<Rgb> synthesize(const Sh<RgbD>& coefficients, RingGrid grid, const Run& run) {
  return synthesize_map<Rgb>(coefficients, grid, run);
}
Grid<RgbD> synthesize_double(const Sh<RgbD>& coefficients, RingGrid grid, const Run& run) {
  return synthesize_map<RgbD>(coefficients, grid, run);
}

}  // namespace zonal
