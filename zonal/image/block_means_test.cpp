#include "zonal/image/block_means.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace zonal {
namespace {

TEST(BlockMeans, AreMeansAlsoAtTheEdges) {
  Image<Rgb> picture(5, 3);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) picture(x, y) = {static_cast<float>(x), static_cast<float>(10 * y), 1};
  }
  const Image<Rgb> small = block_means(picture, 2);
  ASSERT_EQ(small.width(), 3);
  ASSERT_EQ(small.height(), 2);
  EXPECT_EQ(small(0, 0), (Rgb{0.5f, 5, 1}));
  EXPECT_EQ(small(2, 0), (Rgb{4, 5, 1}));
  EXPECT_EQ(small(2, 1), (Rgb{4, 20, 1}));
  EXPECT_EQ(block_means(picture, 1), picture);
  EXPECT_THROW((void)block_means(picture, 0), std::logic_error);
}

}  // namespace
}  // namespace zonal
