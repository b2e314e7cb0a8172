#include "zonal/io/ktx2_layout.h"

#include "zonal/base/check.h"

namespace zonal {

std::uint32_t u32_at(std::span<const std::byte> file, std::size_t offset) {
  check(offset + 4 <= file.size(), "u32_at: past the end of the file");
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::to_integer<std::uint32_t>(file[offset + i]) << (8 * i);
  return value;
}

std::uint64_t u64_at(std::span<const std::byte> file, std::size_t offset) {
  return u32_at(file, offset) | std::uint64_t{u32_at(file, offset + 4)} << 32;
}

Ktx2Header ktx2_header(std::span<const std::byte> file) {
  const auto word = [&](std::size_t i) { return u32_at(file, kKtx2Identifier.size() + 4 * i); };
  return {.vk_format = word(0),
          .type_size = word(1),
          .pixel_width = word(2),
          .pixel_height = word(3),
          .pixel_depth = word(4),
          .layer_count = word(5),
          .face_count = word(6),
          .level_count = word(7),
          .supercompression = word(8),
          .dfd_offset = word(9),
          .dfd_length = word(10),
          .kvd_offset = word(11),
          .kvd_length = word(12),
          .sgd_offset = u64_at(file, 64),
          .sgd_length = u64_at(file, 72)};
}

Ktx2Level ktx2_level(std::span<const std::byte> file, std::size_t level) {
  const std::size_t entry = kKtx2HeaderBytes + kKtx2LevelIndexBytes * level;
  return {u64_at(file, entry), u64_at(file, entry + 8), u64_at(file, entry + 16)};
}

}  // namespace zonal
