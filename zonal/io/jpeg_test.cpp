#include "zonal/io/jpeg.h"

#include <gtest/gtest.h>

#include <cmath>

#include "zonal/base/error.h"
#include "zonal/image/color.h"
#include "zonal/io/exif.h"
#include "zonal/io/sample_files_test.h"

namespace zonal {
namespace {

/// A smooth ramp: 8x8 blocks hold it almost exactly at quality 100.
sample::Jpeg ramp(int components) {
  sample::Jpeg jpeg = {.width = 40, .height = 24, .components = components};
  for (int y = 0; y < jpeg.height; ++y) {
    for (int x = 0; x < jpeg.width; ++x) {
      for (int c = 0; c < components; ++c)
        jpeg.samples.push_back(static_cast<std::uint8_t>(40 + 3 * x + 2 * y + 10 * c));
    }
  }
  return jpeg;
}

/// The largest difference from the samples, in codes.
double worst_code_error(const Picture& picture, const sample::Jpeg& jpeg) {
  double worst = 0;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const Rgb p = picture.pixels.values()[i];
    const std::uint8_t* s = jpeg.samples.data() + i * static_cast<std::size_t>(jpeg.components);
    const auto error = [&](float value, int code) {
      worst = std::max(worst, std::abs(255.0 * srgb_encode(value) - code));
    };
    error(p.r, s[0]);
    error(p.g, s[jpeg.components == 3 ? 1 : 0]);
    error(p.b, s[jpeg.components == 3 ? 2 : 0]);
  }
  return worst;
}

TEST(Jpeg, ColourGreyBaselineAndProgressive) {
  int pictures = 0;
  for (const int components : {1, 3}) {
    for (const bool progressive : {false, true}) {
      sample::Jpeg jpeg = ramp(components);
      jpeg.progressive = progressive;
      const Picture picture = decode_picture("a.jpg", sample::jpeg_file(jpeg));
      EXPECT_EQ(picture.format, "JPEG");
      EXPECT_EQ(picture.channels, components);
      EXPECT_TRUE(picture.srgb_decoded);
      ASSERT_EQ(picture.pixels.size(), 40u * 24u);
      // Integer DCT at quality 100 and, for colour, two integer colour conversions: within 3 codes.
      EXPECT_LE(worst_code_error(picture, jpeg), 3) << components << progressive;
      ++pictures;
    }
  }
  EXPECT_EQ(pictures, 4);
}

TEST(Jpeg, LinearWhenTold) {
  const auto file = sample::jpeg_file(ramp(1));
  const Picture srgb = decode_picture("a.jpg", file),
                linear = decode_picture("a.jpg", file, {.encoding = Encoding::kLinear});
  EXPECT_FALSE(linear.srgb_decoded);
  for (std::size_t i = 0; i < linear.pixels.size(); ++i) {
    EXPECT_EQ(srgb.pixels.values()[i].g, srgb_decode(linear.pixels.values()[i].g));
  }
}

TEST(Jpeg, InkIsRefused) {
  try {
    decode_picture("a.jpg", sample::jpeg_file(ramp(4)));
    FAIL() << "CMYK was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_NE(std::string(error.what()).find("CMYK"), std::string::npos);
  }
}

/// An APP1 block with one other tag and the orientation.
std::vector<std::uint8_t> exif(int orientation, bool little_endian) {
  std::vector<std::uint8_t> bytes = {'E', 'x', 'i', 'f', 0, 0};
  const auto put = [&](std::uint32_t value, int count) {
    for (int i = 0; i < count; ++i)
      bytes.push_back(static_cast<std::uint8_t>(value >> (8 * (little_endian ? i : count - 1 - i))));
  };
  for (int i = 0; i < 2; ++i) bytes.push_back(little_endian ? 'I' : 'M');
  put(42, 2);
  put(8, 4);  // the directory follows
  put(2, 2);
  put(0x0100, 2), put(3, 2), put(1, 4), put(40, 2), put(0, 2);
  put(0x0112, 2), put(3, 2), put(1, 4), put(static_cast<std::uint32_t>(orientation), 2), put(0, 2);
  put(0, 4);
  return bytes;
}

TEST(Jpeg, OrientationIsNotedNotApplied) {
  for (const bool little_endian : {false, true}) {
    EXPECT_EQ(exif_orientation(exif(6, little_endian)), 6);
    sample::Jpeg jpeg = ramp(3);
    jpeg.app1 = exif(6, little_endian);
    const Picture turned = decode_picture("a.jpg", sample::jpeg_file(jpeg));
    EXPECT_EQ(turned.notes.size(), 2u);  // sRGB is the other
    EXPECT_EQ(turned.pixels.width(), 40);
    jpeg.app1 = exif(1, little_endian);
    EXPECT_EQ(decode_picture("a.jpg", sample::jpeg_file(jpeg)).notes.size(), 1u);
  }
}

TEST(Jpeg, AnyExifBytesAreSafe) {
  const std::vector<std::uint8_t> whole = exif(6, true);
  std::size_t tried = 0;
  for (std::size_t length = 0; length < whole.size(); ++length, ++tried) {
    const std::vector<std::uint8_t> part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
    const int orientation = exif_orientation(part);
    EXPECT_TRUE(orientation == 0 || orientation == 6);
  }
  for (std::size_t at = 6; at < whole.size(); ++at) {
    for (const int value : {0, 1, 127, 128, 255}) {
      std::vector<std::uint8_t> changed = whole;
      changed[at] = static_cast<std::uint8_t>(value);
      exif_orientation(changed);
      ++tried;
    }
  }
  EXPECT_EQ(tried, whole.size() + 5 * (whole.size() - 6));
}

}  // namespace
}  // namespace zonal
