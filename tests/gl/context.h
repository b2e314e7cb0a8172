#pragma once

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "zonal/math/vec.h"

namespace zonal {

/// OpenGL 4.1 core without a window, current as long as it lives.
class GlContext {
 public:
  /// Throws std::runtime_error that says what is missing.
  GlContext();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  std::string renderer() const { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

/// A linked program of two stages. Throws std::runtime_error with the driver's words.
class GlProgram {
 public:
  static GlProgram from_glsl(const std::string& vertex, const std::string& fragment);
  /// Modules with the entry point main; needs GL_ARB_gl_spirv.
  static GlProgram from_spirv(std::span<const char> vertex, std::span<const char> fragment);
  ~GlProgram();
  GlProgram(GlProgram&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

  GLuint id() const { return id_; }

 private:
  explicit GlProgram(std::span<const GLuint> shaders);
  GLuint id_ = 0;
};

/// A colour as the program wrote it, in 32-bit floats.
struct GlColor {
  float r = 0, g = 0, b = 0, a = 0;
};

inline constexpr int kGlWidth = 16;
/// The column-major matrix that takes pixel (x, y, 0, 1) of a picture kGlWidth wide and `height` high to clip space.
std::vector<float> clip_from_pixel(int height);

/// Draws one point for each normal, point i at the centre of pixel (i % kGlWidth, i / kGlWidth): attribute 0 is that
/// centre in pixels (x, y, 0, 1), attribute 1 the normal (x, y, z, 5). Returns target[t][i], what it wrote into each of
/// `targets` float pictures.
std::vector<std::vector<GlColor>> draw_points(const GlProgram&, const std::vector<Vec3>& normals, int targets);

}  // namespace zonal
