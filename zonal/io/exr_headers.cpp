#include "zonal/io/exr_headers.h"

#include <algorithm>
#include <array>

namespace zonal {
namespace {

// Bits of the version field.
constexpr std::uint32_t kTiledFlag = 0x200;
constexpr std::uint32_t kManyPartsFlag = 0x1000;
constexpr std::size_t kLongestName = 255;

std::int64_t read_int(ByteReader& reader) {
  std::uint32_t value = 0;
  for (int shift = 0; shift < 32; shift += 8) value |= std::uint32_t{reader.byte()} << shift;
  return static_cast<std::int32_t>(value);
}

std::string read_name(ByteReader& reader) {
  std::string name;
  for (char c = static_cast<char>(reader.byte()); c != 0; c = static_cast<char>(reader.byte())) {
    if (name.size() == kLongestName) reader.fail("broken OpenEXR: a name in the header does not end");
    name += c;
  }
  return name;
}

/// What decides how much memory a part takes.
struct Part {
  bool has_window = false;
  std::int64_t width = 0, height = 0;
  bool tiled = false;  // else a tile description means nothing
  std::int64_t tile_width = 0, tile_height = 0;
  std::int64_t chunk_count = 0;
  std::uint8_t compression = 0;
};

void check_part(const ByteReader& reader, const Part& part, const LoadOptions& options) {
  if (!part.has_window) reader.fail("broken OpenEXR: the header has no data window");
  check_picture_size(reader, part.width, part.height, options);
  // Rows in one chunk for each compression: none, RLE, ZIPS, ZIP, PIZ, PXR24, B44, B44A, DWAA, DWAB.
  constexpr std::array<std::int64_t, 10> kRows = {1, 1, 1, 16, 32, 16, 32, 32, 32, 256};
  if (part.compression >= kRows.size()) reader.fail("broken OpenEXR: an unknown compression");
  std::int64_t chunks = (part.height + kRows[part.compression] - 1) / kRows[part.compression];
  if (part.tiled) {
    if (part.tile_width <= 0 || part.tile_height <= 0) reader.fail("broken OpenEXR: tiles of no size");
    check_picture_size(reader, part.tile_width, part.tile_height, options);
    chunks = ((part.width + part.tile_width - 1) / part.tile_width) *
             ((part.height + part.tile_height - 1) / part.tile_height);
  }
  // Each chunk has an entry of eight bytes in the table at the front.
  if (std::max(chunks, part.chunk_count) > static_cast<std::int64_t>(reader.size() / 8)) reader.fail_early_end();
}

/// One attribute after its name.
void read_attribute(ByteReader& reader, const std::string& name, Part& part) {
  const std::string type = read_name(reader);
  const std::int64_t bytes = read_int(reader);
  if (bytes < 0 || static_cast<std::uint64_t>(bytes) > reader.remaining()) reader.fail_early_end();
  const std::uint64_t next = reader.position() + static_cast<std::uint64_t>(bytes);
  if (name == "dataWindow" && type == "box2i" && bytes == 16) {
    const std::int64_t left = read_int(reader), top = read_int(reader), right = read_int(reader),
                       bottom = read_int(reader);
    part.has_window = true;
    part.width = right - left + 1;
    part.height = bottom - top + 1;
  } else if (name == "tiles" && type == "tiledesc" && bytes == 9) {
    part.tile_width = read_int(reader);
    part.tile_height = read_int(reader);
  } else if (name == "type" && type == "string" && bytes <= static_cast<std::int64_t>(kLongestName)) {
    std::string kind(static_cast<std::size_t>(bytes), '\0');
    reader.read(std::as_writable_bytes(std::span(kind)));
    part.tiled |= kind == "tiledimage" || kind == "deeptile";
  } else if (name == "chunkCount" && type == "int" && bytes == 4) {
    part.chunk_count = read_int(reader);
    if (part.chunk_count < 0) reader.fail("broken OpenEXR: a negative number of chunks");
  } else if (name == "compression" && bytes == 1) {
    part.compression = reader.byte();
  }
  reader.seek(next);
}

/// Reads one header; false where an empty one ends a list of parts.
bool read_part(ByteReader& reader, bool tiled, const LoadOptions& options) {
  std::string name = read_name(reader);
  if (name.empty()) return false;
  Part part;
  part.tiled = tiled;
  for (; !name.empty(); name = read_name(reader)) read_attribute(reader, name, part);
  check_part(reader, part, options);
  return true;
}

}  // namespace

bool is_exr(ByteReader& reader) { return reader.head(4) == std::vector<std::uint8_t>{0x76, 0x2f, 0x31, 0x01}; }

void check_exr_headers(ByteReader& reader, const LoadOptions& options) {
  reader.seek(4);
  const auto version = static_cast<std::uint32_t>(read_int(reader));
  const bool tiled = (version & kTiledFlag) != 0;
  if (!read_part(reader, tiled, options)) reader.fail("broken OpenEXR: there is no header");
  if ((version & kManyPartsFlag) == 0) return;
  while (read_part(reader, tiled, options)) {
  }
}

}  // namespace zonal
