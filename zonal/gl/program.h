#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace zonal {

/// A linked program. Setting a uniform that it does not have does nothing: shaders name only what they use.
class GpuProgram {
 public:
  /// Throws Error{kUsage} with the driver's own words when the shaders do not compile or link.
  GpuProgram(const std::string& vertex, const std::string& fragment, std::string_view what);
  ~GpuProgram();
  GpuProgram(GpuProgram&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  GpuProgram& operator=(GpuProgram&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }

  void use() const;
  /// Whether the shaders use a uniform of this name.
  bool has(const char* name) const;
  // Of the program in use.
  void set(const char* name, int value) const;
  void set(const char* name, float value) const;
  /// An array of vectors of 1..4 numbers.
  void set_vectors(const char* name, int components, std::span<const float> values) const;
  /// A square matrix of 9 or 16 numbers, columns first.
  void set_matrix(const char* name, std::span<const float> columns) const;

 private:
  std::uint32_t id_ = 0;
};

}  // namespace zonal
