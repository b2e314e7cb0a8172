// OpenEXR as a page reads it, in a program of this machine: the same pixels as the command's reader, bit by bit.
#include "zonal/io/exr.h"

#include <OpenEXR/ImfTileDescription.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "zonal/base/error.h"
#include "zonal/io/sample_files_test.h"

namespace zonal {

std::optional<Picture> load_exr_of_page(ByteReader&, const LoadOptions&, const Run&);

namespace {

using sample::Exr, sample::exr_file;

Picture read_in_page(const std::vector<std::byte>& bytes) {
  ByteReader reader("sky.exr", bytes);
  std::optional<Picture> picture = load_exr_of_page(reader, {}, {});
  if (!picture) throw Error(ErrorKind::kInput, "not taken for OpenEXR");
  return *std::move(picture);
}

void expect_as_the_command_reads_it(const std::vector<std::byte>& bytes, const std::string& what) {
  ByteReader reader("sky.exr", bytes);
  const Picture command = load_exr(reader, {}, {}).value(), page = read_in_page(bytes);
  ASSERT_EQ(page.pixels.width(), command.pixels.width()) << what;
  ASSERT_EQ(page.pixels.height(), command.pixels.height()) << what;
  EXPECT_EQ(
      std::memcmp(page.pixels.values().data(), command.pixels.values().data(), command.pixels.size() * sizeof(Rgb)), 0)
      << what;
  EXPECT_EQ(page.format, command.format) << what;
  EXPECT_EQ(page.alpha, command.alpha) << what;
  EXPECT_EQ(page.channels, command.channels) << what;
  EXPECT_EQ(page.notes, command.notes) << what;
}

constexpr std::array kCompressions = {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION,
                                      Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION};

TEST(ExrInAPage, EveryCompressionOfEveryType) {
  for (const Imf::Compression compression : kCompressions) {
    for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT, Imf::UINT}) {
      expect_as_the_command_reads_it(
          exr_file(Exr{.width = 37, .height = 300, .compression = compression, .type = type}),
          std::to_string(compression) + " " + std::to_string(type));
    }
  }
}

TEST(ExrInAPage, TilesAndTheLargestLevelOfMipAndRipMaps) {
  for (const int levels : {Imf::ONE_LEVEL, Imf::MIPMAP_LEVELS, Imf::RIPMAP_LEVELS}) {
    for (const int tile : {8, 64, 300}) {
      expect_as_the_command_reads_it(exr_file(Exr{.width = 45, .height = 290, .tile = tile, .levels = levels}),
                                     std::to_string(levels) + " " + std::to_string(tile));
    }
  }
}

TEST(ExrInAPage, WindowsChannelsLayersAndParts) {
  const auto part = [](const char* name, int width, std::vector<std::string> channels) {
    return Exr{
        .width = width, .display_width = 30, .display_height = 10, .channels = std::move(channels), .part_name = name};
  };
  for (const Exr& spec : {
           Exr{.left = -5, .top = 7, .display_width = 100, .display_height = 50},
           Exr{.channels = {"Y"}},
           Exr{.channels = {"R", "G", "B", "A"}},
           Exr{.channels = {"depth.Z", "left.R", "left.G", "left.B", "left.A"}},
           Exr{.channels = {"a.R", "a.G", "a.B", "R", "G", "B"}},
           Exr{.height = 300, .order = Imf::DECREASING_Y},
           Exr{.width = 1, .height = 1},
       }) {
    expect_as_the_command_reads_it(exr_file(spec), spec.channels[0]);
  }
  expect_as_the_command_reads_it(
      exr_file(std::vector<Exr>{part("depth", 8, {"Z"}), part("beauty", 30, {"A", "R", "G", "B"})}), "parts");
}

/// What is said where it is not read.
std::string refusal(const std::vector<std::byte>& bytes) {
  try {
    read_in_page(bytes);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_NE(error.hint(), "") << error.what();
    return error.what();
  }
  return "read";
}

TEST(ExrInAPage, WhatItDoesNotReadIsRefusedByName) {
  for (const Imf::Compression compression : {Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION, Imf::B44A_COMPRESSION,
                                             Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION}) {
    EXPECT_NE(refusal(exr_file(Exr{.compression = compression})).find("ompression"), std::string::npos) << compression;
  }
  EXPECT_NE(refusal(sample::deep_exr_file()).find("deep"), std::string::npos);
  EXPECT_NE(refusal(sample::luminance_chroma_exr_file(Image<Rgb>(8, 8, Rgb(1, 1, 1)))).find("uminance-chroma"),
            std::string::npos);
  EXPECT_NE(refusal(exr_file(Exr{.channels = {"Z", "normal.X"}})).find("normal.X"), std::string::npos);
  EXPECT_NE(refusal(exr_file(Exr{.height = 64, .missing_rows = 32})), "read");
}

}  // namespace
}  // namespace zonal
