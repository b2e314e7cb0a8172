#include "zonal/io/hdr.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "zonal/base/error.h"
#include "zonal/io/sample_files_test.h"

namespace zonal {
namespace {

using sample::bytes_of;
using sample::operator+;

const std::string kHeader = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";

Picture decode(std::vector<std::byte> bytes) { return decode_picture("test.hdr", std::move(bytes)); }

std::string error_of(std::vector<std::byte> bytes) {
  try {
    decode(std::move(bytes));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    return error.what();
  }
  return "";
}

Image<Rgb> round_trip(const Image<Rgb>& image, SaveReport* report = nullptr) {
  const sample::TemporaryFolder folder;
  const SaveReport saved = save_picture(image, folder / "a.hdr");
  if (report) *report = saved;
  return load_picture(folder / "a.hdr").pixels;
}

TEST(Hdr, OneIsExactlyOne) {
  const Picture picture = decode(bytes_of(kHeader + "-Y 1 +X 1\n") + bytes_of({128, 64, 0, 129}));
  EXPECT_EQ(picture.format, "Radiance HDR");
  EXPECT_FALSE(picture.srgb_decoded);
  EXPECT_EQ(picture.pixels(0, 0), Rgb(1, 0.5f, 0));
}

TEST(Hdr, FlatPixelsAndOldRuns) {
  // 5 pixels: one, a run of 3, one more.
  const Picture runs =
      decode(bytes_of(kHeader + "-Y 1 +X 5\n") + bytes_of({128, 0, 0, 129, 1, 1, 1, 3, 0, 128, 0, 130}));
  for (int x = 0; x < 4; ++x) EXPECT_EQ(runs.pixels(x, 0), Rgb(1, 0, 0)) << x;
  EXPECT_EQ(runs.pixels(4, 0), Rgb(0, 2, 0));
  // A second run in a row counts in units of 256: 1 + 4 + 2 * 256 pixels.
  const Picture longer =
      decode(bytes_of(kHeader + "-Y 1 +X 517\n") + bytes_of({128, 0, 0, 129, 1, 1, 1, 4, 1, 1, 1, 2}));
  int same = 0;
  for (const Rgb& pixel : longer.pixels.values()) same += pixel == Rgb(1, 0, 0);
  EXPECT_EQ(same, 517);
}

TEST(Hdr, NewRunsAndLiterals) {
  // Width 8: red a run, green literals, blue a run and literals, one exponent.
  const auto row = bytes_of({2, 2, 0, 8, 136, 128, 8, 128, 64, 32, 16, 8, 4, 2, 1, 133, 0, 3, 1, 2, 3, 136, 129});
  const Picture picture = decode(bytes_of(kHeader + "-Y 1 +X 8\n") + row);
  for (int x = 0; x < 8; ++x) {
    EXPECT_EQ(picture.pixels(x, 0),
              Rgb(1, std::exp2(-static_cast<float>(x)), x < 5 ? 0 : static_cast<float>(x - 4) / 128))
        << x;
  }
}

TEST(Hdr, AllEightOrientationsGiveTheSamePicture) {
  // Red tells the column 0..2, green the row 0..1 of the upright picture.
  const auto pixel = [](int x, int y) { return bytes_of({64 * x, 64 * y, 128, 129}); };
  int orientations = 0;
  for (const bool columns : {false, true}) {
    for (const bool x_reversed : {false, true}) {
      for (const bool y_reversed : {false, true}) {
        const std::string y_axis = std::string(y_reversed ? "+Y" : "-Y") + " 2",
                          x_axis = std::string(x_reversed ? "-X" : "+X") + " 3";
        std::vector<std::byte> bytes =
            bytes_of(kHeader + (columns ? x_axis + " " + y_axis : y_axis + " " + x_axis) + "\n");
        for (int slow = 0; slow < (columns ? 3 : 2); ++slow) {
          for (int fast = 0; fast < (columns ? 2 : 3); ++fast) {
            const int x = columns ? slow : fast, y = columns ? fast : slow;
            bytes = bytes + pixel(x_reversed ? 2 - x : x, y_reversed ? 1 - y : y);
          }
        }
        const Picture picture = decode(bytes);
        ASSERT_EQ(picture.pixels.width(), 3);
        ASSERT_EQ(picture.pixels.height(), 2);
        for (int y = 0; y < 2; ++y) {
          for (int x = 0; x < 3; ++x) {
            EXPECT_EQ(picture.pixels(x, y), Rgb(0.5f * static_cast<float>(x), 0.5f * static_cast<float>(y), 1))
                << columns << x << y;
          }
        }
        ++orientations;
      }
    }
  }
  EXPECT_EQ(orientations, 8);
}

TEST(Hdr, ExposureAndColourCorrectionAreDividedOut) {
  const auto with = [](const std::string& lines) {
    return decode(bytes_of("#?RGBE\n" + lines + "\n-Y 1 +X 1\n") + bytes_of({128, 128, 128, 129}));
  };
  EXPECT_EQ(with("EXPOSURE=2\nEXPOSURE= 4.0\n").pixels(0, 0), Rgb(0.125f, 0.125f, 0.125f));
  EXPECT_EQ(with("COLORCORR=1 2 4\r\nEXPOSURE=0.5\r\n").pixels(0, 0), Rgb(2, 1, 0.5f));
  EXPECT_EQ(with("EXPOSURE=2\n").notes.size(), 1u);
  EXPECT_EQ(with("EXPOSURE=          1.0000000000000\n").notes.size(), 0u);
  // Programs in use write 0 and mean "none".
  for (const char* nonsense : {"EXPOSURE=0", "EXPOSURE=-1", "EXPOSURE=none", "EXPOSURE=inf", "COLORCORR=1 2"}) {
    const Picture picture = with(std::string(nonsense) + "\n");
    EXPECT_EQ(picture.pixels(0, 0), Rgb(1, 1, 1)) << nonsense;
    EXPECT_EQ(picture.notes.size(), 1u) << nonsense;
  }
}

TEST(Hdr, WhatIsIgnoredIsNoted) {
  const auto notes = [](const std::string& line) {
    return decode(bytes_of("#?RGBE\n" + line + "\n\n-Y 1 +X 1\n") + bytes_of({128, 128, 128, 129})).notes.size();
  };
  EXPECT_EQ(notes("PRIMARIES=0 0 0 0 0 0 0 0"), 0u);
  EXPECT_EQ(notes("PRIMARIES=0.64 0.33 0.3 0.6 0.15 0.06 0.3127 0.329"), 0u);
  EXPECT_EQ(notes("PRIMARIES=0.7 0.3 0.2 0.7 0.1 0.05 0.3127 0.329"), 1u);
  EXPECT_EQ(notes("PIXASPECT=1"), 0u);
  EXPECT_EQ(notes("PIXASPECT=2"), 1u);
  EXPECT_EQ(notes("VIEW= -vtv"), 0u);
}

TEST(Hdr, BrokenFilesSayWhatIsBroken) {
  const auto body = [](const std::string& size, const std::vector<int>& bytes) {
    return bytes_of(kHeader + size + "\n") + bytes_of(bytes);
  };
  EXPECT_NE(error_of(bytes_of("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n")).find("XYZ"), std::string::npos);
  EXPECT_NE(error_of(bytes_of("#?RADIANCE\nFORMAT=something\n\n")).find("unknown format"), std::string::npos);
  EXPECT_NE(error_of(body("-Y 1 X 1", {1, 2, 3, 4})).find("resolution"), std::string::npos);
  EXPECT_NE(error_of(body("-Y 1 -Y 1", {1, 2, 3, 4})).find("resolution"), std::string::npos);
  EXPECT_NE(error_of(body("-Y 0 +X 1", {1, 2, 3, 4})).find("resolution"), std::string::npos);
  EXPECT_NE(error_of(body("-Y 1 +X 2", {1, 1, 1, 1, 5, 5, 5, 5})).find("repetition of nothing"), std::string::npos);
  EXPECT_NE(error_of(body("-Y 1 +X 2", {9, 9, 9, 9, 1, 1, 1, 2})).find("longer than its row"), std::string::npos);
  EXPECT_NE(error_of(body("-Y 1 +X 2", {9, 9, 9, 9, 1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0}))
                .find("longer than its row"),
            std::string::npos);
  EXPECT_NE(error_of(body("-Y 1 +X 8", {2, 2, 0, 9, 136, 0})).find("another width"), std::string::npos);
  EXPECT_NE(error_of(body("-Y 1 +X 8", {2, 2, 0, 8, 137, 0})).find("longer than its row"), std::string::npos);
  EXPECT_NE(error_of(body("-Y 1 +X 8", {2, 2, 0, 8, 0, 0})).find("no length"), std::string::npos);
  EXPECT_NE(error_of(bytes_of("#?RADIANCE\n" + std::string(2 << 20, 'x'))).find("does not end"), std::string::npos);
}

TEST(Hdr, RoundTripIsWithinHalfAStepOfTheSharedExponent) {
  int compared = 0;
  for (const int width : {1, 7, 8, 9, 200, 1000}) {  // under 8 pixels rows are flat
    Image<Rgb> image = sample::random_picture(width, 11, static_cast<unsigned>(width));
    for (Rgb& pixel : image.values()) pixel = Rgb(std::abs(pixel.r), std::abs(pixel.g), std::abs(pixel.b));
    SaveReport report;
    const Image<Rgb> back = round_trip(image, &report);
    EXPECT_EQ(report.clipped_pixels, 0);
    ASSERT_EQ(back.size(), image.size());
    for (std::size_t i = 0; i < image.size(); ++i) {
      const Rgb a = image.values()[i], b = back.values()[i];
      // The largest mantissa is at least 128 (of 256), so half a step is at most 1/256 of the largest channel.
      const float bound = max_channel(a) / 256;
      EXPECT_LE(std::abs(a.r - b.r), bound);
      EXPECT_LE(std::abs(a.g - b.g), bound);
      EXPECT_LE(std::abs(a.b - b.b), bound);
      ++compared;
    }
    EXPECT_EQ(round_trip(back), back);  // what the format holds, it holds exactly
  }
  EXPECT_EQ(compared, 11 * (1 + 7 + 8 + 9 + 200 + 1000));
}

TEST(Hdr, RunsOfEveryLengthSurvive) {
  // Runs of 1..300 equal pixels after each other: every split into runs (at most 127) and literals (at most 128).
  std::vector<Rgb> pixels;
  for (int length = 1; length <= 300; ++length) {
    const Rgb color(static_cast<float>(length % 2 + 1), static_cast<float>(length % 3),
                    static_cast<float>(length % 5) / 4);
    pixels.insert(pixels.end(), static_cast<std::size_t>(length % 150 + 1), color);
  }
  Image<Rgb> image(static_cast<int>(pixels.size()), 1);
  std::copy(pixels.begin(), pixels.end(), image.values().begin());
  ASSERT_LT(image.width(), 32768);
  EXPECT_EQ(round_trip(image), image);
  Image<Rgb> wide(40000, 2, Rgb(1, 0.5f, 2));  // too wide for the run-length code: flat
  wide(39999, 1) = Rgb(8, 8, 8);
  EXPECT_EQ(round_trip(wide), wide);
}

TEST(Hdr, EveryRgbeThatTheWriterCanMeanSurvives) {
  // All exponents (rows), and mantissas whose largest is normalised (128..255), as any writer makes them.
  Image<Rgb> image(128, 255);
  for (int e = 1; e < 256; ++e) {
    for (int m = 128; m < 256; ++m) {
      image(m - 128, e - 1) =
          Rgb(std::ldexp(static_cast<float>(m), e - 136), std::ldexp(static_cast<float>(255 - m), e - 136), 0);
    }
  }
  EXPECT_EQ(round_trip(image), image);
}

TEST(Hdr, WhatDoesNotFitIsClippedAndCounted) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
  Image<Rgb> image(5, 1, Rgb(1, 1, 1));
  image(0, 0) = Rgb(-1, 2, -3);
  image(1, 0) = Rgb(kNan, 1, 1);
  image(2, 0) = Rgb(kInf, 0, 0);
  image(3, 0) = Rgb(3e38f, 0, 0);
  SaveReport report;
  const Image<Rgb> back = round_trip(image, &report);
  EXPECT_EQ(report.clipped_pixels, 4);
  EXPECT_EQ(back(0, 0), Rgb(0, 2, 0));
  EXPECT_EQ(back(1, 0), Rgb(0, 1, 1));
  EXPECT_EQ(back(2, 0), Rgb(std::ldexp(255.0f, 119), 0, 0));
  EXPECT_EQ(back(3, 0), Rgb(std::ldexp(255.0f, 119), 0, 0));
  EXPECT_EQ(back(4, 0), Rgb(1, 1, 1));
}

TEST(Hdr, DarkPixelsRoundToBlack) {
  const Image<Rgb> back = round_trip(Image<Rgb>(3, 1, Rgb(1e-42f, 0, 1e-40f)));
  for (const Rgb& pixel : back.values()) EXPECT_EQ(pixel, Rgb(0, 0, 0));
}

}  // namespace
}  // namespace zonal
