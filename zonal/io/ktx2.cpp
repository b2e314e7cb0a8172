#include "zonal/io/ktx2.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <numeric>
#include <string_view>

#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/io/file.h"
#include "zonal/io/half.h"
#include "zonal/io/ktx2_check.h"
#include "zonal/io/ktx2_zstd.h"
#include "zonal/io/utf8.h"

namespace zonal {
namespace {

static_assert(std::endian::native == std::endian::little, "texels are stored as they lie in memory");

void append(std::vector<std::byte>& bytes, std::string_view text) {
  const std::span<const std::byte> raw = std::as_bytes(std::span(text));
  bytes.insert(bytes.end(), raw.begin(), raw.end());
}
template <class Word>
void append_word(std::vector<std::byte>& bytes, Word word) {
  const auto raw = std::bit_cast<std::array<std::byte, sizeof(Word)>>(word);
  bytes.insert(bytes.end(), raw.begin(), raw.end());
}
void append_u32(std::vector<std::byte>& bytes, std::uint32_t word) { append_word(bytes, word); }
void append_u64(std::vector<std::byte>& bytes, std::uint64_t word) { append_word(bytes, word); }

/// Khronos Data Format Specification 1.4, section 5: one basic descriptor block with a sample for each channel.
std::vector<std::byte> data_format_descriptor(const TexelLayout& layout) {
  constexpr std::uint32_t kVersion = 2, kModelRgbsda = 1, kPrimariesBt709 = 1, kTransferLinear = 1;
  constexpr std::uint32_t kSigned = 0x40, kFloat = 0x80, kAlpha = 15;
  const std::uint32_t block_bytes = 24 + 16 * layout.channels;
  std::vector<std::byte> bytes;
  append_u32(bytes, 4 + block_bytes);  // total size
  append_u32(bytes, 0);                // vendor Khronos, type basic
  append_u32(bytes, kVersion | block_bytes << 16);
  append_u32(bytes, kModelRgbsda | kPrimariesBt709 << 8 | kTransferLinear << 16);  // flags: straight alpha
  append_u32(bytes, 0);                                                            // a block is 1 x 1 x 1 x 1 texel
  append_u32(bytes, layout.texel_bytes());                                         // in plane 0
  append_u32(bytes, 0);                                                            // and none in planes 4 to 7
  for (std::uint32_t c = 0; c < layout.channels; ++c) {
    const std::uint32_t bits = 8 * layout.channel_bytes;
    const std::uint32_t channel = c == 3 ? kAlpha : c;
    append_u32(bytes, c * bits | (bits - 1) << 16 | (channel | kSigned | kFloat) << 24);
    append_u32(bytes, 0);                                    // at the block's first texel
    append_u32(bytes, std::bit_cast<std::uint32_t>(-1.0f));  // what stands for -1 and 1
    append_u32(bytes, std::bit_cast<std::uint32_t>(1.0f));
  }
  return bytes;
}

void check_metadata(std::string_view key, std::string_view value) {
  const auto fail = [&](const char* why) {
    throw Error(ErrorKind::kUsage, "metadata \"" + std::string(key) + "\" cannot be written: " + why);
  };
  if (key.empty()) fail("the key is empty");
  if (key.starts_with("KTX") || key.starts_with("ktx")) fail("keys beginning with KTX are reserved");
  if (!is_utf8(key) || !is_utf8(value)) fail("it is not UTF-8");
  if (key.find('\0') != key.npos || value.find('\0') != value.npos) fail("it contains a NUL");
  if (key.starts_with("\xEF\xBB\xBF") || value.starts_with("\xEF\xBB\xBF")) fail("it begins with a byte order mark");
}

std::vector<std::byte> key_value_data(const Ktx2Options& options) {
  Ktx2Metadata pairs = options.metadata;
  for (const auto& [key, value] : pairs) check_metadata(key, value);
  check_metadata("writer", options.writer);
  pairs.emplace_back("KTXorientation", "rd");
  pairs.emplace_back("KTXwriter", options.writer);
  std::ranges::sort(pairs);  // by bytes, which for UTF-8 is by code points
  const auto same_key = [](const auto& a, const auto& b) { return a.first == b.first; };
  if (const auto twice = std::ranges::adjacent_find(pairs, same_key); twice != pairs.end()) {
    throw Error(ErrorKind::kUsage, "metadata \"" + twice->first + "\" is given twice");
  }
  std::vector<std::byte> bytes;
  for (const auto& [key, value] : pairs) {
    append_u32(bytes, static_cast<std::uint32_t>(key.size() + value.size() + 2));
    append(bytes, {key.c_str(), key.size() + 1});
    append(bytes, {value.c_str(), value.size() + 1});
    bytes.resize(aligned(bytes.size(), 4));
  }
  return bytes;
}

/// Writes one level's texels and returns how many were clipped. `out` is aligned to its texels.
std::size_t pack_level(const Image<Rgb>& image, TexelFormat format, std::span<std::byte> out) {
  const std::span<const Rgb> texels = image.values();
  if (format == TexelFormat::kRgba16f) {
    return rgba_halves_from_rgb(texels, {reinterpret_cast<std::uint16_t*>(out.data()), 4 * texels.size()});
  }
  std::size_t clipped = 0;
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const auto [r, g, b] = texels[i];
    if (format == TexelFormat::kRgba32f) {
      const std::array<float, 4> rgba = {r, g, b, 1};
      std::memcpy(&out[sizeof rgba * i], rgba.data(), sizeof rgba);
    } else {
      std::array<std::uint16_t, 2> rg;
      clipped += halves_from_floats(std::array{r, g}, rg) > 0;
      std::memcpy(&out[sizeof rg * i], rg.data(), sizeof rg);
    }
  }
  return clipped;
}

void check_chain(const TextureChain& chain) {
  check(!chain.levels.empty(), "a texture has at least one level");
  const bool cube = chain.shape == TextureShape::kCube;
  const auto width = static_cast<std::uint32_t>(chain.levels[0].width());
  const auto height = static_cast<std::uint32_t>(chain.levels[0].height());
  check(width > 0 && height > 0, "a texture has texels");
  if (std::max(width, height / (cube ? 6 : 1)) > kKtx2MaxSide) {
    throw Error(ErrorKind::kUsage, "a texture has at most " + std::to_string(kKtx2MaxSide) + " texels a side");
  }
  check(!cube || height == 6 * width, "a level of a cube is 1:6");
  const std::uint32_t side = cube ? width : height;
  check(chain.levels.size() <= static_cast<std::size_t>(std::bit_width(std::max(width, side))),
        "a chain ends with its level of one texel");
  for (std::uint32_t p = 0; p < chain.levels.size(); ++p) {
    const std::uint32_t rows = side_at_level(side, p) * (cube ? 6 : 1);
    check(chain.levels[p].width() == static_cast<int>(side_at_level(width, p)) &&
              chain.levels[p].height() == static_cast<int>(rows),
          "each level has half the side of the one before");
  }
}

/// Everything before the texels: header, room for the level index, descriptor, key/value data.
void append_head(std::vector<std::byte>& bytes, const TextureChain& chain, const Ktx2Options& options) {
  const TexelLayout& layout = layout_of(options.format);
  const bool cube = chain.shape == TextureShape::kCube;
  const auto width = static_cast<std::uint32_t>(chain.levels[0].width());
  const auto height = cube ? width : static_cast<std::uint32_t>(chain.levels[0].height());
  const auto level_count = static_cast<std::uint32_t>(chain.levels.size());
  const std::vector<std::byte> descriptor = data_format_descriptor(layout), metadata = key_value_data(options);
  const auto descriptor_bytes = static_cast<std::uint32_t>(descriptor.size());
  const auto metadata_bytes = static_cast<std::uint32_t>(metadata.size());
  const auto descriptor_offset = static_cast<std::uint32_t>(kKtx2HeaderBytes + kKtx2LevelIndexBytes * level_count);
  constexpr std::uint32_t kDepth = 0, kLayers = 0;  // not a volume, not an array

  append(bytes, kKtx2Identifier);
  for (const std::uint32_t word :
       {layout.vk_format, layout.channel_bytes, width, height, kDepth, kLayers, cube ? 6u : 1u, level_count,
        options.zstd_level > 0 ? kKtx2Zstandard : kKtx2NoSupercompression, descriptor_offset, descriptor_bytes,
        descriptor_offset + descriptor_bytes, metadata_bytes}) {
    append_u32(bytes, word);
  }
  append_u64(bytes, 0);  // no supercompression global data
  append_u64(bytes, 0);
  bytes.resize(descriptor_offset);
  bytes.insert(bytes.end(), descriptor.begin(), descriptor.end());
  bytes.insert(bytes.end(), metadata.begin(), metadata.end());
}

}  // namespace

Ktx2File encode_ktx2(const TextureChain& chain, const Ktx2Options& options) {
  check_chain(chain);
  const bool compressed = options.zstd_level > 0;
  const TexelLayout& layout = layout_of(options.format);
  Ktx2File file;
  std::vector<std::byte>& bytes = file.bytes;
  append_head(bytes, chain, options);
  if (!compressed) {
    std::size_t most = bytes.size();
    for (const auto& level : chain.levels) most += (level.size() + 1) * layout.texel_bytes();
    bytes.reserve(most);  // growing would hold the file twice
  }
  std::vector<std::byte> texels;  // of one level, while it is compressed
  std::vector<Ktx2Level> levels(chain.levels.size());
  for (std::size_t p = levels.size(); p-- > 0;) {  // the smallest first
    const Image<Rgb>& image = chain.levels[p];
    const std::size_t size = image.size() * layout.texel_bytes();
    const std::size_t offset = compressed ? bytes.size() : aligned(bytes.size(), std::lcm(layout.texel_bytes(), 4u));
    if (compressed) {
      texels.resize(size);
      file.clipped_texels += pack_level(image, options.format, texels);
      bytes.resize(offset + zstd_bound(size));
      bytes.resize(offset + zstd_compress(texels, std::span(bytes).subspan(offset), options.zstd_level));
    } else {
      bytes.resize(offset + size);
      file.clipped_texels += pack_level(image, options.format, std::span(bytes).subspan(offset));
    }
    levels[p] = {offset, bytes.size() - offset, size};
  }
  std::vector<std::byte> index;
  for (const Ktx2Level& level : levels) {
    append_u64(index, level.offset);
    append_u64(index, level.length);
    append_u64(index, level.uncompressed_length);
  }
  std::ranges::copy(index, bytes.begin() + kKtx2HeaderBytes);
  return file;
}

std::size_t save_ktx2(const std::filesystem::path& path, const TextureChain& chain, const Ktx2Options& options) {
  const Ktx2File file = encode_ktx2(chain, options);
  const std::vector<Ktx2Problem> problems = check_ktx2(file.bytes);
  check(problems.empty(), problems.empty() ? "" : problems.front().text.c_str());
  write_file(path, file.bytes);
  return file.clipped_texels;
}

}  // namespace zonal
