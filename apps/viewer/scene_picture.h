#pragma once

#include <cstdint>

#include "zonal/gl/scene.h"
#include "zonal/image/tonemap.h"
#include "zonal/view/view_state.h"

namespace zonal {

/// The picture of a scene, kept until something changes. What takes long is drawn coarsely at first and then finely,
/// some of it in each frame, so that a slow technique does not hold the window up.
class ScenePicture {
 public:
  ScenePicture() = default;
  ~ScenePicture();
  ScenePicture(const ScenePicture&) = delete;
  ScenePicture& operator=(const ScenePicture&) = delete;

  /// Something in it changed. `other_cost`: what a pixel takes may have changed as well.
  void invalidate(bool other_cost);
  /// Draws for about `budget_ms`, more only where a coarse picture or a single strip takes more. Throws what
  /// Scene::draw() does; the picture counts as done then.
  void advance(Scene&, const ViewState&, ImageSize, double budget_ms);
  bool done() const { return size_.height > 0 && next_row_ >= size_.height; }
  ImageSize size() const { return size_; }
  /// Puts it into the window's framebuffer, whose left bottom corner is (0, 0).
  void show(int left, int bottom) const;

  /// Of all its pixels, in milliseconds; 0 before the first one is done.
  double full_ms() const { return full_ms_; }
  /// The top row first.
  Image<Rgb8> read() const;

 private:
  void resize(ImageSize);
  /// Returns how long it took, in milliseconds.
  double draw_rows(Scene&, const ViewState&, int first, int count);
  double draw_coarse(Scene&, const ViewState&, int divisor);

  ImageSize size_ = {0, 0};
  int next_row_ = 0;       // rows below it are drawn finely
  int strip_ = 0;          // rows of the last one
  bool coarse_ = false;    // there is a coarse picture under what is not
  double ms_a_pixel_ = 0;  // 0: not known
  double spent_ms_ = 0, full_ms_ = 0;
  std::uint32_t frame_ = 0, color_ = 0, depth_ = 0;
  std::uint32_t coarse_frame_ = 0, coarse_color_ = 0, coarse_depth_ = 0;
};

}  // namespace zonal
