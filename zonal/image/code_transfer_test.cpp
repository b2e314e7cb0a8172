#include "zonal/image/code_transfer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "zonal/image/response.h"
#include "zonal/image/synthetic_bracket_test.h"

namespace zonal {
namespace {

GreyHistogram histogram(double seconds) {
  const Grey grey = grey_of(CodedPicture(sample::photograph(sample::scene(240, 160), {sample::srgb_camera}, seconds)));
  return histogram_of(grey, {0, 0, grey.width(), grey.height()});
}

/// The code that an sRGB camera gives light to which it gives `code` in an exposure longer by `stops`.
double shorter_code(double code, double stops) {
  const auto exposure = static_cast<double>(Response::srgb()(0, code / 255));
  return 255 * sample::srgb_camera(exposure * std::exp2(-stops));
}

TEST(CodeTransfer, FindsTheCodesOfTheShorterExposure) {
  int compared = 0;
  for (const double stops : {0.5, 2.0, 5.0}) {
    const GreyHistogram shorter = histogram(0.5), longer = histogram(0.5 * std::exp2(stops));
    const CodeTransfer transfer = transfer_codes(shorter, longer);
    for (int z = 8; z < 250; ++z) {
      if (longer[z] == 0 || shorter_code(z, stops) < 12) continue;  // no such light in the scene, or hardly any
      // A code of the longer exposure is several of the shorter at most.
      EXPECT_NEAR(transfer.longer[z], shorter_code(z, stops), 1.5) << z << ' ' << stops;
      ++compared;
    }
    for (int z = 3; z < shorter_code(250, stops); ++z) EXPECT_EQ(transfer.shorter[z], z);
    EXPECT_EQ(transfer.shorter[255], transfer.longer[255]);
    EXPECT_EQ(transfer.shorter[0], transfer.longer[0]);
    EXPECT_NEAR(transfer.range, shorter_code(252, stops) - 2, 1.5) << stops;
  }
  EXPECT_GT(compared, 400);
}

TEST(CodeTransfer, NothingIsLeftOfBlackAndWhite) {
  GreyHistogram black = {}, white = {};
  black[0] = white[255] = 1000;
  EXPECT_EQ(transfer_codes(black, white).range, 0);
  EXPECT_EQ(transfer_codes({}, {}).range, 0);
}

}  // namespace
}  // namespace zonal
