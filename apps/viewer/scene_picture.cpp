#include "apps/viewer/scene_picture.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "zonal/base/error.h"

namespace zonal {
namespace {

constexpr int kCoarsest = 64;

double ms_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Names are made once; storage whenever the size changes.
void make_target(std::uint32_t& frame, std::uint32_t& color, std::uint32_t& depth, int width, int height) {
  if (frame == 0) {
    glGenFramebuffers(1, &frame);
    glGenRenderbuffers(1, &color);
    glGenRenderbuffers(1, &depth);
  }
  glBindRenderbuffer(GL_RENDERBUFFER, color);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
  glBindRenderbuffer(GL_RENDERBUFFER, depth);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, frame);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw Error(ErrorKind::kUsage, "the graphics driver cannot draw a picture of this size", "make the window smaller");
  }
}

}  // namespace

ScenePicture::~ScenePicture() {
  for (const std::uint32_t frame : {frame_, coarse_frame_}) glDeleteFramebuffers(1, &frame);
  for (const std::uint32_t buffer : {color_, depth_, coarse_color_, coarse_depth_}) glDeleteRenderbuffers(1, &buffer);
}

void ScenePicture::invalidate(bool other_cost) {
  next_row_ = 0;
  coarse_ = false;
  spent_ms_ = 0;
  strip_ = 0;
  if (other_cost) ms_a_pixel_ = 0;
}

void ScenePicture::resize(ImageSize size) {
  if (size == size_) return;
  make_target(frame_, color_, depth_, size.width, size.height);
  size_ = size;
  invalidate(false);
}

double ScenePicture::draw_rows(Scene& scene, const ViewState& state, int first, int count) {
  const auto start = std::chrono::steady_clock::now();
  glBindFramebuffer(GL_FRAMEBUFFER, frame_);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, first, size_.width, count);
  try {
    scene.draw(state, size_.width, size_.height);
  } catch (...) {
    glDisable(GL_SCISSOR_TEST);
    next_row_ = size_.height;
    throw;
  }
  glDisable(GL_SCISSOR_TEST);
  glFinish();  // the time of drawing is not that of asking for it
  return ms_since(start);
}

double ScenePicture::draw_coarse(Scene& scene, const ViewState& state, int divisor) {
  const int width = std::max(1, size_.width / divisor), height = std::max(1, size_.height / divisor);
  make_target(coarse_frame_, coarse_color_, coarse_depth_, width, height);
  const auto start = std::chrono::steady_clock::now();
  try {
    scene.draw(state, width, height);
  } catch (...) {
    next_row_ = size_.height;
    throw;
  }
  glFinish();
  const double ms = ms_since(start);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, coarse_frame_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, frame_);
  glBlitFramebuffer(0, 0, width, height, 0, 0, size_.width, size_.height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
  coarse_ = true;
  ms_a_pixel_ = ms / (static_cast<double>(width) * height);
  return ms;
}

void ScenePicture::advance(Scene& scene, const ViewState& state, ImageSize size, double budget_ms) {
  resize(size);
  const double pixels = static_cast<double>(size_.width) * size_.height;
  double left_ms = budget_ms;
  if (!coarse_ && next_row_ == 0) {
    // Before anything is known, as little as can be; then a coarse picture may take half of the budget.
    if (ms_a_pixel_ == 0) left_ms -= draw_coarse(scene, state, kCoarsest);
    const double divisor = std::ceil(std::sqrt(ms_a_pixel_ * pixels / (0.5 * budget_ms)));
    const bool finer = divisor < kCoarsest / 2 || !coarse_;
    if (ms_a_pixel_ * pixels > budget_ms && finer) {
      left_ms -= draw_coarse(scene, state, static_cast<int>(std::clamp(divisor, 2.0, 1.0 * kCoarsest)));
    }
  }
  // Rows differ: those of the background are cheap. So a strip is no more than twice as high as the last one, unless
  // all is known to fit.
  const bool fits = ms_a_pixel_ > 0 && ms_a_pixel_ * pixels <= budget_ms;
  while (!done() && left_ms > 0) {
    const double affordable = left_ms / std::max(1e-6, ms_a_pixel_ * size_.width);
    const int most = fits ? size_.height : std::min(size_.height, 2 * std::max(1, strip_));
    strip_ = std::clamp(static_cast<int>(std::min(affordable, 1e6)), 1, most);
    const int rows = std::min(strip_, size_.height - next_row_);
    const double ms = draw_rows(scene, state, next_row_, rows);
    next_row_ += rows;
    left_ms -= ms;
    spent_ms_ += ms;
    // What this one has shown counts, if it was more than the mean.
    if (!fits) ms_a_pixel_ = std::max(0.5 * ms_a_pixel_, ms / (static_cast<double>(rows) * size_.width));
    if (!done()) continue;
    full_ms_ = spent_ms_;
    ms_a_pixel_ = spent_ms_ / pixels;
  }
}

void ScenePicture::show(int left, int bottom) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, size_.width, size_.height, left, bottom, left + size_.width, bottom + size_.height,
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

Image<Rgb8> ScenePicture::read() const {
  Image<Rgb8> picture(size_.width, size_.height);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, size_.width, size_.height, GL_RGB, GL_UNSIGNED_BYTE, picture.values().data());
  for (int y = 0; y < size_.height / 2; ++y) {  // OpenGL's first row is the lowest
    std::ranges::swap_ranges(picture.row(y), picture.row(size_.height - 1 - y));
  }
  return picture;
}

}  // namespace zonal
