#include "zonal/io/png.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "zonal/base/error.h"
#include "zonal/image/color.h"
#include "zonal/io/sample_files_test.h"

namespace zonal {
namespace {

using sample::png_file;

Picture decode(const sample::Png& png, Encoding encoding = Encoding::kAuto) {
  return decode_picture("test.png", png_file(png), {.encoding = encoding});
}

float srgb(int code, int largest = 255) { return srgb_decode(static_cast<float>(code) / static_cast<float>(largest)); }
Rgb grey(float value) { return {value, value, value}; }

TEST(Png, ColourAndGreyOfEightAndSixteenBits) {
  const Picture rgb = decode({.width = 2, .height = 1, .rows = {0, 128, 255, 1, 2, 3}});
  EXPECT_EQ(rgb.format, "PNG");
  EXPECT_EQ(rgb.channels, 3);
  EXPECT_TRUE(rgb.srgb_decoded);
  EXPECT_EQ(rgb.notes.size(), 1u);
  EXPECT_EQ(rgb.pixels(0, 0), Rgb(0, srgb(128), 1));
  EXPECT_EQ(rgb.pixels(1, 0), Rgb(srgb(1), srgb(2), srgb(3)));

  const Picture wide = decode({.width = 1, .height = 1, .bits = 16, .rows = {0x12, 0x34, 0xff, 0xff, 0x00, 0x01}});
  EXPECT_EQ(wide.pixels(0, 0), Rgb(srgb(0x1234, 65535), 1, srgb(1, 65535)));

  const Picture one = decode({.width = 1, .height = 2, .color_type = PNG_COLOR_TYPE_GRAY, .rows = {7, 200}});
  EXPECT_EQ(one.channels, 1);
  EXPECT_EQ(one.pixels(0, 1), grey(srgb(200)));
  const Picture one_wide =
      decode({.width = 1, .height = 1, .bits = 16, .color_type = PNG_COLOR_TYPE_GRAY, .rows = {0x80, 0x01}});
  EXPECT_EQ(one_wide.pixels(0, 0), grey(srgb(0x8001, 65535)));
}

TEST(Png, GreyOfOneTwoAndFourBits) {
  // One byte holds 8, 4 or 2 pixels; the largest code is white.
  int compared = 0;
  for (const int bits : {1, 2, 4}) {
    const int width = 8 / bits, largest = (1 << bits) - 1;
    const Picture picture =
        decode({.width = width, .height = 1, .bits = bits, .color_type = PNG_COLOR_TYPE_GRAY, .rows = {0xb4}});
    for (int x = 0; x < width; ++x) {
      const int code = 0xb4 >> (8 - bits * (x + 1)) & largest;
      EXPECT_EQ(picture.pixels(x, 0), grey(srgb(code * 255 / largest))) << bits << " " << x;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 8 + 4 + 2);
}

TEST(Png, AlphaIsLeftOutAndSaid) {
  const Picture rgba = decode({.width = 1, .height = 1, .color_type = PNG_COLOR_TYPE_RGBA, .rows = {10, 20, 30, 0}});
  EXPECT_TRUE(rgba.alpha);
  EXPECT_EQ(rgba.channels, 4);
  EXPECT_EQ(rgba.pixels(0, 0), Rgb(srgb(10), srgb(20), srgb(30)));
  EXPECT_EQ(rgba.notes.size(), 2u);
  const Picture ga =
      decode({.width = 1, .height = 1, .bits = 16, .color_type = PNG_COLOR_TYPE_GRAY_ALPHA, .rows = {1, 2, 3, 4}});
  EXPECT_EQ(ga.channels, 2);
  EXPECT_EQ(ga.pixels(0, 0), grey(srgb(0x0102, 65535)));
}

TEST(Png, PaletteOfEveryDepth) {
  std::vector<png_color> palette;
  for (int i = 0; i < 256; ++i)
    palette.push_back({static_cast<png_byte>(i), static_cast<png_byte>(255 - i), static_cast<png_byte>(i / 2)});
  int compared = 0;
  for (const int bits : {1, 2, 4, 8}) {
    const std::vector<png_color> some(palette.begin(), palette.begin() + (1 << bits));
    const Picture picture = decode({.width = 8 / bits,
                                    .height = 1,
                                    .bits = bits,
                                    .color_type = PNG_COLOR_TYPE_PALETTE,
                                    .rows = {0x6d},
                                    .palette = some});
    EXPECT_FALSE(picture.alpha);
    for (int x = 0; x < 8 / bits; ++x) {
      const int i = 0x6d >> (8 - bits * (x + 1)) & ((1 << bits) - 1);
      EXPECT_EQ(picture.pixels(x, 0), Rgb(srgb(i), srgb(255 - i), srgb(i / 2)));
      ++compared;
    }
  }
  EXPECT_EQ(compared, 8 + 4 + 2 + 1);
  const Picture clear = decode({.width = 1,
                                .height = 1,
                                .color_type = PNG_COLOR_TYPE_PALETTE,
                                .rows = {1},
                                .palette = palette,
                                .palette_alpha = {0, 128}});
  EXPECT_TRUE(clear.alpha);
  EXPECT_EQ(clear.pixels(0, 0), Rgb(srgb(1), srgb(254), 0));
}

TEST(Png, InterlacedIsTheSamePicture) {
  std::vector<std::uint8_t> rows;
  for (int i = 0; i < 3 * 13 * 11; ++i) rows.push_back(static_cast<std::uint8_t>(i * 37));
  const sample::Png plain = {.width = 13, .height = 11, .rows = rows};
  sample::Png interlaced = plain;
  interlaced.interlaced = true;
  ASSERT_NE(png_file(plain), png_file(interlaced));
  EXPECT_EQ(decode(plain).pixels, decode(interlaced).pixels);
}

TEST(Png, EncodingComesFromTheOptionsThenTheFile) {
  const sample::Png png = {.width = 1, .height = 1, .rows = {51, 102, 255}};
  sample::Png linear = png, odd = png;
  linear.gamma = 1;
  odd.gamma = 0.6;
  EXPECT_EQ(decode(png, Encoding::kLinear).pixels(0, 0), Rgb(0.2f, 0.4f, 1));
  EXPECT_FALSE(decode(png, Encoding::kLinear).srgb_decoded);
  EXPECT_EQ(decode(linear).pixels(0, 0), Rgb(0.2f, 0.4f, 1));
  EXPECT_EQ(decode(linear, Encoding::kSrgb).pixels(0, 0), Rgb(srgb(51), srgb(102), 1));
  EXPECT_EQ(decode(odd).pixels(0, 0), Rgb(srgb(51), srgb(102), 1));
  EXPECT_EQ(decode(odd).notes.size(), 2u);
}

TEST(Png, RoundTripOfEveryCodeIsExact) {
  const sample::TemporaryFolder folder;
  for (const int bits : {8, 16}) {
    for (const bool linear : {false, true}) {
      const int count = 1 << bits;
      Image<Rgb> image(256, count / 256);
      for (int i = 0; i < count; ++i) {
        const float value = static_cast<float>(i) / static_cast<float>(count - 1);
        image.values()[static_cast<std::size_t>(i)] = grey(linear ? value : srgb_decode(value));
      }
      const SaveReport report = save_picture(image, folder / "a.png", {.png_bits = bits, .png_linear = linear});
      EXPECT_EQ(report.clipped_pixels, 0);
      const Picture back = load_picture(folder / "a.png");
      EXPECT_EQ(back.srgb_decoded, !linear);
      EXPECT_EQ(back.pixels, image) << bits << linear;
    }
  }
}

TEST(Png, ValuesBetweenCodesAreRoundedToTheNearest) {
  const sample::TemporaryFolder folder;
  const int count = 1000;
  Image<Rgb> image(count, 1);
  for (int x = 0; x < count; ++x) image(x, 0) = grey(static_cast<float>(x) / (count - 1));
  save_picture(image, folder / "a.png");
  const Image<Rgb> back = load_picture(folder / "a.png").pixels;
  for (int x = 0; x < count; ++x) {
    // Half a code in the encoded scale; 1e-6 for the two rounded curves.
    EXPECT_LE(std::abs(srgb_encode(back(x, 0).r) - srgb_encode(image(x, 0).r)), 0.5 / 255 + 1e-6) << x;
  }
}

TEST(Png, WhatDoesNotFitIsClippedAndCounted) {
  const sample::TemporaryFolder folder;
  Image<Rgb> image(4, 1, grey(0.5f));
  image(0, 0) = Rgb(-0.1f, 2, 0.5f);
  image(1, 0) = grey(std::numeric_limits<float>::quiet_NaN());
  image(2, 0).b = std::numeric_limits<float>::infinity();
  EXPECT_EQ(save_picture(image, folder / "a.png").clipped_pixels, 3);
  const Image<Rgb> back = load_picture(folder / "a.png").pixels;
  EXPECT_EQ(back(0, 0).r, 0);
  EXPECT_EQ(back(0, 0).g, 1);
  EXPECT_EQ(back(1, 0), grey(0));
  EXPECT_EQ(back(2, 0).b, 1);
}

TEST(Png, DisplayPicturesKeepTheirBytes) {
  Image<Rgb8> image(16, 16);
  for (int i = 0; i < 256; ++i)
    image.values()[static_cast<std::size_t>(i)] = {static_cast<std::uint8_t>(i), 7, static_cast<std::uint8_t>(255 - i)};
  const Picture back = decode_picture("a.png", encode_png(image));
  for (int i = 0; i < 256; ++i)
    EXPECT_EQ(back.pixels.values()[static_cast<std::size_t>(i)], Rgb(srgb(i), srgb(7), srgb(255 - i)));
}

}  // namespace
}  // namespace zonal
