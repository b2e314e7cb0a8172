#include "zonal/light/resample_tiles.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "zonal/base/check.h"
#include "zonal/sphere/fineness.h"

namespace zonal {
namespace {

/// Texel coordinates that no kernel finds inside a picture: the sample is then looked up one by one.
constexpr float kNowhere = -8;

PanoramaScale panorama_scale(const Mapping& panorama) {
  const PixelPoint center = *panorama.position({1, 0, 0});
  const PixelPoint quarter = *panorama.position({0, -1, 0});
  const PixelPoint top = *panorama.position({0, 0, 1});
  // Texel centres are at half pixels; the quarter lies at azimuth -π/2.
  return {static_cast<float>(center.x - 0.5), static_cast<float>((center.x - quarter.x) / (kPi / 2)),
          static_cast<float>(center.y - 0.5), static_cast<float>((top.y - center.y) / (kPi / 2))};
}

void set(float (&axes)[3][kKernelPoints], int i, Vec3 v) {
  axes[0][i] = static_cast<float>(v.x);
  axes[1][i] = static_cast<float>(v.y);
  axes[2][i] = static_cast<float>(v.z);
}

Vec3 get(const float (&axes)[3][kKernelPoints], int i) { return {axes[0][i], axes[1][i], axes[2][i]}; }

Vec3 sample_at(const TexelFrames& frames, int i, double dx, double dy) {
  return normalize(get(frames.center, i) + dx * get(frames.across, i) + dy * get(frames.down, i));
}

/// Calls f(dx, dy) for the samples of a texel, offsets from its centre in its sides.
template <class F>
void for_each_part(const Footprint& cut, const F& f) {
  for (int j = 0; j < cut.down; ++j) {
    for (int i = 0; i < cut.across; ++i) f((i + 0.5) / cut.across - 0.5, (j + 0.5) / cut.down - 0.5);
  }
}

/// The centres of a tile's texels and of those around it, and what shows them.
template <class Map>
class Neighbourhood {
 public:
  Neighbourhood(const Map& map, const Rotation& turn, const Tile& tile) : columns_(tile.columns + 2) {
    const int x0 = tile.x - 1, y0 = tile.y - 1, rows = tile.rows + 2;
    places_.resize(static_cast<std::size_t>(columns_) * rows);
    for (int k = 0; k < columns_ * rows; ++k) {
      const PixelPoint center = center_of({x0 + k % columns_, y0 + k / columns_});
      if (const auto d = map.direction(center)) places_[k] = {turn * *d, map.chart(center)};
    }
  }

  bool shown(int i, int j) const { return at(i, j).chart >= 0; }
  Vec3 center(int i, int j) const { return at(i, j).toward; }
  /// The step to the next texel in direction (di, dj): between both neighbours of the same chart, or to the only one.
  Vec3 step(int i, int j, int di, int dj) const {
    const Place &here = at(i, j), &next = at(i + di, j + dj), &last = at(i - di, j - dj);
    const bool has_next = next.chart == here.chart, has_last = last.chart == here.chart;
    if (has_next && has_last) return 0.5 * (next.toward - last.toward);
    if (has_next) return next.toward - here.toward;
    return has_last ? here.toward - last.toward : Vec3{};
  }

 private:
  struct Place {
    Vec3 toward;
    int chart = -1;
  };
  const Place& at(int i, int j) const { return places_[(j + 1) * columns_ + i + 1]; }

  int columns_;
  std::vector<Place> places_;
};

}  // namespace

struct TileResampler::Points {
  float x[kKernelPoints], y[kKernelPoints];
};

TileResampler::TileResampler(const Environment& source, const Mapping& target, const Rotation& source_from_target,
                             int supersample, std::optional<Rgb> fill, Isa isa)
    : source_(source),
      source_mapping_(source.projection, {source.radiance.width(), source.radiance.height()}),
      target_(target),
      turn_(source_from_target),
      supersample_(supersample),
      fill_(source_mapping_.covers_sphere() ? std::nullopt : fill),
      kernels_(resample_kernels(isa)),
      sampler_(source),
      smooth_(source.projection, source_mapping_.size()),
      cell_width_(target.size().width),
      cell_height_(target.size().height) {
  check(source.radiance.size() < (1u << 31), "the kernels count texels in 31 bits");
  if (source.projection.layout == Layout::kEquirect) panorama_ = panorama_scale(source_mapping_);
  if (is_cube(target.projection().layout)) {
    cell_width_ = cell_height_ = *natural_size(target.projection().layout, target.size());
    for (int row = 0; row < target.size().height / cell_height_; ++row) {
      for (int column = 0; column < cells_across(); ++column) planes_.push_back(plane_at(column, row));
    }
  }
}

int TileResampler::cells_across() const { return target_.size().width / cell_width_; }
int TileResampler::tiles_across() const { return tiles_per(cell_width_, Tile::kColumns) * cells_across(); }
int TileResampler::tiles_down() const {
  return tiles_per(cell_height_, Tile::kRows) * (target_.size().height / cell_height_);
}

Tile TileResampler::tile(int column, int row) const {
  const int across = tiles_per(cell_width_, Tile::kColumns), down = tiles_per(cell_height_, Tile::kRows);
  const int x = column % across * Tile::kColumns, y = row % down * Tile::kRows;
  return {column / across * cell_width_ + x, row / down * cell_height_ + y, std::min(Tile::kColumns, cell_width_ - x),
          std::min(Tile::kRows, cell_height_ - y)};
}

Tile TileResampler::tile_of(Texel t) const {
  return tile(t.x / cell_width_ * tiles_per(cell_width_, Tile::kColumns) + t.x % cell_width_ / Tile::kColumns,
              t.y / cell_height_ * tiles_per(cell_height_, Tile::kRows) + t.y % cell_height_ / Tile::kRows);
}

Footprint TileResampler::footprint_of(const Tile& tile) const {
  const int right = tile.x + tile.columns - 1, bottom = tile.y + tile.rows - 1;
  const auto cut = [&](Texel t) { return footprint(target_, source_mapping_, turn_, t, supersample_); };
  Footprint most = largest(cut({(tile.x + right) / 2, (tile.y + bottom) / 2}), cut({tile.x, tile.y}));
  most = largest(most, cut({right, bottom}));
  for (int k = 0; !most.shown && k < tile.columns * tile.rows; ++k) {
    most = cut({tile.x + k % tile.columns, tile.y + k / tile.columns});
  }
  return most;
}

std::optional<TileResampler::Plane> TileResampler::plane_at(int column, int row) const {
  const double side = cell_width_, x = column * side, y = row * side;
  const auto normal = target_.direction({x + side / 2, y + side / 2});
  if (!normal) return std::nullopt;
  const auto on_plane = [&](double u, double v) {
    const Vec3 toward = *target_.direction({x + u * side, y + v * side});
    return turn_ * ((1 / dot(toward, *normal)) * toward);
  };
  const Vec3 middle = on_plane(0.5, 0.5);
  const Vec3 across = (2 / side) * (on_plane(0.75, 0.5) - on_plane(0.25, 0.5));
  const Vec3 down = (2 / side) * (on_plane(0.5, 0.75) - on_plane(0.5, 0.25));
  return Plane{middle - (x + side / 2) * across - (y + side / 2) * down, across, down};
}

void TileResampler::frames_of(const Tile& tile, Frames& frames) const {
  frames.rows.resize(tile.rows);
  frames.shown.assign(static_cast<std::size_t>(tile.rows) * tile.columns, 0);
  if (!planes_.empty()) {
    const auto& plane = planes_[tile.y / cell_height_ * cells_across() + tile.x / cell_width_];
    if (plane) frames_on_plane(*plane, tile, frames);
  } else {
    target_.visit([&](const auto& map) { frames_on_sphere(map, tile, frames); });
  }
}

void TileResampler::frames_on_plane(const Plane& plane, const Tile& tile, Frames& frames) const {
  for (int j = 0; j < tile.rows; ++j) {
    const Vec3 start = plane.origin + (tile.x + 0.5) * plane.across + (tile.y + j + 0.5) * plane.down;
    for (int i = 0; i < tile.columns; ++i) {
      set(frames.rows[j].center, i, start + i * plane.across);
      set(frames.rows[j].across, i, plane.across);
      set(frames.rows[j].down, i, plane.down);
    }
  }
  frames.shown.assign(frames.shown.size(), 1);
}

template <class Map>
void TileResampler::frames_on_sphere(const Map& map, const Tile& tile, Frames& frames) const {
  const Neighbourhood<Map> around(map, turn_, tile);
  for (int j = 0; j < tile.rows; ++j) {
    for (int i = 0; i < tile.columns; ++i) {
      TexelFrames& row = frames.rows[j];
      char& shown = frames.shown[j * tile.columns + i];
      shown = around.shown(i, j);
      if (shown) {
        set(row.center, i, around.center(i, j));
        set(row.across, i, around.step(i, j, 1, 0));
        set(row.down, i, around.step(i, j, 0, 1));
      } else {
        // A rim that leaves the centre outside leaves little inside: one point of it.
        const auto toward = map.texel_direction(tile.x + i, tile.y + j);
        shown = toward.has_value();
        set(row.center, i, toward ? turn_ * *toward : Vec3{1, 0, 0});
        set(row.across, i, {});
        set(row.down, i, {});
      }
    }
  }
}

void TileResampler::positions(const TexelFrames& frames, double dx, double dy, int count, Points& points) const {
  if (panorama_) {
    kernels_.panorama_positions(frames, static_cast<float>(dx), static_cast<float>(dy), *panorama_, count, points.x,
                                points.y);
    return;
  }
  // First a loop that vectorises, then the one that branches.
  double x[kKernelPoints], y[kKernelPoints], z[kKernelPoints];
  for (int i = 0; i < count; ++i) {
    double d[3];
    for (int axis = 0; axis < 3; ++axis) {
      d[axis] = frames.center[axis][i] + dx * frames.across[axis][i] + dy * frames.down[axis][i];
    }
    const double scale = 1 / std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    x[i] = scale * d[0], y[i] = scale * d[1], z[i] = scale * d[2];
  }
  std::fill(points.x, points.x + kKernelPoints, kNowhere);
  std::fill(points.y, points.y + kKernelPoints, kNowhere);
  source_mapping_.visit([&](const auto& map) {
    for (int i = 0; i < count; ++i) {
      const Vec3 toward = {x[i], y[i], z[i]};
      const auto p = map.position(toward);
      if (!p || !smooth_.hold_around(map, toward, *p)) continue;
      points.x[i] = static_cast<float>(p->x - 0.5);
      points.y[i] = static_cast<float>(p->y - 0.5);
    }
  });
}

Rgb TileResampler::look_up(Vec3 toward) const {
  if (fill_ && !source_mapping_.position(toward)) return *fill_;
  return sampler_(toward);
}

void TileResampler::resample_tile(const Tile& tile, Image<Rgb>& out) const {
  const Footprint cut = footprint_of(tile);
  if (!cut.shown) return;
  Frames frames;
  frames_of(tile, frames);
  const TexelArray texels = {source_.radiance.values().data(), source_.radiance.width(), source_.radiance.height()};
  const auto add_inside = cut.cubic ? kernels_.add_cubic : kernels_.add_linear;
  const float mean = 1 / static_cast<float>(cut.across * cut.down);

  for (int j = 0; j < tile.rows; ++j) {
    const char* shown = frames.shown.data() + static_cast<std::ptrdiff_t>(j) * tile.columns;
    float sums[kKernelPoints * kSumLanes] = {};
    for_each_part(cut, [&](double dx, double dy) {
      Points points;
      int missed[kKernelPoints];
      positions(frames.rows[j], dx, dy, tile.columns, points);
      const int misses = add_inside(texels, tile.columns, points.x, points.y, sums, missed);
      for (int k = 0; k < misses; ++k) {
        const int i = missed[k];
        if (!shown[i]) continue;
        const Rgb radiance = look_up(sample_at(frames.rows[j], i, dx, dy));
        sums[kSumLanes * i] += radiance.r;
        sums[kSumLanes * i + 1] += radiance.g;
        sums[kSumLanes * i + 2] += radiance.b;
      }
    });
    for (int i = 0; i < tile.columns; ++i) {
      const float* sum = sums + kSumLanes * i;
      if (shown[i])
        out(tile.x + i, tile.y + j) = {mean * (sum[0] + sum[3]), mean * (sum[1] + sum[4]), mean * (sum[2] + sum[5])};
    }
  }
}

std::vector<Vec3> TileResampler::samples_of(Texel t) const {
  const Footprint cut = footprint_of(tile_of(t));
  Frames frames;
  frames_of({t.x, t.y, 1, 1}, frames);
  std::vector<Vec3> samples;
  if (!frames.shown[0]) return samples;
  for_each_part(cut, [&](double dx, double dy) { samples.push_back(sample_at(frames.rows[0], 0, dx, dy)); });
  return samples;
}

}  // namespace zonal
