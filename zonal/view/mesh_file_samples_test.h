#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>

#include "zonal/io/base64.h"
#include "zonal/math/vec.h"

namespace zonal {

/// A file as long as it is needed, in a folder of its own.
class MeshSample {
 public:
  MeshSample(const std::string& name, const std::string& content) {
    static int number = 0;
    folder_ = std::filesystem::temp_directory_path() / fmt::format("zonal_mesh_{}_{}", ::getpid(), number++);
    std::filesystem::create_directories(folder_);
    path_ = folder_ / name;
    add(name, content);
  }
  ~MeshSample() { std::filesystem::remove_all(folder_); }
  MeshSample(const MeshSample&) = delete;
  MeshSample& operator=(const MeshSample&) = delete;

  /// Another file beside it.
  void add(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
  }
  operator const std::filesystem::path&() const { return path_; }

 private:
  std::filesystem::path folder_, path_;
};

/// The sides of a box by its corners, whose bits are +x, +y, +z; counterclockwise from outside.
inline constexpr std::array<std::array<int, 4>, 6> kBoxSides = {
    {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}}};

inline Vec3 box_corner(int i, Vec3 size) {
  return {(i & 1 ? 0.5 : -0.5) * size.x, (i & 2 ? 0.5 : -0.5) * size.y, (i & 4 ? 0.5 : -0.5) * size.z};
}

inline std::string box_obj(Vec3 center, Vec3 size) {
  std::string text = "# a box\nmtllib /etc/passwd\n";
  for (int i = 0; i < 8; ++i) {
    const Vec3 p = center + box_corner(i, size);
    text += fmt::format("v {:f} {:e} +{}\r\n", p.x, p.y, p.z + 100);
  }
  for (const auto& side : kBoxSides) {
    text += "f";
    for (const int i : side) text += fmt::format(" {}{}", i + 1, i == 0 ? "//" : "");
    text += "\n";
  }
  return text;
}

template <class T>
void append_number(std::string& bytes, T value, bool big_endian = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (big_endian) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

// Boxes of 2 x 6 x 4.

inline std::string box_ply_text() {
  std::string text =
      "ply\nformat ascii 1.0\ncomment a box\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
      "property list uchar float weights\nelement edge 1\nproperty int a\nelement face 6\n"
      "property list uchar int vertex_indices\nend_header\n";
  for (int i = 0; i < 8; ++i) {
    const Vec3 p = box_corner(i, {2, 6, 4});
    text += fmt::format("{:.6f} {:.6f} {:.6f} 2 0.5 0.5\n", p.x, p.y, p.z);
  }
  text += "7\n";
  for (const auto& side : kBoxSides) {
    text += "4";
    for (const int i : side) text += fmt::format(" {}", i);
    text += "\n";
  }
  return text;
}

inline std::string box_ply_binary(bool big) {
  std::string bytes =
      std::string("ply\nformat ") + (big ? "binary_big_endian" : "binary_little_endian") +
      " 1.0\nelement vertex 8\nproperty double x\nproperty float y\nproperty int16 z\nproperty uchar red\n"
      "element face 6\nproperty list uint16 uint32 vertex_index\nend_header\n";
  for (int i = 0; i < 8; ++i) {
    const Vec3 p = box_corner(i, {2, 6, 4});
    append_number(bytes, p.x, big);
    append_number(bytes, static_cast<float>(p.y), big);
    append_number(bytes, static_cast<std::int16_t>(p.z), big);
    append_number(bytes, std::uint8_t{200});
  }
  for (const auto& side : kBoxSides) {
    append_number(bytes, std::uint16_t{4}, big);
    for (const int i : side) append_number(bytes, static_cast<std::uint32_t>(i), big);
  }
  return bytes;
}

/// Half of the size in the buffer; the node doubles it.
inline std::string box_buffer() {
  std::string bytes;
  for (int i = 0; i < 8; ++i) {
    const Vec3 p = box_corner(i, {1, 3, 2});
    for (const double x : {p.x, p.y, p.z}) append_number(bytes, static_cast<float>(x));
  }
  for (const auto& side : kBoxSides) {
    for (const int k : {0, 1, 2, 0, 2, 3}) append_number(bytes, static_cast<std::uint16_t>(side[k]));
  }
  return bytes;  // 96 + 72
}

/// BUFFER stands for what says where the buffer is.
inline constexpr const char* kBoxGltf = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"children":[1],"translation":[1,2,3]},{"mesh":0,"scale":[2,2,2],"rotation":[0,0,0,1]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0},{"mode":1,"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3"},
{"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":72}],
"buffers":[{BUFFER"byteLength":168}]})";

inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  return at == std::string::npos ? "" : text.replace(at, what.size(), by);  // an empty sample fails its test
}

inline std::string box_glb(const std::string& document) {
  std::string json = document.find("BUFFER") == std::string::npos ? document : replaced(document, "BUFFER", "");
  while (json.size() % 4 != 0) json += ' ';
  std::string bytes = "glTF";
  const std::string buffer = box_buffer();
  append_number(bytes, std::uint32_t{2});
  append_number(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + buffer.size()));
  append_number(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  append_number(bytes, static_cast<std::uint32_t>(buffer.size()));
  return bytes + std::string("BIN\0", 4) + buffer;
}

inline std::string box_gltf_with_data() {
  const std::string buffer = box_buffer();
  const std::string base64 = base64_text(std::as_bytes(std::span(buffer)));
  return replaced(kBoxGltf, "BUFFER", fmt::format(R"("uri":"data:application/octet-stream;base64,{}",)", base64));
}

}  // namespace zonal
