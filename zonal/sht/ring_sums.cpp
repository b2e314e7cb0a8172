#include "zonal/sht/ring_sums.h"

#include <array>
#include <cmath>
#include <deque>
#include <memory>
#include <type_traits>
#include <vector>

#include "zonal/base/parallel.h"
#include "zonal/base/pool.h"
#include "zonal/sht/kernels.h"
#include "zonal/sht/ring_fft.h"
#include "zonal/sht/ring_moments.h"

namespace zonal {
namespace {

constexpr int kMaxLanes = 8;

template <class T>
using Scalar = decltype(T{}.r);

/// The rows of the ring pairs of one block: the ring j and its mirror image height-1-j. The middle ring of an odd
/// height is its own mirror image: its south is null, and so are the lanes past the last pair.
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

/// Two buffers for one block of rings on one thread.
struct RingBuffers {
  RingBuffers(const RingFft& fft, int lanes)
      : values(2UL * lanes * fft.capacity()), scratch(2UL * lanes * fft.capacity()) {}
  AlignedDoubles values, scratch;

  static Pool<RingBuffers> pool(const RingFft& fft, int lanes) {
    return Pool<RingBuffers>([&fft, lanes] { return std::make_unique<RingBuffers>(fft, lanes); });
  }
};

template <class T>
void transform_rings(const Grid<T>& map, int bands, RingWeights weights_kind, std::span<const GridTexel> left_out,
                     RingSpectrum& spectrum, const Run& run) {
  const RingKernels& kernels = ring_kernels(run.isa);
  const RingGrid grid{map.width(), map.height()};
  const RingFft fft(grid.width);
  const std::vector<double> weights = grid.weights(weights_kind);
  const std::vector<double> phases = azimuth_phases(bands, grid.width);
  const int lanes = kernels.lanes;
  Pool<RingBuffers> pool = RingBuffers::pool(fft, lanes);
  for_each_block(run, "rings", spectrum.blocks(), 1, [&](Block b) {
    Pool<RingBuffers>::Loan loan(pool);
    RingBuffers& buffers = *loan;
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

/// The same for at most six bands, by RingMoments.
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
void synthesize_map_rings(RingSpectrum& spectrum, int bands, Grid<T>& map, const Run& run) {
  const RingKernels& kernels = ring_kernels(run.isa);
  const RingFft fft(map.width());
  const std::vector<double> phases = azimuth_phases(bands, map.width());
  const int lanes = kernels.lanes;
  Pool<RingBuffers> pool = RingBuffers::pool(fft, lanes);
  for_each_block(run, "rings", spectrum.blocks(), 1, [&](Block b) {
    Pool<RingBuffers>::Loan loan(pool);
    RingBuffers& buffers = *loan;
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

}  // namespace

void analyze_rings(const Grid<Rgb>& map, int bands, RingWeights weights, std::span<const GridTexel> left_out,
                   RingSpectrum& spectrum, const Run& run) {
  if (RingMoments::serves(map.width(), bands)) {
    analyze_few_bands(map, bands, weights, left_out, spectrum, run);
  } else {
    transform_rings(map, bands, weights, left_out, spectrum, run);
  }
}
void analyze_rings(const Grid<RgbD>& map, int bands, RingWeights weights, std::span<const GridTexel> left_out,
                   RingSpectrum& spectrum, const Run& run) {
  transform_rings(map, bands, weights, left_out, spectrum, run);
}
void synthesize_rings(RingSpectrum& spectrum, int bands, Grid<Rgb>& map, const Run& run) {
  synthesize_map_rings(spectrum, bands, map, run);
}
void synthesize_rings(RingSpectrum& spectrum, int bands, Grid<RgbD>& map, const Run& run) {
  synthesize_map_rings(spectrum, bands, map, run);
}

}  // namespace zonal
