#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>

namespace zonal {

inline constexpr double kPi = std::numbers::pi;

/// A vector of the world frame: right-handed, +Z up, +X the centre of a panorama. Directions are unit vectors.
struct Vec3 {
  double x = 0, y = 0, z = 0;
  bool operator==(const Vec3&) const = default;
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr Vec3 operator*(Vec3 a, double s) { return s * a; }
constexpr Vec3& operator+=(Vec3& a, Vec3 b) { return a = a + b; }
constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double length(Vec3 a) { return std::sqrt(dot(a, a)); }
inline Vec3 normalize(Vec3 a) { return (1 / length(a)) * a; }
/// Angle between two directions, accurate for tiny and for nearly opposite angles alike (Kahan 2006).
inline double angle_between(Vec3 a, Vec3 b) { return 2 * std::atan2(length(a - b), length(a + b)); }

/// Linear, scene-referred red, green, blue of some quantity. Float where it is stored, double where it is summed.
template <class T>
struct Color3 {
  T r = 0, g = 0, b = 0;
  bool operator==(const Color3&) const = default;
  constexpr Color3() = default;
  constexpr Color3(T red, T green, T blue) : r(red), g(green), b(blue) {}
  template <class U>
  constexpr explicit Color3(const Color3<U>& c)
      : r(static_cast<T>(c.r)), g(static_cast<T>(c.g)), b(static_cast<T>(c.b)) {}
};
using Rgb = Color3<float>;
using RgbD = Color3<double>;

template <class T>
constexpr Color3<T> operator+(Color3<T> a, Color3<T> b) {
  return {a.r + b.r, a.g + b.g, a.b + b.b};
}
template <class T>
constexpr Color3<T> operator-(Color3<T> a, Color3<T> b) {
  return {a.r - b.r, a.g - b.g, a.b - b.b};
}
template <class T>
constexpr Color3<T> operator*(Color3<T> a, Color3<T> b) {
  return {a.r * b.r, a.g * b.g, a.b * b.b};
}
template <class T>
constexpr Color3<T> operator*(std::type_identity_t<T> s, Color3<T> a) {
  return {s * a.r, s * a.g, s * a.b};
}
template <class T>
constexpr Color3<T>& operator+=(Color3<T>& a, Color3<T> b) {
  return a = a + b;
}
/// Rec. 709 luminance.
template <class T>
constexpr T luminance(Color3<T> c) {
  return T(0.2126) * c.r + T(0.7152) * c.g + T(0.0722) * c.b;
}
template <class T>
constexpr T max_channel(Color3<T> c) {
  return c.r > c.g ? (c.r > c.b ? c.r : c.b) : (c.g > c.b ? c.g : c.b);
}

/// An orthogonal 3x3 matrix, rows first: a rotation, or (in io/engine alone) a rotation with a mirror.
struct Rotation {
  std::array<Vec3, 3> rows = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  bool operator==(const Rotation&) const = default;

  static Rotation identity() { return {}; }
  /// Right-hand rule about a unit axis, in radians (Rodrigues 1840).
  static Rotation about(Vec3 axis, double angle) {
    const double c = std::cos(angle), s = std::sin(angle), t = 1 - c;
    const auto [x, y, z] = axis;
    return {{Vec3{t * x * x + c, t * x * y - s * z, t * x * z + s * y},
             Vec3{t * x * y + s * z, t * y * y + c, t * y * z - s * x},
             Vec3{t * x * z - s * y, t * y * z + s * x, t * z * z + c}}};
  }
  static Rotation about_x(double angle) { return about({1, 0, 0}, angle); }
  static Rotation about_y(double angle) { return about({0, 1, 0}, angle); }
  static Rotation about_z(double angle) { return about({0, 0, 1}, angle); }
};

constexpr Vec3 operator*(const Rotation& r, Vec3 v) {
  return {dot(r.rows[0], v), dot(r.rows[1], v), dot(r.rows[2], v)};
}
constexpr Rotation transpose(const Rotation& r) {
  const auto& [a, b, c] = r.rows;
  return {{Vec3{a.x, b.x, c.x}, Vec3{a.y, b.y, c.y}, Vec3{a.z, b.z, c.z}}};
}
constexpr Rotation operator*(const Rotation& a, const Rotation& b) {
  const Rotation bt = transpose(b);
  Rotation product;
  for (int i = 0; i < 3; ++i) product.rows[i] = bt * a.rows[i];
  return product;
}
constexpr double determinant(const Rotation& r) { return dot(r.rows[0], cross(r.rows[1], r.rows[2])); }

constexpr double radians(double degrees) { return degrees * (kPi / 180); }
constexpr double degrees(double radians) { return radians * (180 / kPi); }

}  // namespace zonal
