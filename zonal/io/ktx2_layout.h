#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace zonal {

// The fixed parts of a KTX 2.0 file (Khronos, KTX File Format Specification 2.0, section 3), shared by writer, reader
// and checker. All numbers are little-endian; offsets are in bytes from the start of the file.

/// What a texel of a file holds. All are linear; the 32-bit kind keeps every float as it is.
enum class TexelFormat {
  kRg16f,    ///< two halves: red and green; blue is not stored (tables of two numbers)
  kRgba16f,  ///< four halves, alpha 1
  kRgba32f,  ///< four floats, alpha 1
};

struct TexelLayout {
  TexelFormat format;
  std::uint32_t vk_format;  // VkFormat, Vulkan 1.0
  std::uint32_t channels;
  std::uint32_t channel_bytes;

  constexpr std::uint32_t texel_bytes() const { return channels * channel_bytes; }
};

inline constexpr TexelLayout kTexelLayouts[] = {
    {TexelFormat::kRg16f, 83, 2, 2},     // VK_FORMAT_R16G16_SFLOAT
    {TexelFormat::kRgba16f, 97, 4, 2},   // VK_FORMAT_R16G16B16A16_SFLOAT
    {TexelFormat::kRgba32f, 109, 4, 4},  // VK_FORMAT_R32G32B32A32_SFLOAT
};
constexpr const TexelLayout& layout_of(TexelFormat format) { return kTexelLayouts[static_cast<std::size_t>(format)]; }

inline constexpr std::string_view kKtx2Identifier("\xABKTX 20\xBB\r\n\x1A\n", 12);
inline constexpr std::size_t kKtx2HeaderBytes = 80;
inline constexpr std::size_t kKtx2LevelIndexBytes = 24;  // of one level
inline constexpr std::uint32_t kKtx2MaxSide = 1u << 16;  // more than any GPU takes; keeps products inside 64 bits
inline constexpr std::uint32_t kKtx2NoSupercompression = 0;
inline constexpr std::uint32_t kKtx2Zstandard = 2;

struct Ktx2Header {
  std::uint32_t vk_format, type_size;
  std::uint32_t pixel_width, pixel_height, pixel_depth;
  std::uint32_t layer_count, face_count, level_count;
  std::uint32_t supercompression;
  std::uint32_t dfd_offset, dfd_length;  // data format descriptor
  std::uint32_t kvd_offset, kvd_length;  // key/value data
  std::uint64_t sgd_offset, sgd_length;  // supercompression global data
};

/// One entry of the level index.
struct Ktx2Level {
  std::uint64_t offset, length, uncompressed_length;
};

/// The caller has made sure that the bytes are there.
std::uint32_t u32_at(std::span<const std::byte> file, std::size_t offset);
std::uint64_t u64_at(std::span<const std::byte> file, std::size_t offset);
Ktx2Header ktx2_header(std::span<const std::byte> file);
Ktx2Level ktx2_level(std::span<const std::byte> file, std::size_t level);

constexpr std::uint64_t aligned(std::uint64_t offset, std::uint64_t alignment) {
  return (offset + alignment - 1) / alignment * alignment;
}
/// Size of a side at a level of the chain.
constexpr std::uint32_t side_at_level(std::uint32_t side, std::uint32_t level) {
  return side >> level > 0 ? side >> level : 1;
}

}  // namespace zonal
