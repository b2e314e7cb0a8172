#include "zonal/gl/target.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>

#include "zonal/base/check.h"
#include "zonal/base/error.h"

namespace zonal {
namespace {

std::uint32_t new_buffer(std::uint32_t format, int samples, int width, int height) {
  std::uint32_t buffer = 0;
  glGenRenderbuffers(1, &buffer);
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  if (samples > 1) {
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  } else {
    glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  }
  return buffer;
}

}  // namespace

DrawTarget::DrawTarget(int width, int height, const TargetOptions& options) : width_(width), height_(height) {
  int most = 0, most_samples = 1;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
  glGetIntegerv(GL_MAX_SAMPLES, &most_samples);
  if (width < 1 || height < 1 || width > most || height > most) {
    throw Error(ErrorKind::kUsage, fmt::format("a picture of {}x{} cannot be drawn", width, height),
                fmt::format("this machine draws up to {0}x{0}", most));
  }
  const std::uint32_t format = options.texels == TargetTexels::kFloats ? GL_RGBA32F : GL_RGBA8;
  const int samples = std::min(options.samples, most_samples);
  color_ = new_buffer(format, samples, width, height);
  depth_ = new_buffer(GL_DEPTH_COMPONENT24, samples, width, height);
  glGenFramebuffers(1, &frame_);
  glBindFramebuffer(GL_FRAMEBUFFER, frame_);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return;
  release();
  throw Error(ErrorKind::kUsage, fmt::format("the graphics driver cannot draw a picture of {}x{}", width, height),
              "ask for a smaller one, or update the driver");
}

DrawTarget::~DrawTarget() { release(); }

void DrawTarget::release() {
  glDeleteFramebuffers(1, &frame_);
  for (const std::uint32_t buffer : {color_, depth_}) glDeleteRenderbuffers(1, &buffer);
}

void DrawTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, frame_);
  glViewport(0, 0, width_, height_);
}

void DrawTarget::copy_to(const DrawTarget& single, int first_row, int rows) const {
  check(single.width_ == width_ && single.height_ == height_, "a target is copied to one of its size");
  glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, single.frame_);
  const int last = first_row + rows;
  glBlitFramebuffer(0, first_row, width_, last, 0, first_row, width_, last, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

template <class Texel>
Image<Texel> DrawTarget::read_as(std::uint32_t type) const {
  Image<Texel> picture(width_, height_);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width_, height_, GL_RGB, type, picture.values().data());
  for (int y = 0; y < height_ / 2; ++y) {  // OpenGL's first row is the lowest
    std::ranges::swap_ranges(picture.row(y), picture.row(height_ - 1 - y));
  }
  return picture;
}

Image<Rgb> DrawTarget::read() const { return read_as<Rgb>(GL_FLOAT); }
Image<Rgb8> DrawTarget::read_bytes() const { return read_as<Rgb8>(GL_UNSIGNED_BYTE); }

}  // namespace zonal
