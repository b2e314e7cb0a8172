#include "apps/viewer/scene_picture.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace zonal {
namespace {

constexpr int kCoarsest = 64;

double ms_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

void ScenePicture::invalidate(bool other_cost) {
  for (Pass* pass : {&fine_, &smooth_}) *pass = {.ms_a_pixel = other_cost ? 0 : pass->ms_a_pixel};
  coarse_ = false;
}

void ScenePicture::resize(ImageSize size) {
  if (size == size_) return;
  size_ = {0, 0};  // while there is none
  samples_.reset();
  target_.emplace(size.width, size.height, TargetOptions{.texels = TargetTexels::kBytes});
  size_ = size;
  invalidate(false);
}

double ScenePicture::draw_rows(const DrawTarget& into, Scene& scene, const ViewState& state, int first, int count) {
  const auto start = std::chrono::steady_clock::now();
  into.bind();
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, first, size_.width, count);
  try {
    scene.draw(state, size_.width, size_.height);
  } catch (...) {
    glDisable(GL_SCISSOR_TEST);
    throw;
  }
  glDisable(GL_SCISSOR_TEST);
  if (&into != &*target_) into.copy_to(*target_, first, count);
  glFinish();  // the time of drawing is not that of asking for it
  return ms_since(start);
}

double ScenePicture::draw_coarse(Scene& scene, const ViewState& state, int divisor) {
  const int width = std::max(1, size_.width / divisor), height = std::max(1, size_.height / divisor);
  const DrawTarget coarse(width, height, {.texels = TargetTexels::kBytes});
  coarse.bind();
  const auto start = std::chrono::steady_clock::now();
  scene.draw(state, width, height);
  glFinish();
  const double ms = ms_since(start);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, coarse.frame());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target_->frame());
  glBlitFramebuffer(0, 0, width, height, 0, 0, size_.width, size_.height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
  coarse_ = true;
  fine_.ms_a_pixel = ms / (static_cast<double>(width) * height);
  return ms;
}

/// Rows differ: those of the background are cheap. So a strip is no more than twice as high as the last one, unless all
/// is known to fit.
void ScenePicture::draw_strips(Pass& pass, const DrawTarget& into, Scene& scene, const ViewState& state,
                               double budget_ms, double left_ms) {
  const double pixels = static_cast<double>(size_.width) * size_.height;
  const bool fits = pass.ms_a_pixel > 0 && pass.ms_a_pixel * pixels <= budget_ms;
  while (pass.next_row < size_.height && left_ms > 0) {
    const double affordable = left_ms / std::max(1e-6, pass.ms_a_pixel * size_.width);
    const int most = fits ? size_.height : std::min(size_.height, 2 * std::max(1, pass.strip));
    pass.strip = std::clamp(static_cast<int>(std::min(affordable, 1e6)), 1, most);
    const int rows = std::min(pass.strip, size_.height - pass.next_row);
    const double ms = draw_rows(into, scene, state, pass.next_row, rows);
    pass.next_row += rows;
    left_ms -= ms;
    pass.spent_ms += ms;
    // What this one has shown counts, if it was more than the mean.
    if (!fits) pass.ms_a_pixel = std::max(0.5 * pass.ms_a_pixel, ms / (static_cast<double>(rows) * size_.width));
  }
  if (pass.next_row >= size_.height) pass.ms_a_pixel = pass.spent_ms / pixels;
}

void ScenePicture::advance(Scene& scene, const ViewState& state, ImageSize size, double budget_ms) {
  resize(size);
  const double pixels = static_cast<double>(size_.width) * size_.height;
  double left_ms = budget_ms;
  try {
    if (!coarse_ && fine_.next_row == 0) {
      // Before anything is known, as little as can be; then a coarse picture may take half of the budget.
      if (fine_.ms_a_pixel == 0) left_ms -= draw_coarse(scene, state, kCoarsest);
      const double divisor = std::ceil(std::sqrt(fine_.ms_a_pixel * pixels / (0.5 * budget_ms)));
      const bool finer = divisor < kCoarsest / 2 || !coarse_;
      if (fine_.ms_a_pixel * pixels > budget_ms && finer) {
        left_ms -= draw_coarse(scene, state, static_cast<int>(std::clamp(divisor, 2.0, 1.0 * kCoarsest)));
      }
    }
    draw_strips(fine_, *target_, scene, state, budget_ms, left_ms);
  } catch (...) {
    fine_.next_row = size_.height;
    throw;
  }
  if (done()) full_ms_ = fine_.spent_ms;
}

void ScenePicture::smooth(Scene& scene, const ViewState& state, double budget_ms) {
  constexpr double kCost = 2.5;  // of samples, measured with Mesa's llvmpipe; the first strips show what it is here
  try {
    if (!samples_) {
      samples_.emplace(size_.width, size_.height,
                       TargetOptions{.texels = TargetTexels::kBytes, .samples = kEdgeSamples});
    }
    if (smooth_.ms_a_pixel == 0) smooth_.ms_a_pixel = kCost * fine_.ms_a_pixel;
    draw_strips(smooth_, *samples_, scene, state, budget_ms, budget_ms);
  } catch (...) {
    smooth_.next_row = size_.height;
    throw;
  }
}

void ScenePicture::show(int left, int bottom) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, target_->frame());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, size_.width, size_.height, left, bottom, left + size_.width, bottom + size_.height,
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace zonal
