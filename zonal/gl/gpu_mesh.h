#pragma once

#include <cstdint>
#include <utility>

#include "zonal/view/mesh.h"

namespace zonal {

/// A mesh on the graphics side: attributes 0 position, 1 normal, 2 texture coordinates.
class GpuMesh {
 public:
  explicit GpuMesh(const Mesh&);
  ~GpuMesh();
  GpuMesh(GpuMesh&& other) noexcept
      : array_(std::exchange(other.array_, 0)),
        vertices_(std::exchange(other.vertices_, 0)),
        indices_(std::exchange(other.indices_, 0)),
        index_count_(std::exchange(other.index_count_, 0)) {}
  GpuMesh& operator=(GpuMesh&& other) noexcept {
    std::swap(array_, other.array_);
    std::swap(vertices_, other.vertices_);
    std::swap(indices_, other.indices_);
    std::swap(index_count_, other.index_count_);
    return *this;
  }

  /// With the program in use, so many times: gl_InstanceID counts them.
  void draw(int instances = 1) const;

 private:
  std::uint32_t array_ = 0, vertices_ = 0, indices_ = 0;
  int index_count_ = 0;
};

}  // namespace zonal
