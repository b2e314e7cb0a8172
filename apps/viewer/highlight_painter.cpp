#include "apps/viewer/highlight_painter.h"

#include <utility>

namespace zonal {

void HighlightPainter::replace(Image<Rgb> picture) {
  stroke_.reset();
  picture_ = std::move(picture);
  ++edition_;
}

void HighlightPainter::stroke_to(double u, double v, const Brush& brush) {
  if (!stroke_) stroke_.emplace(picture_, brush);
  stroke_->move_to(u, v);
  ++edition_;
}

void HighlightPainter::end_stroke() {
  if (stroke_) replace(stroke_->picture());
}

}  // namespace zonal
