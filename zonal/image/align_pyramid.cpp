#include "zonal/image/align_pyramid.h"

namespace zonal {
namespace {

Image<float> through_table(const Grey& grey, const Image<std::uint8_t>& missing,
                           const std::array<float, kGreyLevels>& table) {
  Image<float> values(grey.width(), grey.height());
  for (std::size_t i = 0; i < grey.size(); ++i) {
    const bool none = !missing.empty() && missing.values()[i] != 0;
    values.values()[i] = none ? kNoCode : table[grey.values()[i]];
  }
  return values;
}

Image<float> half_of(const Image<float>& fine) {
  Image<float> coarse(fine.width() / 2, fine.height() / 2);
  for (int y = 0; y < coarse.height(); ++y) {
    for (int x = 0; x < coarse.width(); ++x) {
      coarse(x, y) =
          (fine(2 * x, 2 * y) + fine(2 * x + 1, 2 * y) + fine(2 * x, 2 * y + 1) + fine(2 * x + 1, 2 * y + 1)) / 4;
    }
  }
  return coarse;
}

/// The outermost texels have too few neighbours: no data.
Image<float> smoothed(const Image<float>& image) {
  Image<float> smooth(image.width(), image.height(), kNoCode);
  const auto along = [](float a, float b, float c) { return (a + 2 * b + c) / 4; };
  for (int y = 1; y + 1 < image.height(); ++y) {
    const auto above = image.row(y - 1), here = image.row(y), below = image.row(y + 1);
    const auto column = [&](int x) { return along(above[x], here[x], below[x]); };
    for (int x = 1; x + 1 < image.width(); ++x) smooth(x, y) = along(column(x - 1), column(x), column(x + 1));
  }
  return smooth;
}

}  // namespace

std::vector<Image<float>> align_pyramid(const Grey& grey, const Image<std::uint8_t>& missing,
                                        const std::array<float, kGreyLevels>& table, int halvings) {
  // Halved before they are smoothed: else each level would be smoother than the last.
  std::vector<Image<float>> levels = {through_table(grey, missing, table)};
  for (int i = 0; i < halvings; ++i) levels.push_back(half_of(levels.back()));
  for (Image<float>& level : levels) level = smoothed(level);
  return levels;
}

}  // namespace zonal
