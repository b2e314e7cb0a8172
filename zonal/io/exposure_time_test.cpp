#include "zonal/io/exposure_time.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "zonal/base/error.h"
#include "zonal/io/exif.h"
#include "zonal/io/file.h"
#include "zonal/io/picture.h"
#include "zonal/io/sample_files_test.h"

namespace zonal {
namespace {

/// An entry of an EXIF directory: up to two 32 bit words in place of a value.
struct Entry {
  int tag;
  int type;  ///< 3 short, 5 rational, 10 signed rational
  std::int32_t top, bottom = 1;
};

/// An EXIF block with the entries in its EXIF directory.
std::vector<std::uint8_t> exif_block(const std::vector<Entry>& entries, bool little_endian) {
  std::vector<std::uint8_t> app1 = {'E', 'x', 'i', 'f', 0, 0};
  const auto put = [&](std::uint32_t value, int count) {
    for (int i = 0; i < count; ++i)
      app1.push_back(static_cast<std::uint8_t>(value >> (8 * (little_endian ? i : count - 1 - i))));
  };
  for (int i = 0; i < 2; ++i) app1.push_back(little_endian ? 'I' : 'M');
  put(42, 2), put(8, 4);
  // The first directory points to the EXIF directory behind it.
  put(1, 2), put(0x8769, 2), put(4, 2), put(1, 4), put(26, 4), put(0, 4);
  put(static_cast<std::uint32_t>(entries.size()), 2);
  std::uint32_t data = 26 + 2 + 12 * static_cast<std::uint32_t>(entries.size()) + 4;
  for (const Entry& e : entries) {
    put(static_cast<std::uint32_t>(e.tag), 2), put(static_cast<std::uint32_t>(e.type), 2), put(1, 4);
    if (e.type == 3) {
      put(static_cast<std::uint32_t>(e.top), 2), put(0, 2);
    } else {
      put(data, 4);
      data += 8;
    }
  }
  put(0, 4);
  for (const Entry& e : entries) {
    if (e.type != 3) put(static_cast<std::uint32_t>(e.top), 4), put(static_cast<std::uint32_t>(e.bottom), 4);
  }
  return app1;
}

/// A JPEG of one colour.
std::vector<std::byte> photograph(const std::vector<Entry>& entries, bool little_endian) {
  sample::Jpeg jpeg{.width = 8, .height = 8};
  jpeg.samples.assign(8 * 8 * 3, 100);
  jpeg.app1 = exif_block(entries, little_endian);
  return sample::jpeg_file(jpeg);
}

/// A PNG of one colour with a chunk after its header: an EXIF block without its magic.
std::vector<std::byte> png_file_with(const std::vector<std::uint8_t>& block) {
  sample::Png png{.width = 8, .height = 8};
  png.rows.assign(8 * 8 * 3, 100);
  std::vector<std::byte> file = sample::png_file(png);
  const auto size = static_cast<std::uint32_t>(block.size() - 6);
  std::vector<std::byte> chunk;
  for (int shift = 24; shift >= 0; shift -= 8) chunk.push_back(static_cast<std::byte>(size >> shift));
  for (const char c : {'e', 'X', 'I', 'f'}) chunk.push_back(static_cast<std::byte>(c));
  for (std::size_t i = 6; i < block.size(); ++i) chunk.push_back(static_cast<std::byte>(block[i]));
  chunk.resize(chunk.size() + 4);  // a checksum, which nobody asks
  constexpr std::ptrdiff_t kHeader = 8 + 25;
  file.insert(file.begin() + kHeader, chunk.begin(), chunk.end());
  return file;
}

std::vector<std::byte> png_photograph(const std::vector<Entry>& entries, bool little_endian) {
  return png_file_with(exif_block(entries, little_endian));
}

constexpr int kTime = 0x829a, kFNumber = 0x829d, kIso = 0x8827, kShutter = 0x9201, kAperture = 0x9202;

const std::vector<Entry> kUsual = {{kTime, 5, 1, 250}, {kFNumber, 5, 56, 10}, {kIso, 3, 1600}};

TEST(ExposureSettings, AreReadFromExif) {
  int read = 0;
  for (const auto& file_of : {photograph, png_photograph}) {
    for (const bool little_endian : {false, true}) {
      const ExposureSettings s = decode_exposure_settings(file_of(kUsual, little_endian));
      EXPECT_EQ(s.seconds, 1.0 / 250);
      EXPECT_EQ(s.f_number, 5.6);
      EXPECT_EQ(s.iso, 1600);
      const ExposureSettings apex =
          decode_exposure_settings(file_of({{kShutter, 10, 8, 1}, {kAperture, 5, 5, 1}}, little_endian));
      EXPECT_NEAR(apex.seconds.value(), 1.0 / 256, 1e-12);
      EXPECT_NEAR(apex.f_number.value(), std::sqrt(32), 1e-12);
      EXPECT_FALSE(apex.iso.has_value());
      const ExposureSettings broken =
          decode_exposure_settings(file_of({{kTime, 5, 1, 0}, {kFNumber, 5, 0, 1}, {kIso, 3, 0}}, little_endian));
      EXPECT_EQ(broken, ExposureSettings{});
      ++read;
    }
  }
  EXPECT_EQ(read, 4);
}

TEST(ExposureSettings, AreReadFromOpenExr) {
  const ExposureSettings s =
      decode_exposure_settings(sample::exr_file(sample::Exr{.seconds = 0.125f, .f_number = 5.5f, .iso = 1600}));
  EXPECT_EQ(s.seconds, 0.125);
  EXPECT_EQ(s.f_number, 5.5);
  EXPECT_EQ(s.iso, 1600);
  EXPECT_EQ(decode_exposure_settings(sample::exr_file(sample::Exr{.seconds = -1})), ExposureSettings{});
  EXPECT_EQ(decode_exposure_settings(sample::exr_file(sample::Exr{})), ExposureSettings{});
}

TEST(ExposureSettings, AnyBytesAreSafe) {
  int tried = 0;
  for (std::vector<std::byte> whole :
       {photograph(kUsual, true), png_photograph(kUsual, true), sample::exr_file(sample::Exr{.seconds = 0.125f})}) {
    const std::size_t end = std::min<std::size_t>(whole.size(), 200);
    for (std::size_t length = 0; length < end; ++length, ++tried) {
      decode_exposure_settings({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)});
    }
    for (std::size_t at = 0; at < end; ++at) {
      for (const int value : {0, 1, 127, 128, 255}) {
        std::vector<std::byte> changed = whole;
        changed[at] = static_cast<std::byte>(value);
        const ExposureSettings s = decode_exposure_settings(changed);
        EXPECT_TRUE(!s.seconds || *s.seconds > 0);
        ++tried;
      }
    }
  }
  EXPECT_GT(tried, 3000);
}

TEST(Exif, ThePngsOrientationIsNoted) {
  // The entry lies in the EXIF directory there; orientation belongs to the first, which holds a pointer: make it one.
  std::vector<std::uint8_t> block = exif_block({}, false);
  constexpr std::size_t kFirstTag = 6 + 8 + 2;
  EXPECT_EQ(exif_orientation(block), 0);
  block[kFirstTag] = 0x01, block[kFirstTag + 1] = 0x12, block[kFirstTag + 9] = 6;
  EXPECT_EQ(exif_orientation(block), 6);
  const Picture picture = decode_picture("a.png", png_file_with(block));
  EXPECT_TRUE(std::any_of(picture.notes.begin(), picture.notes.end(),
                          [](const std::string& note) { return note.find("orientation (6)") != std::string::npos; }));
}

TEST(ExposureSettings, AHugeBlockIsNotRead) {
  std::vector<std::byte> file = png_photograph(kUsual, true);
  constexpr std::size_t kLength = 8 + 25;  // of the chunk
  file[kLength + 1] = static_cast<std::byte>(kLargestExif >> 16);
  EXPECT_EQ(decode_exposure_settings(file), ExposureSettings{});  // it claims more than the file has
  file.resize(2 * kLargestExif);
  EXPECT_EQ(decode_exposure_settings(file), ExposureSettings{});
}

TEST(ExposureSettings, OtherFilesHaveNone) {
  const sample::TemporaryFolder folder;
  write_file(folder / "a.png", std::string_view("\x89PNG, but not for long"));
  write_file(folder / "empty.jpg", std::string_view());
  EXPECT_EQ(read_exposure_settings(folder / "a.png"), ExposureSettings{});
  EXPECT_EQ(read_exposure_settings(folder / "empty.jpg"), ExposureSettings{});
  EXPECT_THROW(read_exposure_settings(folder / "missing.jpg"), Error);
}

TEST(ExposureSettings, ComeFromRealPhotographs) {
  const std::filesystem::path folder = ZONAL_SOURCE_DIR "/../shared/data/mirror_ball/livingroom_exposures";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no real data beside this checkout";
  const double seconds[] = {0.025, 0.1, 0.025, 0.00625};  // reference/exposure_sequences.json
  for (int i = 0; i < 4; ++i) {
    const ExposureSettings s = read_exposure_settings(folder / ("olapietka_raw" + std::to_string(i) + ".jpg"));
    EXPECT_NEAR(s.seconds.value(), seconds[i], 1e-9);
    EXPECT_NEAR(s.f_number.value(), 5.6, 1e-9);
    EXPECT_EQ(s.iso, 1600);
  }
}

TEST(EquivalentSeconds, AllowForApertureSpeedAndFilter) {
  const ExposureSettings as{1.0, 8.0, 100.0};
  EXPECT_NEAR(equivalent_seconds({0.5, 4.0, 100.0}, as), 2, 1e-12);
  EXPECT_NEAR(equivalent_seconds({0.5, 8.0, 400.0}, as), 2, 1e-12);
  EXPECT_NEAR(equivalent_seconds({0.5, 8.0, 100.0, 1.0}, as), 0.05, 1e-12);
  EXPECT_NEAR(equivalent_seconds({0.5, {}, {}}, as), 0.5, 1e-12);
}

TEST(FullCodeLuminance, IsThatOfTheSaturationSpeed) {
  // ISO 100, f/1, 1 s (exposure value 0): 1.2 cd/m².
  EXPECT_NEAR(full_code_luminance({1.0, 1.0, 100.0}).value(), 1.2, 1e-12);
  EXPECT_NEAR(full_code_luminance({1.0, 4.0, 800.0}).value(), 1.2 * 16 / 8, 1e-12);
  EXPECT_FALSE(full_code_luminance({1.0, 4.0, {}}).has_value());
  EXPECT_FALSE(full_code_luminance({1.0, {}, 100.0}).has_value());
}

}  // namespace
}  // namespace zonal
