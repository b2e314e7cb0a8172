#include "zonal/view/mesh_file_gltf.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace zonal {
namespace {

constexpr const char* kDamaged = "the glTF file is damaged: export it again";
constexpr std::uint64_t kNone = ~std::uint64_t{0};

/// p -> linear p + shift, columns first.
struct Affine {
  std::array<Vec3, 3> columns = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  Vec3 shift;

  Vec3 linear(Vec3 v) const { return v.x * columns[0] + v.y * columns[1] + v.z * columns[2]; }
  Vec3 point(Vec3 p) const { return linear(p) + shift; }
  /// By the cofactors, which are the inverse's transpose but for its determinant: finite for flat scales too.
  Vec3 normal(Vec3 n) const {
    const auto& [a, b, c] = columns;
    const double sign = dot(a, cross(b, c)) < 0 ? -1 : 1;
    return sign * (n.x * cross(b, c) + n.y * cross(c, a) + n.z * cross(a, b));
  }
};

Affine operator*(const Affine& a, const Affine& b) {
  return {{a.linear(b.columns[0]), a.linear(b.columns[1]), a.linear(b.columns[2])}, a.point(b.shift)};
}

class GltfReader {
 public:
  GltfReader(const GltfJson& document, std::span<const std::byte> glb_buffer, const std::filesystem::path& folder,
             MeshSoup& soup)
      : document_(document), buffers_(document, glb_buffer, folder, soup), soup_(soup) {}

  void read() {
    check_document();
    const GltfJson& scenes = list(document_, "scenes");
    if (scenes.empty()) {  // a library of meshes
      for (std::size_t i = 0; i < list(document_, "meshes").size(); ++i) read_mesh(i, {});
    } else {
      const GltfJson& scene = member("scenes", number(document_, "scene", 0));
      for (const GltfJson& node : list(scene, "nodes")) read_node(index_in(node), {}, 0);
    }
    if (passed_over_ > 0) {
      soup_.notes.push_back(fmt::format("{} groups of points or lines were left out", passed_over_));
    }
  }

 private:
  static constexpr int kDeepest = 64;  // nodes within nodes

  const GltfJson& list(const GltfJson& object, const char* key) const { return gltf_list(soup_, object, key); }
  const GltfJson& member(const char* key, std::uint64_t index) const {
    return gltf_member(soup_, document_, key, index);
  }
  std::uint64_t number(const GltfJson& object, const char* key, std::uint64_t otherwise) const {
    return gltf_number(soup_, object, key, otherwise);
  }
  std::uint64_t index_in(const GltfJson& value) const {
    if (!value.is_number_unsigned()) soup_.fail("a place in a list is no number", kDamaged);
    return value.get<std::uint64_t>();
  }

  void check_document() const {
    const auto asset = document_.find("asset");
    if (asset == document_.end() || !asset->is_object() || !asset->contains("version")) {
      soup_.fail("it is JSON, but no glTF", "OBJ, PLY, glTF and GLB are read");
    }
    const GltfJson& version = asset->at("version");
    if (!version.is_string() || !version.get_ref<const std::string&>().starts_with("2.")) {
      soup_.fail("it is a glTF of another version than 2", "export it as glTF 2.0");
    }
    for (const GltfJson& extension : list(document_, "extensionsRequired")) {
      const std::string name = extension.is_string() ? extension.get<std::string>() : "?";
      const bool geometry = name.find("compression") != name.npos || name == "KHR_mesh_quantization";
      if (geometry)
        soup_.fail(fmt::format("it needs {}, which is not read here", name), "export it without compression");
    }
  }

  /// `count` finite numbers; false where the node has none of this key.
  bool numbers_in(const GltfJson& node, const char* key, std::span<double> into) const {
    const auto found = node.find(key);
    if (found == node.end()) return false;
    if (!found->is_array() || found->size() != into.size()) soup_.fail("the place of a node is broken", kDamaged);
    for (std::size_t i = 0; i < into.size(); ++i) {
      if (!(*found)[i].is_number()) soup_.fail("the place of a node is broken", kDamaged);
      into[i] = (*found)[i].get<double>();
    }
    return true;
  }

  Affine parent_from(const GltfJson& node) const {
    std::array<double, 16> m;
    if (numbers_in(node, "matrix", m)) {
      return {{Vec3{m[0], m[1], m[2]}, Vec3{m[4], m[5], m[6]}, Vec3{m[8], m[9], m[10]}}, {m[12], m[13], m[14]}};
    }
    std::array<double, 3> shift = {}, scale = {1, 1, 1};
    std::array<double, 4> q = {0, 0, 0, 1};
    numbers_in(node, "translation", shift);
    numbers_in(node, "scale", scale);
    numbers_in(node, "rotation", q);
    const auto& [x, y, z, w] = q;
    return {{scale[0] * Vec3{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
             scale[1] * Vec3{2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
             scale[2] * Vec3{2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}},
            {shift[0], shift[1], shift[2]}};
  }

  void read_node(std::uint64_t index, const Affine& world_from_parent, int depth) {
    const GltfJson& node = member("nodes", index);
    // Nodes are a forest: each has one parent. A second visit is a ring, or growth without bound.
    if (!visited_.insert(index).second) soup_.fail(fmt::format("node {} has two parents", index), kDamaged);
    if (depth > kDeepest) soup_.fail("its nodes are nested too deeply", "export it as one mesh");
    const Affine world_from_node = world_from_parent * parent_from(node);
    const std::uint64_t mesh = number(node, "mesh", kNone);
    if (mesh != kNone) read_mesh(mesh, world_from_node);
    for (const GltfJson& child : list(node, "children")) read_node(index_in(child), world_from_node, depth + 1);
  }

  void read_mesh(std::uint64_t index, const Affine& world_from_node) {
    for (const GltfJson& primitive : list(member("meshes", index), "primitives")) {
      if (!primitive.is_object()) soup_.fail("a mesh is broken", kDamaged);
      const std::uint64_t mode = number(primitive, "mode", kTriangles);
      if (mode < kTriangles) {
        ++passed_over_;
      } else {
        read_primitive(primitive, mode, world_from_node);
      }
    }
  }

  static constexpr std::uint64_t kTriangles = 4, kStrip = 5, kFan = 6;

  void read_primitive(const GltfJson& primitive, std::uint64_t mode, const Affine& world_from_node) {
    if (mode > kFan) soup_.fail(fmt::format("there is no mode {} of drawing", mode), kDamaged);
    const auto attributes = primitive.find("attributes");
    if (attributes == primitive.end() || !attributes->is_object()) soup_.fail("a mesh has no attributes", kDamaged);
    const std::uint64_t at = number(*attributes, "POSITION", kNone), normal = number(*attributes, "NORMAL", kNone),
                        uv = number(*attributes, "TEXCOORD_0", kNone);
    if (at == kNone) soup_.fail("a mesh has no positions", kDamaged);
    const MeshCorner first = {static_cast<std::int32_t>(soup_.positions.size()),
                              normal == kNone ? -1 : static_cast<std::int32_t>(soup_.normals.size()),
                              uv == kNone ? -1 : static_cast<std::int32_t>(soup_.uvs.size())};
    const GltfNumbers positions = buffers_.numbers(at, 3);
    const std::size_t count = positions.count();
    soup_.check_count(soup_.positions.size() + count);
    for (std::size_t i = 0; i < count; ++i) {
      soup_.positions.push_back(world_from_node.point({positions(i, 0), positions(i, 1), positions(i, 2)}));
    }
    if (normal != kNone) {
      const GltfNumbers normals = numbers_for(count, normal, 3);
      for (std::size_t i = 0; i < count; ++i) {
        soup_.normals.push_back(world_from_node.normal({normals(i, 0), normals(i, 1), normals(i, 2)}));
      }
    }
    if (uv != kNone) {
      const GltfNumbers uvs = numbers_for(count, uv, 2);
      for (std::size_t i = 0; i < count; ++i) soup_.uvs.push_back({uvs(i, 0), uvs(i, 1)});
    }
    add_triangles(primitive, mode, first, count);
  }

  /// Every attribute has a member for each vertex.
  GltfNumbers numbers_for(std::size_t count, std::uint64_t accessor, int components) {
    const GltfNumbers numbers = buffers_.numbers(accessor, components);
    if (numbers.count() != count) soup_.fail("the attributes of a mesh differ in length", kDamaged);
    return numbers;
  }

  void add_triangles(const GltfJson& primitive, std::uint64_t mode, const MeshCorner& first, std::size_t vertices) {
    const std::uint64_t accessor = number(primitive, "indices", kNone);
    const GltfNumbers indices = accessor == kNone ? GltfNumbers() : buffers_.numbers(accessor, 1);
    const std::size_t count = accessor == kNone ? vertices : indices.count();
    const auto corner = [&](std::size_t i) {
      const double index = accessor == kNone ? static_cast<double>(i) : indices(i);
      if (!(index < static_cast<double>(vertices))) {
        soup_.fail(fmt::format("a face names vertex {} of {}", index, vertices), kDamaged);
      }
      const auto place = static_cast<std::int32_t>(index);
      return MeshCorner{first.position + place, first.normal < 0 ? -1 : first.normal + place,
                        first.uv < 0 ? -1 : first.uv + place};
    };
    const std::size_t step = mode == kTriangles ? 3 : 1;
    for (std::size_t i = 0; i + 2 < count; i += step) {
      const bool odd = mode == kStrip && i % 2 == 1;  // every other triangle of a strip is wound the other way
      const std::array<MeshCorner, 3> triangle = {corner(mode == kFan ? 0 : i), corner(odd ? i + 2 : i + 1),
                                                  corner(odd ? i + 1 : i + 2)};
      soup_.add_polygon(triangle);
    }
  }

  const GltfJson& document_;
  GltfBuffers buffers_;
  MeshSoup& soup_;
  std::set<std::uint64_t> visited_;
  int passed_over_ = 0;
};

/// The parts of a GLB (glTF 2.0, 4.4).
struct GlbParts {
  std::span<const std::byte> json, buffer;
};

std::uint32_t word_at(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 4; i-- > 0;) word = word << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
  return word;
}

GlbParts glb_parts(std::span<const std::byte> file, const MeshSoup& soup) {
  constexpr std::size_t kHeader = 12, kChunkHeader = 8;
  constexpr std::uint32_t kJson = 0x4e4f534a, kBinary = 0x004e4942;
  const auto fail_early = [&] { soup.fail("it ends early", kDamaged); };
  if (file.size() < kHeader + kChunkHeader) fail_early();
  if (word_at(file, 4) != 2) soup.fail("it is a GLB of another version than 2", "export it as glTF 2.0");
  if (word_at(file, 8) > file.size()) fail_early();
  file = file.subspan(kHeader);
  GlbParts parts;
  while (file.size() >= kChunkHeader) {
    const std::size_t size = word_at(file, 0);
    const std::uint32_t kind = word_at(file, 4);
    file = file.subspan(kChunkHeader);
    if (size > file.size()) fail_early();
    if (kind == kJson && parts.json.empty()) parts.json = file.first(size);
    if (kind == kBinary && parts.buffer.empty()) parts.buffer = file.first(size);
    file = file.subspan(size);
  }
  if (parts.json.empty()) soup.fail("it has no scene", kDamaged);
  return parts;
}

}  // namespace

std::uint64_t gltf_number(const MeshSoup& soup, const GltfJson& object, const char* key, std::uint64_t otherwise) {
  const auto found = object.find(key);
  if (found == object.end()) return otherwise;
  if (!found->is_number_unsigned()) soup.fail(fmt::format("its '{}' is no whole number", key), kDamaged);
  return found->get<std::uint64_t>();
}

const GltfJson& gltf_list(const MeshSoup& soup, const GltfJson& object, const char* key) {
  static const GltfJson kEmpty = GltfJson::array();
  const auto found = object.find(key);
  if (found == object.end()) return kEmpty;
  if (!found->is_array()) soup.fail(fmt::format("its '{}' is no list", key), kDamaged);
  return *found;
}

const GltfJson& gltf_member(const MeshSoup& soup, const GltfJson& document, const char* key, std::uint64_t index) {
  const GltfJson& list = gltf_list(soup, document, key);
  if (index >= list.size() || !list[index].is_object()) {
    soup.fail(fmt::format("it names a member of '{}' that is not there", key), kDamaged);
  }
  return list[index];
}

void read_gltf(std::span<const std::byte> file, const std::filesystem::path& folder, MeshSoup& soup) {
  constexpr std::size_t kLongestJson = std::size_t{1} << 26;  // its tree takes many times as much
  const std::string_view start(reinterpret_cast<const char*>(file.data()), std::min<std::size_t>(file.size(), 4));
  GlbParts parts{file, {}};
  if (start == "glTF") parts = glb_parts(file, soup);
  if (parts.json.size() > kLongestJson) soup.fail("its description is too long", "export it as one file (.glb)");
  const auto* text = reinterpret_cast<const char*>(parts.json.data());
  const GltfJson document = GltfJson::parse(text, text + parts.json.size(), nullptr, false);
  if (!document.is_object()) soup.fail("its description is no JSON", kDamaged);
  soup.y_up = true;
  GltfReader(document, parts.buffer, folder, soup).read();
}

}  // namespace zonal
