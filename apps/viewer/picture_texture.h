#pragma once

#include <cstdint>

#include "zonal/image/tonemap.h"

namespace zonal {

/// A small picture that panels can draw. Needs the window's context while it is shown and when it goes.
class PictureTexture {
 public:
  PictureTexture() = default;
  ~PictureTexture();
  PictureTexture(const PictureTexture&) = delete;
  PictureTexture& operator=(const PictureTexture&) = delete;

  void set(const Image<Rgb8>&);
  /// As the panels know it; nullptr before the first picture.
  void* id() const { return reinterpret_cast<void*>(static_cast<std::uintptr_t>(name_)); }

 private:
  std::uint32_t name_ = 0;
};

}  // namespace zonal
