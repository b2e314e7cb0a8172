#include "zonal/io/exif.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace zonal {
namespace {

constexpr std::array<std::uint8_t, 6> kMagic = {'E', 'x', 'i', 'f', 0, 0};
constexpr std::uint8_t kStartOfImage = 0xd8, kEndOfImage = 0xd9, kStartOfScan = 0xda, kApp1 = 0xe1;

bool starts_with_magic(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= kMagic.size() && std::equal(kMagic.begin(), kMagic.end(), bytes.begin());
}

/// Big-endian; there must be as many bytes.
std::uint32_t big_endian(ByteReader& reader, int bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < bytes; ++i) value = value << 8 | reader.byte();
  return value;
}

std::vector<std::uint8_t> read_block(ByteReader& reader, std::size_t size, std::vector<std::uint8_t> block = {}) {
  const std::size_t before = block.size();
  block.resize(before + size);
  reader.read(std::span(block).subspan(before));
  return block;
}

/// Marker by marker up to the picture's data (ITU T.81, annex B).
std::vector<std::uint8_t> exif_of_jpeg(ByteReader& reader) {
  reader.seek(2);
  while (reader.remaining() >= 4) {
    if (reader.byte() != 0xff) return {};
    std::uint8_t marker = reader.byte();
    while (marker == 0xff && reader.remaining() > 2) marker = reader.byte();  // fill bytes
    if (marker == kStartOfScan || marker == kEndOfImage || marker == kStartOfImage || reader.remaining() < 2) return {};
    const std::uint64_t at = reader.position();
    const std::uint32_t length = big_endian(reader, 2);  // itself included
    if (length < 2 || at + length > reader.size()) return {};
    if (marker == kApp1) {
      std::vector<std::uint8_t> block = read_block(reader, length - 2);
      if (starts_with_magic(block)) return block;
    }
    reader.seek(at + length);
  }
  return {};
}

/// Chunk by chunk: length, type, data, checksum (PNG, third edition, 11.3.4.5). The block lacks the magic of a JPEG's.
std::vector<std::uint8_t> exif_of_png(ByteReader& reader) {
  constexpr std::uint32_t kExifChunk = 'e' << 24 | 'X' << 16 | 'I' << 8 | 'f';
  reader.seek(8);
  while (reader.remaining() >= 12) {
    const std::uint32_t length = big_endian(reader, 4), type = big_endian(reader, 4);
    const std::uint64_t next = reader.position() + length + 4;
    if (next > reader.size()) return {};
    if (type == kExifChunk) {
      if (length > kLargestExif) return {};
      return read_block(reader, length, {kMagic.begin(), kMagic.end()});
    }
    reader.seek(next);
  }
  return {};
}

}  // namespace

std::vector<std::uint8_t> find_exif(ByteReader& reader) {
  const std::vector<std::uint8_t> head = reader.head(8);
  constexpr std::array<std::uint8_t, 3> kJpeg = {0xff, kStartOfImage, 0xff};
  constexpr std::array<std::uint8_t, 8> kPng = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  const auto starts_with = [&](const auto& magic) {
    return head.size() >= magic.size() && std::equal(magic.begin(), magic.end(), head.begin());
  };
  if (starts_with(kJpeg)) return exif_of_jpeg(reader);
  if (starts_with(kPng)) return exif_of_png(reader);
  return {};
}

int exif_orientation(std::span<const std::uint8_t> app1) {
  if (app1.size() < kMagic.size() + 8 || !starts_with_magic(app1)) return 0;
  const auto tiff = app1.subspan(kMagic.size());
  const bool little_endian = tiff[0] == 'I';
  const auto number = [&](std::size_t at, std::size_t bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) value = value << 8 | tiff[at + (little_endian ? bytes - 1 - i : i)];
    return value;
  };
  const std::size_t directory = number(4, 4);
  if (directory > tiff.size() - 2) return 0;
  const std::size_t entries = number(directory, 2);
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t entry = directory + 2 + 12 * i;
    if (entry + 12 > tiff.size()) return 0;
    if (number(entry, 2) == 0x0112) return static_cast<int>(number(entry + 8, 2));
  }
  return 0;
}

}  // namespace zonal
