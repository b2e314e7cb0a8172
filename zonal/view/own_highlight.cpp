#include "zonal/view/own_highlight.h"

#include <algorithm>
#include <cmath>

#include "zonal/base/check.h"
#include "zonal/base/error.h"

namespace zonal {
namespace {

/// Sum of f(i, weight) over the whole numbers whose unit intervals meet [from, to], weighted by the parts they share.
template <class F>
void over(double from, double to, int last, const F& f) {
  for (int i = static_cast<int>(from); i <= std::min(last, static_cast<int>(to)); ++i) {
    const double shared = std::min(to, i + 1.0) - std::max(from, 1.0 * i);
    if (shared > 0) f(i, shared);
  }
}

}  // namespace

Image<Rgb> own_highlight(const Image<Rgb>& picture) {
  for (const Rgb& value : picture.values()) {
    for (const float c : {value.r, value.g, value.b}) {
      if (std::isfinite(c) && c >= 0) continue;
      throw Error(ErrorKind::kInput, "the picture of the highlight has values that are no light",
                  "give one whose values are finite and not below zero");
    }
  }
  const int side = std::min(picture.width(), picture.height());
  if (side < 1) throw Error(ErrorKind::kInput, "the picture of the highlight is empty");
  const int left = (picture.width() - side) / 2, top = (picture.height() - side) / 2;
  const double step = static_cast<double>(side) / kOwnHighlightPx;
  Image<Rgb> result(kOwnHighlightPx, kOwnHighlightPx);
  for (int y = 0; y < kOwnHighlightPx; ++y) {
    for (int x = 0; x < kOwnHighlightPx; ++x) {
      RgbD sum;
      over(y * step, (y + 1) * step, side - 1, [&](int row, double high) {
        over(x * step, (x + 1) * step, side - 1,
             [&](int column, double wide) { sum += (high * wide) * RgbD(picture(left + column, top + row)); });
      });
      result(x, y) = Rgb((1 / (step * step)) * sum);
    }
  }
  return result;
}

ViewTexture own_highlight_texture(Image<Rgb> picture) {
  check(picture.width() == kOwnHighlightPx && picture.height() == kOwnHighlightPx, "a highlight of its size");
  ViewTexture texture{.name = "highlight_own"};
  texture.levels.push_back(std::move(picture));
  return texture;
}

void set_own_highlight(ViewData& data, Image<Rgb> picture) {
  const auto old = std::ranges::find(data.textures, "highlight_own", &ViewTexture::name);
  check(old != data.textures.end(), "the data of a view has a highlight to replace");
  *old = own_highlight_texture(std::move(picture));
}

}  // namespace zonal
