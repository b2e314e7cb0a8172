#pragma once

#include <optional>

#include "zonal/image/image.h"
#include "zonal/view/own_highlight.h"
#include "zonal/view/paint.h"

namespace zonal {

/// A person's own highlight while it is painted: the picture, and the stroke that is being drawn over it.
class HighlightPainter {
 public:
  const Image<Rgb>& picture() const { return stroke_ ? stroke_->picture() : picture_; }
  /// Counts what was done to the picture, so that who shows it knows when to look again.
  int edition() const { return edition_; }

  /// Of kOwnHighlightPx. Ends a stroke.
  void replace(Image<Rgb>);
  void clear() { replace(Image<Rgb>(kOwnHighlightPx, kOwnHighlightPx)); }
  /// Begins a stroke, or goes on with it: (0, 0) is the top left corner of the picture. The brush of the first point
  /// counts.
  void stroke_to(double u, double v, const Brush&);
  void end_stroke();

 private:
  Image<Rgb> picture_{kOwnHighlightPx, kOwnHighlightPx};
  std::optional<Stroke> stroke_;
  int edition_ = 0;
};

}  // namespace zonal
