#pragma once

#include <cstdint>
#include <utility>

#include "zonal/view/view_data.h"

namespace zonal {

/// A texture of the shaders on the graphics side: half floats for light, floats for tables.
class GpuTexture {
 public:
  explicit GpuTexture(const ViewTexture&);
  ~GpuTexture();
  GpuTexture(GpuTexture&& other) noexcept : id_(std::exchange(other.id_, 0)), target_(other.target_) {}
  GpuTexture& operator=(GpuTexture&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(target_, other.target_);
    return *this;
  }

  void bind(int unit) const;
  std::uint32_t id() const { return id_; }

 private:
  std::uint32_t id_ = 0;
  std::uint32_t target_ = 0;
};

}  // namespace zonal
