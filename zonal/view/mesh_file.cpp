#include "zonal/view/mesh_file.h"

#include <algorithm>
#include <string_view>

#include "zonal/base/error.h"
#include "zonal/io/file.h"
#include "zonal/view/mesh_file_soup.h"

namespace zonal {
namespace {

/// A text that a person could read, as far as one looks.
bool looks_like_text(std::string_view text) {
  return text.substr(0, 4096).find('\0') == std::string_view::npos && !text.empty();
}

std::string read_any(std::span<const std::byte> file, const std::filesystem::path& path, MeshSoup& soup) {
  const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  if (text.starts_with("ply\n") || text.starts_with("ply\r")) {
    read_ply(file, soup);
    return "PLY";
  }
  const std::size_t first = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  const bool json = first != std::string_view::npos && text[first] == '{';
  if (json || text.starts_with("glTF")) {
    read_gltf(file, path.parent_path(), soup);
    return json ? "glTF" : "GLB";
  }
  if (!looks_like_text(text)) soup.fail("it is no mesh file that is known here", "OBJ, PLY, glTF and GLB are read");
  read_obj(text, soup);
  return "OBJ";
}

}  // namespace

LoadedMesh load_mesh(const std::filesystem::path& path, const MeshLoadOptions& options, const Run& run) {
  const std::vector<std::byte> file = read_file(path, options.max_bytes);
  MeshSoup soup(path.string(), options, run);
  LoadedMesh loaded;
  loaded.format = read_any(file, path, soup);
  loaded.mesh = mesh_of_soup(soup);
  loaded.notes = std::move(soup.notes);
  return loaded;
}

LoadedMesh mesh_of(const std::string& shape_or_file, const MeshLoadOptions& options, const Run& run) {
  if (std::ranges::find(mesh_shape_names(), shape_or_file) != mesh_shape_names().end()) {
    return {mesh_shape(shape_or_file), {}, {}};
  }
  return load_mesh(shape_or_file, options, run);
}

}  // namespace zonal
