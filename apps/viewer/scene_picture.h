#pragma once

#include <optional>

#include "zonal/gl/scene.h"
#include "zonal/gl/target.h"
#include "zonal/image/tonemap.h"
#include "zonal/view/view_state.h"

namespace zonal {

/// The picture of a scene, kept until something changes. What takes long is drawn coarsely at first and then finely,
/// some of it in each frame, so that a slow technique does not hold the window up. Smooth edges take more than twice as
/// long: a picture gets them when nothing else is to be done.
class ScenePicture {
 public:
  /// Something in it changed. `other_cost`: what a pixel takes may have changed as well.
  void invalidate(bool other_cost);
  /// Draws for about `budget_ms`, more only where a coarse picture or a single strip takes more. Throws what
  /// Scene::draw() does; the picture counts as done then.
  void advance(Scene&, const ViewState&, ImageSize, double budget_ms);
  bool done() const { return size_.height > 0 && fine_.next_row >= size_.height; }
  /// Of a picture that is done: smooths edges for about `budget_ms`. Throws as advance() does; it counts as smooth
  /// then.
  void smooth(Scene&, const ViewState&, double budget_ms);
  bool is_smooth() const { return done() && smooth_.next_row >= size_.height; }
  ImageSize size() const { return size_; }
  /// Puts it into the window's framebuffer, whose left bottom corner is (0, 0).
  void show(int left, int bottom) const;

  /// Of all its pixels without smooth edges, in milliseconds; 0 before the first one is done.
  double full_ms() const { return full_ms_; }
  /// The top row first.
  Image<Rgb8> read() const { return target_ ? target_->read_bytes() : Image<Rgb8>(); }

 private:
  /// A way of drawing all rows, from the lowest, some at a time.
  struct Pass {
    int next_row = 0;       // rows below it are drawn
    int strip = 0;          // rows of the last one
    double ms_a_pixel = 0;  // 0: not known
    double spent_ms = 0;
  };
  void resize(ImageSize);
  void draw_strips(Pass&, const DrawTarget&, Scene&, const ViewState&, double budget_ms, double left_ms);
  /// Returns how long it took, in milliseconds.
  double draw_rows(const DrawTarget&, Scene&, const ViewState&, int first, int count);
  double draw_coarse(Scene&, const ViewState&, int divisor);

  ImageSize size_ = {0, 0};
  Pass fine_, smooth_;
  bool coarse_ = false;  // there is a coarse picture under what is not
  double full_ms_ = 0;
  std::optional<DrawTarget> target_;   // what is shown; nothing before the first picture
  std::optional<DrawTarget> samples_;  // what smooth edges are made of; nothing before the first picture at rest
};

}  // namespace zonal
