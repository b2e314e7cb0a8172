#pragma once

namespace zonal {

/// An OpenGL 4.1 core context without a window, through EGL's surfaceless platform: it needs no display and no GPU
/// (Mesa draws on the processor). Current on the thread that made it, for as long as it lives.
class OffscreenContext {
 public:
  /// Throws Error{kUsage} where the machine has no such thing, with what to install.
  OffscreenContext();
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace zonal
