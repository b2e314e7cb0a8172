#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "zonal/view/mesh_file_soup.h"
#include "zonal/view/mesh_file_text.h"

namespace zonal {
namespace {

/// Wavefront's lines: v, vt, vn and f; the others (groups, materials, lines, curves) say nothing about triangles.
class ObjReader {
 public:
  explicit ObjReader(MeshSoup& soup) : soup_(soup) {}

  void read(std::string_view text) {
    while (!text.empty()) {
      std::string_view line = whole_line(text);
      const std::string_view word = next_word(line, kBlanks);
      if (word == "v") {
        soup_.positions.push_back(vector_in(line));
        soup_.check_count(soup_.positions.size());
      } else if (word == "vn") {
        soup_.normals.push_back(vector_in(line));
      } else if (word == "vt") {
        const double u = number_in(line), v = line.find_first_not_of(kBlanks) == line.npos ? 0 : number_in(line);
        soup_.uvs.push_back({u, 1 - v});
      } else if (word == "f") {
        read_face(line);
      } else if (!word.empty() && static_cast<unsigned char>(word[0]) < ' ') {
        fail("is no text");
      }
    }
    if (soup_.triangles().empty()) {
      soup_.fail("there is no face in it", "OBJ, PLY, glTF and GLB are read; is it one of them?");
    }
  }

 private:
  static constexpr std::string_view kBlanks = " \t";

  /// Lines that end with a backslash go on in the next one. A comment ends with its line.
  std::string_view whole_line(std::string_view& text) {
    ++line_number_;
    std::string_view line = next_line(text);
    if (line.starts_with('#') || !line.ends_with('\\')) return line;
    joined_.clear();
    while (line.ends_with('\\')) {
      joined_.append(line.substr(0, line.size() - 1)).append(" ");
      ++line_number_;
      line = next_line(text);
    }
    joined_.append(line);
    return joined_;
  }

  double number_in(std::string_view& line) {
    const std::string_view word = next_word(line, kBlanks);
    const std::optional<double> number = word_number<double>(word);
    if (!number) fail(fmt::format("has '{}' for a number", word.substr(0, 40)));
    return *number;
  }

  Vec3 vector_in(std::string_view& line) {
    const double x = number_in(line), y = number_in(line), z = number_in(line);
    return {x, y, z};
  }

  /// Counted from 1, or backwards from the last one that was read.
  std::int32_t place_in(std::string_view word, std::size_t count) {
    const std::optional<std::int64_t> number = word_number<std::int64_t>(word);
    if (!number || *number == 0) fail(fmt::format("has '{}' for a place in a list", word.substr(0, 40)));
    const double place =
        *number > 0 ? static_cast<double>(*number) - 1 : static_cast<double>(count) + static_cast<double>(*number);
    if (!(place >= 0)) fail(fmt::format("names place {} of {}", *number, count));
    return mesh_place(place);
  }

  void read_face(std::string_view line) {
    corners_.clear();
    for (std::string_view word; !(word = next_word(line, kBlanks)).empty() && !word.starts_with('#');) {
      MeshCorner corner;
      for (int part = 0; part < 3; ++part) {
        const std::string_view number = word.substr(0, word.find('/'));
        word.remove_prefix(std::min(number.size() + 1, word.size()));
        if (part == 0) corner.position = place_in(number, soup_.positions.size());
        if (part == 1 && !number.empty()) corner.uv = place_in(number, soup_.uvs.size());
        if (part == 2 && !number.empty()) corner.normal = place_in(number, soup_.normals.size());
      }
      corners_.push_back(corner);
    }
    if (corners_.size() < 3) fail("has a face of fewer than three corners");
    soup_.add_polygon(corners_);
  }

  [[noreturn]] void fail(const std::string& what) const {
    soup_.fail(fmt::format("line {} {}", line_number_, what), "OBJ, PLY, glTF and GLB are read; is it damaged?");
  }

  MeshSoup& soup_;
  std::int64_t line_number_ = 0;
  std::string joined_;
  std::vector<MeshCorner> corners_;
};

}  // namespace

void read_obj(std::string_view text, MeshSoup& soup) {
  soup.y_up = true;
  ObjReader(soup).read(text);
}

}  // namespace zonal
