#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "zonal/base/run.h"
#include "zonal/math/vec.h"
#include "zonal/view/mesh_file.h"

namespace zonal {

/// A corner of a triangle as files have it: places in the lists of the soup, -1 where the file gives none.
struct MeshCorner {
  std::int32_t position = -1, normal = -1, uv = -1;
};

/// The place of a list that a file names. Whatever is no such number becomes one that no list reaches.
inline std::int32_t mesh_place(double number) {
  constexpr std::int32_t kNowhere = std::numeric_limits<std::int32_t>::max();
  return number >= 0 && number < kNowhere ? static_cast<std::int32_t>(number) : kNowhere;
}

/// What a reader of mesh files fills: lists, and triangles of places in them that nobody has checked yet.
class MeshSoup {
 public:
  MeshSoup(std::string name, const MeshLoadOptions& options, const Run& run)
      : name_(std::move(name)), options_(options), run_(run) {}

  std::vector<Vec3> positions, normals;
  std::vector<std::array<double, 2>> uvs;  // from the top left corner down
  std::vector<std::string> notes;
  bool y_up = false;

  /// A fan about the first corner; fewer than three corners are nothing. Throws when there are too many triangles or
  /// the run is stopped.
  void add_polygon(std::span<const MeshCorner>);
  /// Of a list that the file announces. Throws when there would be too many.
  void check_count(std::uint64_t vertices) const;

  std::span<const std::array<MeshCorner, 3>> triangles() const { return triangles_; }
  const MeshLoadOptions& options() const { return options_; }

  /// Throws Error{kInput} "name: what".
  [[noreturn]] void fail(const std::string& what, const std::string& hint = {}) const;
  void check_stop() const;

 private:
  std::string name_;
  const MeshLoadOptions& options_;
  const Run& run_;
  std::vector<std::array<MeshCorner, 3>> triangles_;
};

/// Checks everything, centres, scales, turns, and makes what is missing.
Mesh mesh_of_soup(MeshSoup&);

// Readers by format.
void read_obj(std::string_view text, MeshSoup&);
void read_ply(std::span<const std::byte> file, MeshSoup&);
/// `folder` is where the buffers of a file that is no GLB are.
void read_gltf(std::span<const std::byte> file, const std::filesystem::path& folder, MeshSoup&);

}  // namespace zonal
