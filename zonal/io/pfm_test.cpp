#include "zonal/io/pfm.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "zonal/base/error.h"
#include "zonal/io/sample_files_test.h"

namespace zonal {
namespace {

using sample::bytes_of;
using sample::operator+;

Picture decode(const std::vector<std::byte>& bytes) { return decode_picture("test.pfm", bytes); }

std::vector<std::byte> floats(const std::vector<float>& values, bool little_endian) {
  std::vector<std::byte> bytes;
  for (const float value : values) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (int i = 0; i < 4; ++i)
      bytes.push_back(static_cast<std::byte>(bits >> (8 * (little_endian ? i : 3 - i)) & 255));
  }
  return bytes;
}

TEST(Pfm, ColourAndGreyInBothByteOrdersBottomRowFirst) {
  const std::vector<float> colour = {1, 2, 3, 4, 5, 6, -7, 8.5f, 9, 10, 11, 12};
  for (const bool little : {true, false}) {
    const Picture picture = decode(bytes_of(little ? "PF\n2 2\n-1.0\n" : "PF 2\t2\r\n1\n") + floats(colour, little));
    EXPECT_EQ(picture.channels, 3);
    EXPECT_EQ(picture.pixels(0, 1), Rgb(1, 2, 3));
    EXPECT_EQ(picture.pixels(1, 1), Rgb(4, 5, 6));
    EXPECT_EQ(picture.pixels(0, 0), Rgb(-7, 8.5f, 9));
    EXPECT_EQ(picture.pixels(1, 0), Rgb(10, 11, 12));
    const Picture grey = decode(bytes_of(little ? "Pf\n2 1\n-1\n" : "Pf\n2 1\n1\n") + floats({1, 2}, little));
    EXPECT_EQ(grey.channels, 1);
    EXPECT_EQ(grey.pixels(1, 0), Rgb(2, 2, 2));
    EXPECT_TRUE(grey.notes.empty());
  }
}

TEST(Pfm, TheScaleMultipliesAndIsNoted) {
  const Picture picture = decode(bytes_of("Pf\n1 1\n-2.5\n") + floats({2}, true));
  EXPECT_EQ(picture.pixels(0, 0), Rgb(5, 5, 5));
  EXPECT_EQ(picture.notes.size(), 1u);
}

TEST(Pfm, RoundTripKeepsEveryBit) {
  Image<Rgb> image = sample::random_picture(37, 23, 1);
  image(0, 0) = Rgb(std::numeric_limits<float>::infinity(), -0.0f, std::numeric_limits<float>::denorm_min());
  image(1, 0).r = std::bit_cast<float>(0x7fc12345u);  // a NaN with a payload
  const sample::TemporaryFolder folder;
  EXPECT_EQ(save_picture(image, folder / "a.pfm").clipped_pixels, 0);
  const Picture back = load_picture(folder / "a.pfm");
  EXPECT_EQ(back.format, "PFM");
  ASSERT_EQ(back.pixels.size(), image.size());
  EXPECT_EQ(std::memcmp(back.pixels.values().data(), image.values().data(), image.size() * sizeof(Rgb)), 0);
}

TEST(Pfm, BrokenHeadersAreRefused) {
  int refused = 0;
  for (const char* header :
       {"PF\n0 1\n-1\n", "PF\n-1 1\n-1\n", "PF\nx 1\n-1\n", "PF\n1 1\n0\n", "PF\n1 1\nnan\n", "PF\n1 1\ninf\n",
        "PF\n1 1\n-1x\n", "PF\n99999999999999999999 1\n-1\n", "PF\n1000000000000 1\n-1\n"}) {
    EXPECT_THROW(decode(bytes_of(header) + floats({1, 2, 3}, true)), Error) << header;
    ++refused;
  }
  EXPECT_THROW(decode(bytes_of("PF\n" + std::string(1000, '1'))), Error);
  EXPECT_EQ(refused, 9);
}

}  // namespace
}  // namespace zonal
