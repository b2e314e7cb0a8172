#pragma once

#include <optional>
#include <vector>

#include "zonal/base/run.h"
#include "zonal/light/environment.h"
#include "zonal/light/resample_footprint.h"
#include "zonal/light/resample_kernel.h"
#include "zonal/light/sample.h"
#include "zonal/light/sample_charts.h"
#include "zonal/sphere/mapping.h"

namespace zonal {

/// Target texels that are computed together and cut alike. A tile does not cross the edge of a cube's face.
struct Tile {
  static constexpr int kColumns = kKernelPoints, kRows = 16;
  int x = 0, y = 0, columns = 0, rows = 0;
};

/// Computes target texels from a source, a tile at a time and from any number of threads.
///
/// A texel's samples are spread over the parallelogram that its centre's direction and the steps to its neighbours
/// span, so their mean is its centre whatever the chart does there: a fold, a rim, a pole's slivers. (Sub-pixels of the
/// picture, weighted by solid angle, have their mean up to a sixth of a texel beside it.)
class TileResampler {
 public:
  /// `fill`: the radiance of directions the source does not show; nullopt: its nearest texel.
  TileResampler(const Environment& source, const Mapping& target, const Rotation& source_from_target, int supersample,
                std::optional<Rgb> fill, Isa);

  int tiles_across() const;
  int tiles_down() const;
  Tile tile(int column, int row) const;
  /// The tile that holds a texel.
  Tile tile_of(Texel) const;
  /// How finely the texels of a tile are cut.
  Footprint footprint_of(const Tile&) const;

  void resample_tile(const Tile&, Image<Rgb>& out) const;
  /// The directions, in the source's frame, whose mean a texel is. Empty where it shows nothing.
  std::vector<Vec3> samples_of(Texel) const;

  const Mapping& source_mapping() const { return source_mapping_; }
  const Mapping& target_mapping() const { return target_; }
  const Rotation& source_from_target() const { return turn_; }

 private:
  /// A face's texel grid on the plane that touches the sphere at its centre, from the picture's corner, in the source's
  /// frame.
  struct Plane {
    Vec3 origin, across, down;
  };
  /// The footprints of a tile, row by row. `shown` is [row][column].
  struct Frames {
    std::vector<TexelFrames> rows;
    std::vector<char> shown;
  };
  struct Points;  // texel coordinates of one sample in each texel of a row

  static int tiles_per(int cell, int tile) { return (cell + tile - 1) / tile; }
  int cells_across() const;
  std::optional<Plane> plane_at(int column, int row) const;
  void frames_of(const Tile&, Frames&) const;
  void frames_on_plane(const Plane&, const Tile&, Frames&) const;
  template <class Map>
  void frames_on_sphere(const Map&, const Tile&, Frames&) const;
  void positions(const TexelFrames&, double dx, double dy, int count, Points&) const;
  Rgb look_up(Vec3 toward_in_source) const;

  const Environment& source_;
  Mapping source_mapping_;
  const Mapping& target_;
  Rotation turn_;
  int supersample_;
  std::optional<Rgb> fill_;
  const ResampleKernels& kernels_;
  Sampler sampler_;
  SmoothCharts smooth_;
  int cell_width_, cell_height_;              // a cube's face, else the whole picture
  std::vector<std::optional<Plane>> planes_;  // of a cube's faces, cell by cell of the picture
  std::optional<PanoramaScale> panorama_;     // where the source is one
};

}  // namespace zonal
