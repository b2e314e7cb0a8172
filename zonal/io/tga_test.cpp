#include "zonal/io/tga.h"

#include <gtest/gtest.h>

#include "zonal/base/error.h"
#include "zonal/image/color.h"
#include "zonal/io/sample_files_test.h"

namespace zonal {
namespace {

using sample::bytes_of;
using sample::operator+;

struct Tga {
  int type = 2, bits = 24;
  int width = 2, height = 2;
  int descriptor = 0x20;  // top row first
  std::vector<int> data = {};
  std::vector<int> palette = {};
  int palette_bits = 0, palette_first = 0;
  int palette_count = 0;
  std::string id = {};
};

std::vector<std::byte> file_of(const Tga& t) {
  return bytes_of({static_cast<int>(t.id.size()), t.palette_count > 0, t.type, t.palette_first, 0, t.palette_count, 0,
                   t.palette_bits, 0, 0, 0, 0, t.width, 0, t.height, 0, t.bits, t.descriptor}) +
         bytes_of(t.id) + bytes_of(t.palette) + bytes_of(t.data);
}

Picture decode(const Tga& tga) { return decode_picture("a.tga", file_of(tga)); }

float srgb(int code, int largest = 255) { return srgb_decode(static_cast<float>(code) / static_cast<float>(largest)); }
Rgb color(int r, int g, int b) { return {srgb(r), srgb(g), srgb(b)}; }

/// The picture every flavour below shows.
void expect_four_colours(const Picture& picture) {
  EXPECT_EQ(picture.format, "TGA");
  EXPECT_TRUE(picture.srgb_decoded);
  ASSERT_EQ(picture.pixels.size(), 4u);
  EXPECT_EQ(picture.pixels(0, 0), color(255, 0, 0));
  EXPECT_EQ(picture.pixels(1, 0), color(0, 255, 0));
  EXPECT_EQ(picture.pixels(0, 1), color(0, 0, 255));
  EXPECT_EQ(picture.pixels(1, 1), color(255, 255, 255));
}

const std::vector<int> kRgb24 = {0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255};  // stored blue first

TEST(Tga, TrueColourOfEveryDepth) {
  expect_four_colours(decode({.data = kRgb24}));
  const Picture with_alpha =
      decode({.bits = 32, .descriptor = 0x28, .data = {0, 0, 255, 1, 0, 255, 0, 2, 255, 0, 0, 3, 255, 255, 255, 4}});
  expect_four_colours(with_alpha);
  EXPECT_TRUE(with_alpha.alpha);
  const std::vector<int> words = {0x00, 0x7c, 0xe0, 0x03, 0x1f, 0x00, 0xff, 0x7f};
  expect_four_colours(decode({.bits = 15, .data = words}));
  expect_four_colours(decode({.bits = 16, .data = words}));
  EXPECT_FALSE(decode({.bits = 16, .data = words}).alpha);
  EXPECT_TRUE(decode({.bits = 16, .descriptor = 0x21, .data = words}).alpha);
  // 5 bits: code i stands for i / 31.
  EXPECT_EQ(decode({.bits = 16, .width = 1, .height = 1, .data = {0x2a, 0x00}}).pixels(0, 0),
            Rgb(0, srgb(1, 31), srgb(10, 31)));
}

TEST(Tga, AllFourOrigins) {
  expect_four_colours(decode({.descriptor = 0x00, .data = {255, 0, 0, 255, 255, 255, 0, 0, 255, 0, 255, 0}}));
  expect_four_colours(decode({.descriptor = 0x10, .data = {255, 255, 255, 255, 0, 0, 0, 255, 0, 0, 0, 255}}));
  expect_four_colours(decode({.descriptor = 0x30, .data = {0, 255, 0, 0, 0, 255, 255, 255, 255, 255, 0, 0}}));
}

TEST(Tga, Palettes) {
  const std::vector<int> map24 = kRgb24;
  expect_four_colours(
      decode({.type = 1, .bits = 8, .data = {0, 1, 2, 3}, .palette = map24, .palette_bits = 24, .palette_count = 4}));
  expect_four_colours(decode({.type = 1,
                              .bits = 8,
                              .data = {10, 11, 12, 13},
                              .palette = map24,
                              .palette_bits = 24,
                              .palette_first = 10,
                              .palette_count = 4}));
  expect_four_colours(decode({.type = 1,
                              .bits = 16,
                              .data = {0, 0, 1, 0, 2, 0, 3, 0},
                              .palette = map24,
                              .palette_bits = 24,
                              .palette_count = 4}));
  expect_four_colours(decode({.type = 1,
                              .bits = 8,
                              .data = {0, 1, 2, 3},
                              .palette = {0x00, 0x7c, 0xe0, 0x03, 0x1f, 0x00, 0xff, 0x7f},
                              .palette_bits = 15,
                              .palette_count = 4}));
  expect_four_colours(decode({.type = 9,
                              .bits = 8,
                              .data = {0x01, 0, 1, 0x80, 2, 0x00, 3},
                              .palette = map24,
                              .palette_bits = 24,
                              .palette_count = 4}));
  EXPECT_THROW(
      decode({.type = 1, .bits = 8, .data = {0, 1, 2, 4}, .palette = map24, .palette_bits = 24, .palette_count = 4}),
      Error);
}

TEST(Tga, GreyPlainAndWithAlpha) {
  const Picture picture = decode({.type = 3, .bits = 8, .data = {0, 85, 170, 255}});
  EXPECT_EQ(picture.channels, 1);
  EXPECT_EQ(picture.pixels(0, 1), color(170, 170, 170));
  const Picture with_alpha = decode({.type = 3, .bits = 16, .descriptor = 0x28, .data = {0, 9, 85, 9, 170, 9, 255, 9}});
  EXPECT_EQ(with_alpha.channels, 2);
  EXPECT_EQ(with_alpha.pixels, picture.pixels);
  EXPECT_EQ(decode({.type = 11, .bits = 8, .data = {0x03, 0, 85, 170, 255}}).pixels, picture.pixels);
}

TEST(Tga, RunsAndLiteralsAcrossRows) {
  expect_four_colours(decode({.type = 10, .data = {0x03, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255}}));
  // One run covers the end of the first row and the beginning of the second.
  const Picture picture = decode({.type = 10, .data = {0x00, 0, 0, 255, 0x81, 0, 255, 0, 0x00, 255, 255, 255}});
  EXPECT_EQ(picture.pixels(0, 0), color(255, 0, 0));
  EXPECT_EQ(picture.pixels(1, 0), color(0, 255, 0));
  EXPECT_EQ(picture.pixels(0, 1), color(0, 255, 0));
  EXPECT_EQ(picture.pixels(1, 1), color(255, 255, 255));
}

TEST(Tga, TheIdAndAFooterAreSkipped) {
  const auto file = file_of({.data = kRgb24, .id = "made by hand"}) + std::vector<std::byte>(8) +
                    bytes_of("TRUEVISION-XFILE.") + std::vector<std::byte>(1);
  expect_four_colours(decode_picture("a.tga", file));
}

TEST(Tga, HeadersThatMakeNoSenseAreAnotherFormat) {
  const std::vector<Tga> odd = {
      {.type = 4},   {.type = 0},          {.type = 32},           {.bits = 12},           {.width = 0},
      {.height = 0}, {.descriptor = 0xc0}, {.type = 1, .bits = 8}, {.type = 3, .bits = 24}};
  int refused = 0;
  for (Tga tga : odd) {
    tga.data = std::vector<int>(64);
    const std::vector<std::byte> bytes = file_of(tga);
    ByteReader reader("a.tga", bytes);
    EXPECT_FALSE(load_tga(reader, {}, {}).has_value()) << refused;
    EXPECT_THROW(decode_picture("a.tga", bytes), Error);
    ++refused;
  }
  EXPECT_EQ(refused, 9);
}

}  // namespace
}  // namespace zonal
