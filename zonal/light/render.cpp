#include "zonal/light/render.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "zonal/base/parallel.h"
#include "zonal/light/row_directions.h"
#include "zonal/sh/zonal.h"
#include "zonal/sht/transform.h"

namespace zonal {
namespace {

constexpr int kRowsPerBlock = 8;

/// How wrong six-point Lagrange interpolation of a wave of `frequency` radians a texel can be along both axes: the
/// remainder max |Π (x - x_i)| / 6! = 225/64/720 along one, seen through the other's weights (whose absolute sum is
/// below 1.7); and never more than both axes' weights allow at all.
double remainder_of(double frequency) {
  constexpr double kRemainder = 225.0 / 64 / 720, kLebesgue = 1.7;
  return std::min((1 + kLebesgue) * kRemainder * std::pow(frequency, 6), 1 + kLebesgue * kLebesgue);
}

double interpolation_bound(const std::vector<double>& maxima, int height) {
  double bound = 0;
  for (std::size_t l = 0; l < maxima.size(); ++l)
    bound += maxima[l] * remainder_of(kPi * static_cast<double>(l) / height);
  return bound;
}

/// Rows in steps of 16: lengths of the rings then are products of small factors.
int next_rows(double rows) { return static_cast<int>(std::ceil(rows / 16)) * 16; }

/// Eight rows a band, as long as the grid's memory (28 bytes a texel) stays near that of the map the bands came from;
/// many bands hold so little in the last of them that one and a half are enough.
int most_rows(int bands) { return next_rows(std::max(1.5 * bands, std::min(8.0 * bands, 2048.0))); }

}  // namespace

std::vector<double> band_maxima(const Sh<RgbD>& sh) {
  std::vector<double> maxima(sh.bands());
  for (int l = 0; l < sh.bands(); ++l) {
    RgbD squares;
    for (const RgbD& f : sh.band(l)) squares += f * f;
    maxima[l] = std::sqrt((2 * l + 1) / (4 * kPi) * max_channel(squares));
  }
  return maxima;
}

RingReader::RingReader(const Sh<RgbD>& sh, double tolerance, const Run& run, const GridWeight& weight)
    : kernels_(&render_kernels(run.isa)) {
  const std::vector<double> maxima = band_maxima(sh);
  // The last bands may be finer than the grid where they are too small to matter.
  height_ = next_rows(0.5 * sh.bands());
  const int most = most_rows(sh.bands());
  while (interpolation_bound(maxima, height_) > tolerance && height_ < most)
    height_ = std::min(most, next_rows(1.2 * height_));
  width_ = 2 * height_;
  error_bound_ = interpolation_bound(maxima, height_);

  const Grid<Rgb> map = synthesize(sh, {width_, height_}, run);
  Grid<Rgb> weights;
  if (weight.whole.bands() > 0) weights = synthesize(weight.whole, {width_, height_}, run);
  constexpr int kBorder = BorderedGrid::kBorder;
  texels_.resize(static_cast<std::size_t>(height_ + 2 * kBorder) * (width_ + 2 * kBorder) * 4);
  for_each_block(run, {}, height_ + 2 * kBorder, 16, [&](Block rows) {
    for (int row = rows.begin; row < rows.end; ++row) {
      int y = row - kBorder, turn = 0;
      if (y < 0 || y >= height_) {  // beyond a pole the picture goes on half a turn away
        y = y < 0 ? -1 - y : 2 * height_ - 1 - y;
        turn = width_ / 2;
      }
      float* out = texels_.data() + row * grid().row_stride();
      const double zonal = evaluate_zonal(weight.zonal, std::cos(kPi * (y + 0.5) / height_));
      for (int column = -kBorder; column < width_ + kBorder; ++column) {
        const int x = (column + turn + width_) % width_;
        const Rgb texel = map(x, y);
        *out++ = texel.r, *out++ = texel.g, *out++ = texel.b;
        *out++ = weights.empty() ? static_cast<float>(zonal) : weights(x, y).r;
      }
    }
  });
}

void RingReader::read(const double* x, const double* y, const double* z, int count, float* out, float* weight) const {
  kernels_->interpolate(grid(), x, y, z, count, out, weight);
}

Environment render(const Sh<RgbD>& sh, const Projection& projection, ImageSize size, const Run& run) {
  const Mapping mapping(projection, size);
  if (projection.layout == Layout::kEquirect) return {synthesize(sh, {size.width, size.height}, run), projection};
  const std::vector<double> maxima = band_maxima(sh);
  const RingReader reader(sh, 1e-6 * std::accumulate(maxima.begin(), maxima.end(), 0.0), run);
  Environment result{Image<Rgb>(size.width, size.height), projection};
  for_each_block(run, "texels", size.height, kRowsPerBlock, [&](Block rows) {
    RowDirections directions(size.width);
    std::vector<float> unused(size.width);
    for (int y = rows.begin; y < rows.end; ++y) {
      directions.set_row(mapping, y);
      std::span<Rgb> out = result.radiance.row(y);
      reader.read(directions.x.data(), directions.y.data(), directions.z.data(), size.width, &out.data()->r,
                  unused.data());
      directions.blacken_hidden(out);
    }
  });
  return result;
}

}  // namespace zonal
