#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>

#include "zonal/view/mesh_file_soup.h"
#include "zonal/view/mesh_file_text.h"

namespace zonal {
namespace {

enum class PlyFormat { kText, kLittleEndian, kBigEndian };
enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

constexpr std::array<std::size_t, 8> kBytes = {1, 1, 2, 2, 4, 4, 4, 8};
constexpr std::array<std::array<std::string_view, 2>, 8> kTypeNames = {{{"char", "int8"},
                                                                        {"uchar", "uint8"},
                                                                        {"short", "int16"},
                                                                        {"ushort", "uint16"},
                                                                        {"int", "int32"},
                                                                        {"uint", "uint32"},
                                                                        {"float", "float32"},
                                                                        {"double", "float64"}}};

std::size_t bytes_of(PlyType type) { return kBytes[static_cast<std::size_t>(type)]; }

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kFloat32;
  std::optional<PlyType> count;  // of a list: the type of its length
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// The fewest bytes that one of them takes: a digit and a blank for a number, no member in a list.
  std::uint64_t least_bytes(PlyFormat format) const {
    std::uint64_t sum = 0;
    for (const PlyProperty& p : properties) {
      sum += format == PlyFormat::kText ? 2 : bytes_of(p.count.value_or(p.type));
    }
    return sum;
  }
  /// Where a property of one of these names is; -1: nowhere.
  int find(std::initializer_list<std::string_view> names) const {
    for (std::size_t i = 0; i < properties.size(); ++i) {
      if (std::ranges::find(names, properties[i].name) != names.end()) return static_cast<int>(i);
    }
    return -1;
  }
};

struct PlyHeader {
  PlyFormat format = PlyFormat::kText;
  std::vector<PlyElement> elements;
};

class PlyHeaderReader {
 public:
  PlyHeaderReader(std::string_view& text, const MeshSoup& soup) : text_(text), soup_(soup) {}

  PlyHeader read() {
    PlyHeader header;
    bool formatted = false;
    for (int lines = 0;; ++lines) {
      if (text_.empty() || lines > 1000) fail("its header has no end");
      std::string_view line = next_line(text_);
      const std::string_view word = next_word(line);
      if (word == "end_header") break;
      if (word == "format") {
        header.format = format_of(next_word(line));
        formatted = true;
      } else if (word == "element") {
        header.elements.push_back(element_in(line));
      } else if (word == "property") {
        if (header.elements.empty()) fail("a property comes before any element");
        header.elements.back().properties.push_back(property_in(line));
      } else if (word != "ply" && word != "comment" && word != "obj_info" && !word.empty()) {
        fail(fmt::format("its header has a line '{} ...'", word.substr(0, 40)));
      }
    }
    if (!formatted) fail("its header names no format");
    return header;
  }

 private:
  PlyFormat format_of(std::string_view word) const {
    if (word == "ascii") return PlyFormat::kText;
    if (word == "binary_little_endian") return PlyFormat::kLittleEndian;
    if (word != "binary_big_endian") fail(fmt::format("there is no format '{}'", word.substr(0, 40)));
    return PlyFormat::kBigEndian;
  }

  PlyElement element_in(std::string_view line) const {
    PlyElement element{std::string(next_word(line)), 0, {}};
    const std::optional<std::uint64_t> count = word_number<std::uint64_t>(next_word(line));
    if (!count) fail("the number of an element is not one");
    element.count = *count;
    return element;
  }

  PlyType type_of(std::string_view word) const {
    for (std::size_t i = 0; i < kTypeNames.size(); ++i) {
      if (std::ranges::find(kTypeNames[i], word) != kTypeNames[i].end()) return static_cast<PlyType>(i);
    }
    fail(fmt::format("there is no type '{}'", word.substr(0, 40)));
  }

  PlyProperty property_in(std::string_view line) const {
    PlyProperty property;
    std::string_view word = next_word(line);
    if (word == "list") {
      property.count = type_of(next_word(line));
      if (*property.count >= PlyType::kFloat32) fail("the length of a list is no whole number");
      word = next_word(line);
    }
    property.type = type_of(word);
    property.name = next_word(line);
    return property;
  }

  [[noreturn]] void fail(const std::string& what) const {
    soup_.fail(what, "the PLY file is damaged: export it again");
  }

  std::string_view& text_;
  const MeshSoup& soup_;
};

/// The numbers after the header, one after another.
class PlyBody {
 public:
  PlyBody(std::string_view bytes, PlyFormat format, const MeshSoup& soup)
      : bytes_(bytes), format_(format), soup_(soup) {}

  std::uint64_t remaining() const { return bytes_.size(); }

  double next(PlyType type) {
    if (format_ != PlyFormat::kText) return next_binary(type);
    const std::string_view word = next_word(bytes_);
    if (word.empty()) fail_early_end();
    const std::optional<double> number = word_number<double>(word);
    if (!number) soup_.fail(fmt::format("it has '{}' for a number", word.substr(0, 40)), "export it again");
    return *number;
  }

  /// The length of a list whose members are still to come.
  std::size_t next_length(const PlyProperty& list) {
    const double length = next(*list.count);
    const double least = format_ == PlyFormat::kText ? 1.0 : static_cast<double>(bytes_of(list.type));
    if (!(length >= 0) || length * least > static_cast<double>(remaining())) fail_early_end();
    return static_cast<std::size_t>(length);
  }

  [[noreturn]] void fail_early_end() const {
    soup_.fail("it ends early", "the file may be damaged: copy, download or export it again");
  }

 private:
  double next_binary(PlyType type) {
    const std::size_t size = bytes_of(type);
    if (bytes_.size() < size) fail_early_end();
    std::array<char, 8> raw = {};
    std::copy_n(bytes_.begin(), size, raw.begin());
    bytes_.remove_prefix(size);
    const bool machine_order = (format_ == PlyFormat::kLittleEndian) == (std::endian::native == std::endian::little);
    if (!machine_order) std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(size));
    switch (type) {
      case PlyType::kInt8:
        return as<std::int8_t>(raw);
      case PlyType::kUint8:
        return as<std::uint8_t>(raw);
      case PlyType::kInt16:
        return as<std::int16_t>(raw);
      case PlyType::kUint16:
        return as<std::uint16_t>(raw);
      case PlyType::kInt32:
        return as<std::int32_t>(raw);
      case PlyType::kUint32:
        return as<std::uint32_t>(raw);
      case PlyType::kFloat32:
        return as<float>(raw);
      case PlyType::kFloat64:
        break;
    }
    return as<double>(raw);
  }

  template <class T>
  static double as(const std::array<char, 8>& raw) {
    T value;
    std::memcpy(&value, raw.data(), sizeof(T));
    return static_cast<double>(value);
  }

  std::string_view bytes_;
  PlyFormat format_;
  const MeshSoup& soup_;
};

class PlyReader {
 public:
  PlyReader(const PlyHeader& header, PlyBody body, MeshSoup& soup) : header_(header), body_(body), soup_(soup) {}

  void read() {
    for (const PlyElement& element : header_.elements) {
      const std::uint64_t least = element.least_bytes(header_.format);
      // The last number of a text needs no blank behind it.
      if (element.count > 0 && (least == 0 || element.count > (body_.remaining() + 1) / least)) body_.fail_early_end();
      if (element.name == "vertex") {
        read_vertices(element);
      } else {
        read_faces(element, element.name == "face" ? element.find({"vertex_indices", "vertex_index"}) : -1);
      }
    }
  }

 private:
  void read_vertices(const PlyElement& element) {
    soup_.check_count(element.count);
    const int x = element.find({"x"}), y = element.find({"y"}), z = element.find({"z"});
    const int nx = element.find({"nx"}), ny = element.find({"ny"}), nz = element.find({"nz"});
    const int u = element.find({"u", "s", "texture_u"}), v = element.find({"v", "t", "texture_v"});
    if (x < 0 || y < 0 || z < 0) soup_.fail("its vertices have no x, y and z", "export it again");
    has_normals_ = nx >= 0 && ny >= 0 && nz >= 0;
    has_uvs_ = u >= 0 && v >= 0;
    std::vector<double> row(element.properties.size());
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (std::size_t k = 0; k < row.size(); ++k) row[k] = next(element.properties[k]);
      soup_.positions.push_back({row[x], row[y], row[z]});
      if (has_normals_) soup_.normals.push_back({row[nx], row[ny], row[nz]});
      if (has_uvs_) soup_.uvs.push_back({row[u], 1 - row[v]});
    }
    soup_.check_stop();
  }

  /// A number; of a list, which a vertex has no use for, its length.
  double next(const PlyProperty& property) {
    if (!property.count) return body_.next(property.type);
    const std::size_t length = body_.next_length(property);
    for (std::size_t i = 0; i < length; ++i) body_.next(property.type);
    return static_cast<double>(length);
  }

  /// `corners_at` is the list of corners; -1: an element that is only passed over.
  void read_faces(const PlyElement& element, int corners_at) {
    if (corners_at >= 0 && !element.properties[corners_at].count)
      soup_.fail("its faces are no lists", "export it again");
    std::vector<MeshCorner> corners;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (int k = 0; k < static_cast<int>(element.properties.size()); ++k) {
        const PlyProperty& property = element.properties[k];
        if (k != corners_at) {
          next(property);
          continue;
        }
        corners.resize(body_.next_length(property));
        for (MeshCorner& corner : corners) {
          const std::int32_t place = mesh_place(body_.next(property.type));
          corner = {place, has_normals_ ? place : -1, has_uvs_ ? place : -1};
        }
      }
      if (corners_at >= 0) soup_.add_polygon(corners);
    }
  }

  const PlyHeader& header_;
  PlyBody body_;
  MeshSoup& soup_;
  bool has_normals_ = false, has_uvs_ = false;
};

}  // namespace

void read_ply(std::span<const std::byte> file, MeshSoup& soup) {
  std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  PlyHeader header = PlyHeaderReader(text, soup).read();
  const auto is_vertex = [](const PlyElement& element) { return element.name == "vertex"; };
  if (std::ranges::count_if(header.elements, is_vertex) > 1)
    soup.fail("it has two lists of vertices", "export it again");
  PlyReader(header, PlyBody(text, header.format, soup), soup).read();
}

}  // namespace zonal
