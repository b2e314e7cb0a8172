#include "zonal/view/mesh_file_soup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "zonal/base/error.h"

namespace zonal {
namespace {

bool is_finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// The unit vector of one whose square may overflow or vanish; zero where it is zero.
Vec3 unit(Vec3 v) {
  const double greatest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (greatest == 0) return {};
  return normalize((1 / greatest) * v);
}

/// The front of a Y-up model, +Z, comes to look at the eye's first place, -X.
Vec3 world_from_y_up(Vec3 v) { return {-v.z, -v.x, v.y}; }

/// Every place that a triangle names is in its list, and what is there is a number.
void check_corners(const MeshSoup& soup) {
  const auto check_place = [&](const char* what, std::int32_t place, std::size_t count, std::size_t triangle) {
    if (place >= 0 && static_cast<std::size_t>(place) < count) return;
    soup.fail(fmt::format("face {} names {} {} of {}", triangle, what, place, count),
              "the file is damaged, or it was cut off: export it again");
  };
  const auto check_finite = [&](const char* what, bool finite, std::int32_t place) {
    if (!finite) soup.fail(fmt::format("{} {} is not finite", what, place), "export the mesh again");
  };
  std::size_t index = 0;
  for (const auto& triangle : soup.triangles()) {
    for (const MeshCorner& corner : triangle) {
      check_place("vertex", corner.position, soup.positions.size(), index);
      check_finite("vertex", is_finite(soup.positions[corner.position]), corner.position);
      if (corner.normal >= 0) {
        check_place("normal", corner.normal, soup.normals.size(), index);
        check_finite("normal", is_finite(soup.normals[corner.normal]), corner.normal);
      }
      if (corner.uv >= 0) {
        check_place("texture coordinate", corner.uv, soup.uvs.size(), index);
        const auto& [u, v] = soup.uvs[corner.uv];
        check_finite("texture coordinate", std::isfinite(u) && std::isfinite(v), corner.uv);
      }
    }
    ++index;
  }
}

/// Into the unit ball. Halves first: the ends of the greatest box are farther apart than a double reaches.
void fit_unit_ball(MeshSoup& soup) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Vec3 low = {kInfinity, kInfinity, kInfinity}, high = -low;
  for (const auto& triangle : soup.triangles()) {
    for (const MeshCorner& corner : triangle) {
      const Vec3 p = soup.positions[corner.position];
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  const Vec3 middle = 0.5 * low + 0.5 * high, half = 0.5 * high - 0.5 * low;
  const double extent = std::max({half.x, half.y, half.z});
  if (!(extent > 0)) soup.fail("all its corners are at one place", "export the mesh again");
  double farthest = 0;
  for (const auto& triangle : soup.triangles()) {
    for (const MeshCorner& corner : triangle) {
      const Vec3 p = soup.positions[corner.position];
      const Vec3 q = {(p.x - middle.x) / extent, (p.y - middle.y) / extent, (p.z - middle.z) / extent};
      farthest = std::max(farthest, length(q));
    }
  }
  for (Vec3& p : soup.positions) {
    p = {(p.x - middle.x) / extent / farthest, (p.y - middle.y) / extent / farthest,
         (p.z - middle.z) / extent / farthest};
  }
}

/// Corners at one place of space, whatever their numbers in the file: equal numbers for equal places.
std::vector<std::int32_t> places_in_space(const MeshSoup& soup) {
  struct Hash {
    std::size_t operator()(const std::array<double, 3>& p) const {
      const std::hash<double> hash;
      return (hash(p[0]) * 31 + hash(p[1])) * 31 + hash(p[2]);
    }
  };
  std::unordered_map<std::array<double, 3>, std::int32_t, Hash> first;
  std::vector<std::int32_t> places;
  places.reserve(soup.positions.size());
  for (const Vec3& p : soup.positions) {
    const auto next = static_cast<std::int32_t>(first.size());
    // Unused ones may be no numbers, which equal nothing: they share a place that nobody asks for.
    places.push_back(is_finite(p) ? first.try_emplace({p.x, p.y, p.z}, next).first->second : 0);
  }
  return places;
}

class MeshMaker {
 public:
  explicit MeshMaker(const MeshSoup& soup) : soup_(soup) {
    for (const auto& triangle : soup_.triangles()) add_face_normal(triangle);
    for (const auto& triangle : soup_.triangles()) add_triangle(triangle);
  }

  Mesh mesh;
  std::int64_t without_area = 0, normals_made = 0, uvs_made = 0;

 private:
  /// In the unit ball, twice the area; coordinates as floats are known to 1e-7 of it at best.
  static constexpr double kSmallestArea = 1e-12;

  Vec3 at(const MeshCorner& corner) const { return soup_.positions[corner.position]; }
  Vec3 face_normal(const std::array<MeshCorner, 3>& t) const { return cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0])); }
  bool has_area(const std::array<MeshCorner, 3>& t) const { return length(face_normal(t)) > kSmallestArea; }
  bool lacks_normal(const MeshCorner& corner) const {
    return corner.normal < 0 || soup_.normals[corner.normal] == Vec3{};
  }

  void add_face_normal(const std::array<MeshCorner, 3>& t) {
    if (!has_area(t) || std::ranges::none_of(t, [&](const MeshCorner& c) { return lacks_normal(c); })) return;
    if (places_.empty()) {
      places_ = places_in_space(soup_);
      made_normals_.resize(places_.size());
    }
    const Vec3 n = unit(face_normal(t));
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 here = at(t[i]);
      const double angle = angle_between(unit(at(t[(i + 1) % 3]) - here), unit(at(t[(i + 2) % 3]) - here));
      made_normals_[places_[t[i].position]] += angle * n;
    }
  }

  Vec3 normal(const MeshCorner& corner) const {
    if (!lacks_normal(corner)) return unit(soup_.normals[corner.normal]);
    const Vec3 made = unit(made_normals_[places_[corner.position]]);
    return made == Vec3{} ? Vec3{0, 0, 1} : made;  // faces back to back
  }

  std::array<double, 2> longitude_colatitude(Vec3 p) const {
    const double radius = length(p);
    if (radius == 0) return {0.5, 0.5};
    const double turn = p.x == 0 && p.y == 0 ? 0 : std::atan2(p.y, p.x) / (2 * kPi);
    return {0.5 - turn, std::acos(std::clamp(p.z / radius, -1.0, 1.0)) / kPi};
  }

  void add_triangle(const std::array<MeshCorner, 3>& t) {
    soup_.check_stop();
    if (!has_area(t)) {
      ++without_area;
      return;
    }
    const bool lacks_uv = std::ranges::any_of(t, [](const MeshCorner& c) { return c.uv < 0; });
    double least = 1, greatest = 0;
    for (const MeshCorner& corner : t) {
      const double u = longitude_colatitude(at(corner))[0];
      least = std::min(least, u), greatest = std::max(greatest, u);
    }
    const bool across_seam = greatest - least > 0.5;
    for (const MeshCorner& corner : t) {
      Vertex vertex;
      const Vec3 p = at(corner), n = normal(corner);
      std::array<double, 2> uv = lacks_uv ? longitude_colatitude(p) : soup_.uvs[corner.uv];
      const bool shifted = lacks_uv && across_seam && uv[0] < 0.5;
      if (shifted) uv[0] += 1;
      const auto f = [](double x) { return static_cast<float>(x); };
      vertex = {{f(p.x), f(p.y), f(p.z)}, {f(n.x), f(n.y), f(n.z)}, {f(uv[0]), f(uv[1])}};
      add_vertex(
          {corner.position, lacks_normal(corner) ? -1 : corner.normal, lacks_uv ? (shifted ? -2 : -1) : corner.uv},
          vertex);
    }
    if (lacks_uv) ++uvs_made;
    if (std::ranges::any_of(t, [&](const MeshCorner& c) { return lacks_normal(c); })) ++normals_made;
  }

  void add_vertex(const MeshCorner& key, const Vertex& vertex) {
    const auto next = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto [found, is_new] = known_.try_emplace({key.position, key.normal, key.uv}, next);
    if (is_new) mesh.vertices.push_back(vertex);
    mesh.indices.push_back(found->second);
  }

  struct Hash {
    std::size_t operator()(const std::array<std::int32_t, 3>& key) const {
      std::uint64_t hash = 0;
      for (const std::int32_t x : key) hash = (hash ^ static_cast<std::uint32_t>(x)) * 0x9e3779b97f4a7c15u;
      return hash ^ (hash >> 32);
    }
  };

  const MeshSoup& soup_;
  std::vector<std::int32_t> places_;
  std::vector<Vec3> made_normals_;  // by place in space
  std::unordered_map<std::array<std::int32_t, 3>, std::uint32_t, Hash> known_;
};

}  // namespace

void MeshSoup::add_polygon(std::span<const MeshCorner> corners) {
  check_stop();
  if (corners.size() < 3) return;
  if (corners.size() - 2 > static_cast<std::size_t>(options_.max_triangles) - triangles_.size()) {
    fail(fmt::format("it has more than {} triangles", options_.max_triangles), "simplify the mesh");
  }
  for (std::size_t i = 2; i < corners.size(); ++i) triangles_.push_back({corners[0], corners[i - 1], corners[i]});
}

void MeshSoup::check_count(std::uint64_t vertices) const {
  // Of triangles that share nothing, three times as many; of closed meshes, half as many.
  if (vertices > 3 * static_cast<std::uint64_t>(options_.max_triangles)) {
    fail(fmt::format("it has {} vertices", vertices), "simplify the mesh");
  }
}

void MeshSoup::fail(const std::string& what, const std::string& hint) const {
  throw Error(ErrorKind::kInput, name_ + ": " + what, hint);
}

void MeshSoup::check_stop() const {
  if (run_.stop.stop_requested()) throw Error(ErrorKind::kCancelled, "cancelled");
}

Mesh mesh_of_soup(MeshSoup& soup) {
  if (soup.triangles().empty()) soup.fail("it has no faces", "a cloud of points or lines cannot be lit");
  check_corners(soup);
  fit_unit_ball(soup);
  const MeshUp up = soup.options().up;
  if (up == MeshUp::kY || (up == MeshUp::kFormat && soup.y_up)) {
    std::ranges::transform(soup.positions, soup.positions.begin(), world_from_y_up);
    std::ranges::transform(soup.normals, soup.normals.begin(), world_from_y_up);
    soup.notes.push_back("its Y axis was taken for up");
  }
  MeshMaker maker(soup);
  if (maker.mesh.indices.empty()) soup.fail("none of its faces has an area", "export the mesh again");
  const auto note = [&](std::int64_t count, const char* what) {
    if (count > 0) soup.notes.push_back(fmt::format("{} of {} faces {}", count, soup.triangles().size(), what));
  };
  note(maker.without_area, "have no area and were left out");
  note(maker.normals_made, "had no normals; they were made from the faces around");
  note(maker.uvs_made, "had no texture coordinates; they got longitude and latitude");
  return std::move(maker.mesh);
}

}  // namespace zonal
