#include "zonal/io/picture.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <random>

#include "zonal/base/error.h"
#include "zonal/io/sample_files_test.h"

namespace zonal {
namespace {

using sample::bytes_of, sample::Named;
using sample::operator+;

/// Damaged headers may ask for anything; a small limit keeps the tests small.
constexpr LoadOptions kSmall = {.max_pixels = 1 << 20};

TEST(Picture, FormatsAreToldApartByContent) {
  int decoded = 0;
  for (const Named& file : sample::one_of_each()) {
    const Picture picture = decode_picture("misleading.txt", file.bytes);
    EXPECT_FALSE(picture.pixels.empty()) << file.name;
    const bool is_float = file.name.starts_with("exr") || file.name.starts_with("hdr") || file.name.starts_with("pfm");
    EXPECT_EQ(picture.srgb_decoded, !is_float) << file.name;
    ++decoded;
  }
  EXPECT_EQ(decoded, 18 + 10);
}

TEST(Picture, WhatIsNoPictureIsRefused) {
  int refused = 0;
  for (const std::string& text :
       {std::string(), std::string("x"), std::string("hello, world: this is a text file"), std::string(100, '\0'),
        std::string("<svg xmlns='http://www.w3.org/2000/svg'/>"), std::string(1000, '\xff')}) {
    try {
      decode_picture("notes.txt", bytes_of(text));
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kInput);
      EXPECT_TRUE(std::string(error.what()).starts_with("notes.txt: ")) << error.what();
      EXPECT_NE(error.hint(), "");
      ++refused;
    }
  }
  EXPECT_EQ(refused, 6);
  EXPECT_THROW(load_picture("/no/such/file.exr"), Error);
}

TEST(Picture, TruncatedAtAnyLengthIsAnErrorNeverAPicture) {
  std::size_t cut = 0, expected = 0;
  for (const Named& file : sample::one_of_each()) {
    const std::size_t step = file.bytes.size() / 400 + 1;  // every length of small files
    for (std::size_t length = 0; length < file.bytes.size(); length += step, ++expected) {
      // The last byte is where a careless reader would not look.
      const std::size_t kept = length + step >= file.bytes.size() ? file.bytes.size() - 1 : length;
      try {
        decode_picture("cut", {file.bytes.begin(), file.bytes.begin() + static_cast<std::ptrdiff_t>(kept)}, kSmall);
        ADD_FAILURE() << file.name << " was read from " << kept << " of " << file.bytes.size() << " bytes";
      } catch (const Error& error) {
        cut += error.kind() == ErrorKind::kInput;
      }
    }
  }
  EXPECT_EQ(cut, expected);
  EXPECT_GT(cut, 5000u);
}

TEST(Picture, FlippedBytesGiveAPictureOrAnError) {
  std::mt19937 random(20240229);
  int tried = 0, refused = 0, read = 0;
  for (const Named& file : sample::one_of_each()) {
    for (int i = 0; i < 200; ++i, ++tried) {
      std::vector<std::byte> bytes = file.bytes;
      // Half of the changes hit the first 100 bytes: headers are where the traps are.
      const std::size_t reach = i % 2 == 0 ? std::min<std::size_t>(100, bytes.size()) : bytes.size();
      for (int n = 0; n <= i % 3; ++n) bytes[random() % reach] = static_cast<std::byte>(random());
      try {
        read += !decode_picture("flipped", std::move(bytes), kSmall).pixels.empty();
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::kInput);
        ++refused;
      }
    }
  }
  EXPECT_EQ(tried, 28 * 200);
  EXPECT_EQ(read + refused, tried);
  EXPECT_GT(refused, tried / 10);  // else the changes hit nothing
}

/// A sound file whose bytes at `place` are replaced.
std::vector<std::byte> patched(std::vector<std::byte> file, std::size_t place, const std::vector<int>& values) {
  for (const int value : values) file.at(place++) = static_cast<std::byte>(value);
  return file;
}

/// The most memory this process ever held, in bytes.
long peak_memory() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024;
}

/// Far below the pictures that the headers in these tests promise (3 GB and more), far above what a decoder needs.
constexpr long kLittleMemory = 200'000'000;

std::size_t place_of(const std::vector<std::byte>& file, std::string_view text) {
  const auto wanted = bytes_of(text);
  return static_cast<std::size_t>(std::search(file.begin(), file.end(), wanted.begin(), wanted.end()) - file.begin());
}

TEST(Picture, AbsurdSizesAreRefusedBeforeMemoryIsTaken) {
  const std::vector<std::byte> exr = sample::exr_file(sample::Exr{.width = 4, .height = 4});
  // "dataWindow" NUL "box2i" NUL and the attribute's size come before the four numbers.
  const std::size_t window = place_of(exr, "dataWindow") + 11 + 6 + 4;
  const auto jpeg =
      sample::jpeg_file({.width = 8, .height = 8, .components = 1, .samples = std::vector<std::uint8_t>(64)});
  const std::size_t frame = place_of(jpeg, "\xff\xc0") + 5;  // height and width in the frame header
  // 60000 x 40000, 8 bit RGB, and the checksum of that header.
  const auto png = patched(sample::png_file({.width = 8, .height = 2, .rows = std::vector<std::uint8_t>(48)}), 16,
                           {0, 0, 0xea, 0x60, 0, 0, 0x9c, 0x40, 8, 2, 0, 0, 0, 0x87, 0xa4, 0x02, 0x32});
  const std::vector<Named> files = {
      {"exr", patched(exr, window, {0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff, 0, 0, 0xff, 0x7f, 0, 0})},
      {"hdr", bytes_of("#?RADIANCE\n\n-Y 32768 +X 65536\n") + std::vector<std::byte>(270)},
      {"pfm", bytes_of("PF\n65536 32768\n-1\n") + std::vector<std::byte>(280)},
      {"jpeg", patched(jpeg, frame, {0xf0, 0, 0xf0, 0})},
      {"tga",
       bytes_of({0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff, 0xff, 0xff, 24, 0}) + std::vector<std::byte>(282)},
      {"png", png},
  };
  int refused = 0;
  for (const Named& file : files) {
    const long before = peak_memory();
    try {
      decode_picture(file.name, file.bytes);
      ADD_FAILURE() << file.name;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kInput);
      EXPECT_NE(error.hint().find("max-pixels"), std::string::npos) << error.what();
      ++refused;
    }
    EXPECT_LT(peak_memory() - before, kLittleMemory) << file.name;
  }
  EXPECT_EQ(refused, 6);
}

TEST(Picture, TheLimitIsExactAndCanBeRaised) {
  const auto bytes = bytes_of("Pf\n4 3\n-1\n") + std::vector<std::byte>(48);
  EXPECT_EQ(decode_picture("a.pfm", bytes, {.max_pixels = 12}).pixels.size(), 12u);
  EXPECT_THROW(decode_picture("a.pfm", bytes, {.max_pixels = 11}), Error);
}

TEST(Picture, ShortFilesWithLargeHeadersTakeNoMemory) {
  // Below the limit, but the bytes for it are not there.
  int refused = 0;
  for (const std::string& header :
       {std::string("#?RADIANCE\n\n-Y 16000 +X 16000\n"), std::string("PF\n16000 16000\n-1\n")}) {
    const long before = peak_memory();
    EXPECT_THROW(decode_picture("short", bytes_of(header) + std::vector<std::byte>(100)), Error);
    EXPECT_LT(peak_memory() - before, kLittleMemory) << header;
    ++refused;
  }
  EXPECT_EQ(refused, 2);
}

TEST(Picture, FloatFormatsStayLinearAndSaySo) {
  const auto bytes = bytes_of("Pf\n1 1\n-1\n") + bytes_of({0, 0, 0, 0x3f});
  const Picture picture = decode_picture("a.pfm", bytes, {.encoding = Encoding::kSrgb});
  EXPECT_EQ(picture.pixels(0, 0), Rgb(0.5f, 0.5f, 0.5f));
  EXPECT_EQ(picture.notes.size(), 1u);
}

TEST(Picture, SavingGoesByExtension) {
  const sample::TemporaryFolder folder;
  const Image<Rgb> image(3, 2, Rgb(0.5f, 0.5f, 0.5f));
  try {
    save_picture(image, folder / "a.bmp");
    FAIL() << "an unknown extension was written";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kUsage);
  }
  EXPECT_FALSE(can_save_picture("a"));
  int saved = 0;
  for (const char* name : {"a.exr", "a.hdr", "a.pfm", "a.png", "A.PNG"}) {
    EXPECT_TRUE(can_save_picture(name));
    save_picture(image, folder / name);
    EXPECT_EQ(load_picture(folder / name).pixels.size(), 6u);
    EXPECT_EQ(folder.file_count(), static_cast<std::size_t>(++saved));  // and nothing temporary
  }
}

TEST(Picture, AFailedSaveLeavesTheOldFile) {
  const sample::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "a.png");  // a folder stands in the way
  EXPECT_THROW(save_picture(Image<Rgb>(2, 2), folder / "a.png"), Error);
  EXPECT_THROW(save_picture(Image<Rgb>(2, 2), folder / "missing" / "a.exr"), Error);
  EXPECT_EQ(folder.file_count(), 1u);
}

}  // namespace
}  // namespace zonal
