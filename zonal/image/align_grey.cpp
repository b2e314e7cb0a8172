#include "zonal/image/align_grey.h"

#include <algorithm>

#include "zonal/image/color.h"

namespace zonal {

Grey grey_of(const CodedPicture& picture) {
  Grey grey(picture.width(), picture.height());
  std::vector<Rgb> row(static_cast<std::size_t>(picture.width()));
  const bool floats = picture.levels() == 0;
  for (int y = 0; y < picture.height(); ++y) {
    picture.row(y, row);
    std::transform(row.begin(), row.end(), grey.row(y).begin(), [&](const Rgb& p) {
      const float green = std::clamp(p.g, 0.0f, 1.0f);
      return static_cast<std::uint8_t>(255 * (floats ? srgb_encode(green) : green) + 0.5f);
    });
  }
  return grey;
}

Grey halved(const Grey& fine) {
  Grey coarse(fine.width() / 2, fine.height() / 2);
  for (int y = 0; y < coarse.height(); ++y) {
    for (int x = 0; x < coarse.width(); ++x) {
      const int sum = fine(2 * x, 2 * y) + fine(2 * x + 1, 2 * y) + fine(2 * x, 2 * y + 1) + fine(2 * x + 1, 2 * y + 1);
      coarse(x, y) = static_cast<std::uint8_t>((sum + 2) / 4);
    }
  }
  return coarse;
}

Part shared_part(const Grey& fixed, const Grey& moving, Shift shift) {
  return {std::max(0, -shift.dx), std::max(0, -shift.dy), std::min(fixed.width(), moving.width() - shift.dx),
          std::min(fixed.height(), moving.height() - shift.dy)};
}

GreyHistogram histogram_of(const Grey& grey, Part part) {
  GreyHistogram histogram = {};
  for (int y = part.top; y < part.bottom; ++y) {
    for (int x = part.left; x < part.right; ++x) ++histogram[grey(x, y)];
  }
  return histogram;
}

}  // namespace zonal
