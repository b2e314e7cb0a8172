#include "zonal/view/own_highlight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "zonal/base/error.h"
#include "zonal/light/synthetic.h"

namespace zonal {
namespace {

RgbD mean(const Image<Rgb>& picture, int left, int columns) {
  RgbD sum;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = left; x < left + columns; ++x) sum += RgbD(picture(x, y));
  }
  return (1.0 / (columns * picture.height())) * sum;
}

TEST(OwnHighlight, IsTheMiddleSquareInItsOwnSize) {
  for (const int side : {50, 128, 333}) {
    Image<Rgb> picture(side + 20, side, Rgb(9, 9, 9));
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x)
        picture(10 + x, y) = {static_cast<float>(x % 7), static_cast<float>(1.0 * y / side), 2};
    }
    const Image<Rgb> highlight = own_highlight(picture);
    ASSERT_EQ(highlight.width(), kOwnHighlightPx);
    const RgbD expected = mean(picture, 10, side), is = mean(highlight, 0, kOwnHighlightPx);
    EXPECT_NEAR(is.r, expected.r, 1e-4) << side;
    EXPECT_NEAR(is.g, expected.g, 1e-4) << side;
    EXPECT_NEAR(is.b, 2, 1e-5) << "nothing from beside the square";
    EXPECT_LT(highlight(3, 0).g, highlight(3, kOwnHighlightPx - 1).g) << "the top is the top";
  }
}

TEST(OwnHighlight, TakesThePlaceOfABlackOne) {
  ViewData data = view_data(furnace({Layout::kEquirect}, {32, 16}),
                            {.panorama_px = 16, .cube_px = 8, .chain_px = 16, .irradiance_px = 8, .reference_rows = 8});
  const auto texture = [&]() -> const ViewTexture& {
    return *std::ranges::find(data.textures, "highlight_own", &ViewTexture::name);
  };
  const std::size_t count = data.textures.size();
  EXPECT_EQ(texture().levels[0](64, 64), Rgb());
  set_own_highlight(data, Image<Rgb>(kOwnHighlightPx, kOwnHighlightPx, {1, 2, 3}));
  EXPECT_EQ(texture().levels[0](64, 64), Rgb(1, 2, 3));
  EXPECT_EQ(data.textures.size(), count);
}

TEST(OwnHighlight, RefusesWhatIsNoLight) {
  Image<Rgb> picture(4, 4);
  picture(1, 1).g = -1;
  EXPECT_THROW((void)own_highlight(picture), Error);
  picture(1, 1).g = std::numeric_limits<float>::infinity();
  EXPECT_THROW((void)own_highlight(picture), Error);
  EXPECT_THROW((void)own_highlight_texture(picture), std::logic_error);
}

}  // namespace
}  // namespace zonal
