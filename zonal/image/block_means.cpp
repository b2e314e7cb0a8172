#include "zonal/image/block_means.h"

#include <algorithm>

#include "zonal/base/check.h"

namespace zonal {

Image<Rgb> block_means(const Image<Rgb>& picture, int factor) {
  check(factor >= 1, "a block has a texel or more along its edge");
  Image<Rgb> copy((picture.width() + factor - 1) / factor, (picture.height() + factor - 1) / factor);
  for (int y = 0; y < copy.height(); ++y) {
    for (int x = 0; x < copy.width(); ++x) {
      RgbD sum;
      int count = 0;
      for (int j = factor * y; j < std::min(factor * (y + 1), picture.height()); ++j) {
        for (int i = factor * x; i < std::min(factor * (x + 1), picture.width()); ++i, ++count)
          sum += RgbD(picture(i, j));
      }
      copy(x, y) = Rgb((1.0 / count) * sum);
    }
  }
  return copy;
}

}  // namespace zonal
