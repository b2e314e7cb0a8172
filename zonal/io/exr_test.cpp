#include "zonal/io/exr.h"

#include <OpenEXR/ImfTileDescription.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "zonal/base/error.h"
#include "zonal/io/sample_files_test.h"

namespace zonal {
namespace {

using sample::Exr, sample::exr_file, sample::exr_value;

Picture decode(std::vector<std::byte> bytes, const Run& run = {}) {
  return decode_picture("test.exr", std::move(bytes), {}, run);
}

/// The largest difference from the values that exr_file() writes, over all pixels. `first_channel`: the place of R in
/// the file's list.
float worst_error(const Picture& picture, const Exr& spec, int first_channel = 0) {
  EXPECT_EQ(picture.format, "OpenEXR");
  EXPECT_EQ(picture.pixels.width(), spec.width);
  EXPECT_EQ(picture.pixels.height(), spec.height);
  float worst = 0;
  for (int y = 0; y < picture.pixels.height(); ++y) {
    for (int x = 0; x < picture.pixels.width(); ++x) {
      const Rgb p = picture.pixels(x, y);
      const auto want = [&](int c) { return exr_value(first_channel + c, x, y, spec.type); };
      worst = std::max({worst, std::abs(p.r - want(0)), std::abs(p.g - want(1)), std::abs(p.b - want(2))});
    }
  }
  return worst;
}

TEST(Exr, EveryCompressionOfEveryType) {
  int files = 0;
  for (int c = 0; c < Imf::NUM_COMPRESSION_METHODS; ++c) {
    for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT, Imf::UINT}) {
      // 300 rows: two blocks of ours, several chunks of every compression.
      const Exr spec = {.width = 37, .height = 300, .compression = static_cast<Imf::Compression>(c), .type = type};
      const float worst = worst_error(decode(exr_file(spec)), spec);
      const bool block_coded = (c == Imf::B44_COMPRESSION || c == Imf::B44A_COMPRESSION) && type == Imf::HALF;
      const bool cosine_coded = (c == Imf::DWAA_COMPRESSION || c == Imf::DWAB_COMPRESSION) && type != Imf::UINT;
      // A 4x4 block of B44 keeps 6 bits of differences that may reach twice its span of 8: steps of 1/4, half of one
      // for each rounding. DWA at its usual level may change values by what the eye hardly sees: 1/32. Everything else
      // is exact.
      EXPECT_LE(worst, block_coded ? 0.25f : cosine_coded ? 16.0f / 32 : 0.0f) << c << " " << type;
      ++files;
    }
  }
  EXPECT_EQ(files, 10 * 3);
}

TEST(Exr, TilesAndTheLargestLevelOfMipAndRipMaps) {
  int files = 0;
  for (const int levels : {Imf::ONE_LEVEL, Imf::MIPMAP_LEVELS, Imf::RIPMAP_LEVELS}) {
    for (const int tile : {8, 64, 300}) {
      const Exr spec = {.width = 45, .height = 290, .tile = tile, .levels = levels};
      EXPECT_EQ(worst_error(decode(exr_file(spec)), spec), 0) << levels << " " << tile;
      ++files;
    }
  }
  EXPECT_EQ(files, 9);
}

TEST(Exr, ThreadsDoNotChangeAnything) {
  const auto bytes = exr_file(Exr{.width = 64, .height = 1100, .compression = Imf::DWAB_COMPRESSION});
  const Image<Rgb> one = decode(bytes, {.threads = 1}).pixels;
  for (const int threads : {2, 7}) EXPECT_EQ(decode(bytes, {.threads = threads}).pixels, one);
}

TEST(Exr, ARunCanBeStopped) {
  std::stop_source stop;
  stop.request_stop();
  try {
    decode(exr_file(Exr{}), {.stop = stop.get_token()});
    FAIL() << "not stopped";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kCancelled);
  }
}

TEST(Exr, TheDataWindowIsRead) {
  const Exr spec = {.left = -5, .top = 7, .display_width = 100, .display_height = 50};
  const Picture picture = decode(exr_file(spec));
  EXPECT_EQ(worst_error(picture, spec), 0);
  ASSERT_EQ(picture.notes.size(), 1u);
  EXPECT_NE(picture.notes[0].find("20x10 at (-5, 7)"), std::string::npos) << picture.notes[0];
  EXPECT_TRUE(decode(exr_file(Exr{})).notes.empty());
}

TEST(Exr, LuminanceFillsAllChannels) {
  const Picture picture = decode(exr_file(Exr{.channels = {"Y"}}));
  EXPECT_EQ(picture.channels, 1);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 20; ++x) {
      const float v = exr_value(0, x, y);
      EXPECT_EQ(picture.pixels(x, y), Rgb(v, v, v));
    }
  }
}

TEST(Exr, LuminanceChromaIsReconstructed) {
  const Image<Rgb> flat(40, 30, Rgb(0.25f, 0.5f, 2));
  const Picture picture = decode(sample::luminance_chroma_exr_file(flat));
  EXPECT_EQ(picture.channels, 3);
  ASSERT_EQ(picture.pixels.size(), flat.size());
  for (const Rgb& p : picture.pixels.values()) {
    // OpenEXR's writer keeps 7 bits of luminance and 5 of chroma: half a step of the latter, of the largest channel.
    const float tolerance = 2.0f / 64;
    EXPECT_NEAR(p.r, 0.25f, tolerance);
    EXPECT_NEAR(p.g, 0.5f, tolerance);
    EXPECT_NEAR(p.b, 2, tolerance);
  }
}

TEST(Exr, AlphaIsLeftOutAndColourIsNotDivided) {
  const Exr spec = {.channels = {"R", "G", "B", "A"}};
  const Picture picture = decode(exr_file(spec));
  EXPECT_TRUE(picture.alpha);
  EXPECT_EQ(picture.channels, 4);
  EXPECT_EQ(worst_error(picture, spec), 0);
  EXPECT_EQ(picture.notes.size(), 1u);
}

TEST(Exr, ColourInALayerIsFoundAndSaid) {
  const Exr layer = {.channels = {"depth.Z", "left.R", "left.G", "left.B", "left.A"}};
  const Picture picture = decode(exr_file(layer));
  EXPECT_EQ(worst_error(picture, layer, 1), 0);
  EXPECT_TRUE(picture.alpha);
  EXPECT_NE(picture.notes.at(0).find("\"left\""), std::string::npos);
  // The main layer wins over any other.
  const Exr both = {.channels = {"a.R", "a.G", "a.B", "R", "G", "B"}};
  EXPECT_EQ(worst_error(decode(exr_file(both)), both, 3), 0);
  const Exr nested = {
      .channels = {"View Layer.Combined.R", "View Layer.Combined.G", "View Layer.Combined.B", "View Layer.Depth.Z"}};
  EXPECT_EQ(worst_error(decode(exr_file(nested)), nested), 0);
}

TEST(Exr, TheFirstPartWithColourIsRead) {
  const auto part = [](const char* name, int width, std::vector<std::string> channels) {
    return Exr{
        .width = width, .display_width = 30, .display_height = 10, .channels = std::move(channels), .part_name = name};
  };
  const Exr depth = part("depth", 8, {"Z"}), beauty = part("beauty", 30, {"A", "R", "G", "B"}),
            other = part("other", 3, {"R", "G", "B"});
  const Picture picture = decode(exr_file(std::vector<Exr>{depth, beauty, other}));
  EXPECT_EQ(worst_error(picture, beauty, 1), 0);
  EXPECT_NE(picture.notes.at(0).find("\"beauty\""), std::string::npos);
}

TEST(Exr, WithoutColourTheMessageListsTheChannels) {
  try {
    decode(exr_file(Exr{.channels = {"Z", "normal.X"}}));
    FAIL() << "read a picture without colour";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_NE(std::string(error.what()).find("Z"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("normal.X"), std::string::npos);
  }
}

TEST(Exr, BottomRowFirstIsTheSamePicture) {
  const Exr spec = {.height = 300, .order = Imf::DECREASING_Y};
  EXPECT_EQ(worst_error(decode(exr_file(spec)), spec), 0);
}

TEST(Exr, UnfinishedAndDeepFilesAreRefused) {
  const auto message = [](std::vector<std::byte> bytes) {
    try {
      decode(std::move(bytes));
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kInput);
      return std::string(error.what());
    }
    return std::string("read");
  };
  EXPECT_NE(message(exr_file(Exr{.height = 64, .missing_rows = 32})).find("never finished"), std::string::npos);
  EXPECT_NE(message(sample::deep_exr_file()).find("deep"), std::string::npos);
}

TEST(Exr, FloatRoundTripKeepsEveryBit) {
  Image<Rgb> image = sample::random_picture(53, 300, 3);
  image(0, 0) = Rgb(std::numeric_limits<float>::infinity(), -0.0f, std::numeric_limits<float>::denorm_min());
  image(1, 0).r = std::bit_cast<float>(0x7fc12345u);  // a NaN with a payload
  const sample::TemporaryFolder folder;
  EXPECT_EQ(save_picture(image, folder / "a.EXR").clipped_pixels, 0);
  const Image<Rgb> back = load_picture(folder / "a.EXR").pixels;
  ASSERT_EQ(back.size(), image.size());
  EXPECT_EQ(std::memcmp(back.values().data(), image.values().data(), image.size() * sizeof(Rgb)), 0);
}

TEST(Exr, HalfRoundTripIsWithinHalfAStepAndClipsLargeValuesCounted) {
  Image<Rgb> image = sample::random_picture(31, 45, 4);
  image(0, 0) = Rgb(1e6f, -1e6f, 65519);
  image(1, 0).g = std::numeric_limits<float>::infinity();
  const sample::TemporaryFolder folder;
  EXPECT_EQ(save_picture(image, folder / "a.exr", {.exr_half = true}).clipped_pixels, 1);
  const Image<Rgb> back = load_picture(folder / "a.exr").pixels;
  EXPECT_EQ(back(0, 0), Rgb(65504, -65504, 65504));
  EXPECT_EQ(back(1, 0).g, std::numeric_limits<float>::infinity());
  ASSERT_EQ(back.size(), image.size());
  for (std::size_t i = 2; i < image.size(); ++i) {
    const Rgb a = image.values()[i], b = back.values()[i];
    // 11 significant bits; below 2^-14 steps of 2^-24.
    const auto bound = [](float v) { return std::max(std::abs(v) / 2048, std::exp2(-25.0f)); };
    EXPECT_LE(std::abs(a.r - b.r), bound(a.r));
    EXPECT_LE(std::abs(a.g - b.g), bound(a.g));
    EXPECT_LE(std::abs(a.b - b.b), bound(a.b));
  }
}

}  // namespace
}  // namespace zonal
