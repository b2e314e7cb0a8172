#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "zonal/base/run.h"
#include "zonal/view/mesh.h"

namespace zonal {

/// Which axis of a mesh file points up.
enum class MeshUp {
  kFormat,  ///< as the format says: Y in OBJ (by custom) and glTF (by its specification), Z in PLY (which says nothing)
  kY,
  kZ,
};

struct MeshLoadOptions {
  MeshUp up = MeshUp::kFormat;
  /// Larger files are refused before memory is taken.
  std::uint64_t max_bytes = std::uint64_t{1} << 29;
  /// More are refused while they are read; vertices alike. A triangle takes about 200 bytes while it is read.
  std::int64_t max_triangles = std::int64_t{1} << 22;
};

struct LoadedMesh {
  Mesh mesh;
  std::string format;              ///< "OBJ", "PLY", "glTF" or "GLB"
  std::vector<std::string> notes;  ///< what was made, turned or left out, in words for the user
};

/// Reads a mesh and makes it what the viewer draws: OBJ, PLY (text, binary of either byte order) and glTF 2.0 (.gltf,
/// .glb), told apart by their content. All objects of a file are one mesh; materials, textures, skins and animations
/// are left out, and no file but the buffers of a .gltf is opened, these from its own folder only.
///
/// Polygons become fans about their first corner; triangles without an area are left out. What is used must be finite.
/// The middle of the bounding box goes to the origin and the farthest point to distance 1. Y-up files are turned so
/// that +Y becomes +Z and the front, +Z, becomes -X, where the eye is at first. Normals are made unit; where a corner
/// has none, it gets the mean of the faces that meet at its place, weighted by their angles (Thürmer & Wüthrich 1998).
/// Where one has no texture coordinates it gets its longitude and colatitude, and u passes 1 across the seam. Texture
/// coordinates run down from the top left corner, as glTF's do; those of OBJ and PLY, which run up, are turned over.
///
/// Throws Error{kInput}: missing, no known format, broken, truncated, over a limit, nothing to draw, something that a
/// reader of triangles cannot do (compressed or sparse glTF). Error{kCancelled}.
LoadedMesh load_mesh(const std::filesystem::path&, const MeshLoadOptions& = {}, const Run& = {});

/// mesh_shape() for the name of a shape, load_mesh() for anything else.
LoadedMesh mesh_of(const std::string& shape_or_file, const MeshLoadOptions& = {}, const Run& = {});

}  // namespace zonal
