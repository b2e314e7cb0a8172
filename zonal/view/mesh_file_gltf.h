#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "zonal/view/mesh_file_soup.h"

namespace zonal {

using GltfJson = nlohmann::json;

/// A whole number of an object, `otherwise` where it has none. Fails for anything that is no whole number >= 0.
std::uint64_t gltf_number(const MeshSoup&, const GltfJson& object, const char* key, std::uint64_t otherwise);
/// The member of a list of the document that a number names. Fails where there is none, or where it is no object.
const GltfJson& gltf_member(const MeshSoup&, const GltfJson& document, const char* list, std::uint64_t index);
/// A list of the document or of an object; empty where there is none. Fails for what is no list.
const GltfJson& gltf_list(const MeshSoup&, const GltfJson& object, const char* key);

/// The numbers of an accessor, checked to lie within their buffer: element i, component k.
class GltfNumbers {
 public:
  std::size_t count() const { return count_; }
  double operator()(std::size_t i, int k = 0) const;

 private:
  friend class GltfBuffers;
  const std::byte* first_ = nullptr;
  std::size_t count_ = 0, stride_ = 0;
  int type_ = 0;  // of a component, as OpenGL names it
  double scale_ = 1;
};

/// The buffers of a glTF document: the one inside a GLB, `data:` addresses, and files of the document's own folder.
class GltfBuffers {
 public:
  /// All must outlive it.
  GltfBuffers(const GltfJson& document, std::span<const std::byte> glb_buffer, const std::filesystem::path& folder,
              const MeshSoup& soup)
      : document_(document), glb_buffer_(glb_buffer), folder_(folder), soup_(soup) {}

  /// Fails for sparse accessors and unless it has this many components ("SCALAR" 1, "VEC2" 2, "VEC3" 3).
  GltfNumbers numbers(std::uint64_t accessor, int components);

 private:
  std::span<const std::byte> buffer(std::uint64_t index);
  std::vector<std::byte> read(const std::string& address) const;  // at most what is left of max_bytes
  std::vector<std::byte> read_beside(const std::string& address) const;

  const GltfJson& document_;
  std::span<const std::byte> glb_buffer_;
  const std::filesystem::path& folder_;
  const MeshSoup& soup_;
  std::map<std::uint64_t, std::vector<std::byte>> loaded_;
  std::uint64_t loaded_bytes_ = 0;
};

}  // namespace zonal
