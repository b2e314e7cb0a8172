#include "zonal/gl/target.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>

#include "zonal/base/error.h"

namespace zonal {

DrawTarget::DrawTarget(int width, int height) : width_(width), height_(height) {
  int most = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
  if (width < 1 || height < 1 || width > most || height > most) {
    throw Error(ErrorKind::kUsage, fmt::format("a picture of {}x{} cannot be drawn", width, height),
                fmt::format("this machine draws up to {0}x{0}", most));
  }
  glGenRenderbuffers(1, &color_);
  glBindRenderbuffer(GL_RENDERBUFFER, color_);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, width, height);
  glGenRenderbuffers(1, &depth_);
  glBindRenderbuffer(GL_RENDERBUFFER, depth_);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  glGenFramebuffers(1, &frame_);
  glBindFramebuffer(GL_FRAMEBUFFER, frame_);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw Error(ErrorKind::kUsage, "the graphics driver cannot draw into floats", "update the driver");
  }
}

DrawTarget::~DrawTarget() {
  glDeleteFramebuffers(1, &frame_);
  glDeleteRenderbuffers(1, &color_);
  glDeleteRenderbuffers(1, &depth_);
}

void DrawTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, frame_);
  glViewport(0, 0, width_, height_);
}

Image<Rgb> DrawTarget::read() const {
  Image<Rgb> picture(width_, height_);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, width_, height_, GL_RGB, GL_FLOAT, picture.values().data());
  for (int y = 0; y < height_ / 2; ++y) {  // OpenGL's first row is the lowest
    std::ranges::swap_ranges(picture.row(y), picture.row(height_ - 1 - y));
  }
  return picture;
}

}  // namespace zonal
