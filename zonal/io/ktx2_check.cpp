#include "zonal/io/ktx2_check.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <string_view>

#include "zonal/io/ktx2_layout.h"
#include "zonal/io/ktx2_zstd.h"
#include "zonal/io/utf8.h"

namespace zonal {
namespace {

class Checker {
 public:
  explicit Checker(std::span<const std::byte> file) : file_(file) {}

  std::vector<Ktx2Problem> run() {
    // Each step relies on the ones before: with a wrong size or offset everything after it would be blamed too.
    if (header() && index() && descriptor() && key_values()) levels();
    return std::move(problems_);
  }

 private:
  void problem(std::uint64_t offset, std::string text) { problems_.push_back({offset, std::move(text)}); }

  /// Compares one number with the only value it may have.
  void expect(std::uint64_t offset, std::string_view field, std::uint64_t found, std::uint64_t expected) {
    if (found == expected) return;
    problem(offset, std::string(field) + " is " + std::to_string(found) + ", must be " + std::to_string(expected));
  }

  bool header() {
    const std::string_view start(reinterpret_cast<const char*>(file_.data()),
                                 std::min(file_.size(), kKtx2Identifier.size()));
    if (start != kKtx2Identifier) {
      problem(0, "not a KTX 2.0 file: the identifier is wrong");
      return false;
    }
    if (file_.size() < kKtx2HeaderBytes) {
      problem(file_.size(), "the file ends inside its header");
      return false;
    }
    header_ = ktx2_header(file_);
    const auto layout = std::ranges::find(kTexelLayouts, header_.vk_format, &TexelLayout::vk_format);
    if (layout == std::end(kTexelLayouts)) {
      problem(12, "vkFormat " + std::to_string(header_.vk_format) + " is none of the texels written here");
      return false;
    }
    layout_ = *layout;
    expect(16, "typeSize", header_.type_size, layout_.channel_bytes);
    for (const auto& [offset, side] : {std::pair(20, header_.pixel_width), std::pair(24, header_.pixel_height)}) {
      if (side == 0 || side > kKtx2MaxSide) problem(offset, "a side of " + std::to_string(side) + " texels");
    }
    expect(28, "pixelDepth", header_.pixel_depth, 0);
    expect(32, "layerCount", header_.layer_count, 0);
    if (header_.face_count != 1 && header_.face_count != 6) {
      problem(36, "faceCount is " + std::to_string(header_.face_count) + ", must be 1 or 6");
    } else if (header_.face_count == 6) {
      expect(24, "pixelHeight of a cube", header_.pixel_height, header_.pixel_width);
    }
    const int most_levels = std::bit_width(std::max(header_.pixel_width, header_.pixel_height));
    if (header_.level_count == 0 || header_.level_count > static_cast<std::uint32_t>(most_levels)) {
      problem(40,
              "levelCount is " + std::to_string(header_.level_count) + ", must be 1 to " + std::to_string(most_levels));
    }
    if (header_.supercompression != kKtx2NoSupercompression && header_.supercompression != kKtx2Zstandard) {
      problem(44, "supercompressionScheme is " + std::to_string(header_.supercompression) + ", must be 0 or 2");
    }
    return problems_.empty();
  }

  bool index() {
    const std::uint64_t descriptor_offset = kKtx2HeaderBytes + kKtx2LevelIndexBytes * header_.level_count;
    const std::uint32_t descriptor_bytes = 4 + 24 + 16 * layout_.channels;
    expect(48, "dfdByteOffset", header_.dfd_offset, descriptor_offset);
    expect(52, "dfdByteLength", header_.dfd_length, descriptor_bytes);
    expect(56, "kvdByteOffset", header_.kvd_offset, descriptor_offset + descriptor_bytes);
    expect(64, "sgdByteOffset", header_.sgd_offset, 0);
    expect(72, "sgdByteLength", header_.sgd_length, 0);
    if (header_.kvd_length == 0 || header_.kvd_length % 4 != 0) {
      problem(60, "kvdByteLength is " + std::to_string(header_.kvd_length) + ", must be a positive multiple of 4");
    }
    if (std::uint64_t{header_.kvd_offset} + header_.kvd_length > file_.size()) {
      problem(60, "the key/value data ends outside the file");
    }
    return problems_.empty();
  }

  bool descriptor() {
    const auto byte = [&](std::uint32_t offset, std::string_view field, std::uint32_t expected) {
      const std::uint32_t at = header_.dfd_offset + offset;
      expect(at, field, std::to_integer<std::uint32_t>(file_[at]), expected);
    };
    const auto half_word = [&](std::uint32_t offset, std::string_view field, std::uint32_t expected) {
      expect(header_.dfd_offset + offset, field,
             u32_at(file_, header_.dfd_offset + offset / 4 * 4) >> 8 * (offset % 4) & 0xffff, expected);
    };
    const auto word = [&](std::uint32_t offset, std::string_view field, std::uint32_t expected) {
      expect(header_.dfd_offset + offset, field, u32_at(file_, header_.dfd_offset + offset), expected);
    };
    word(0, "dfdTotalSize", header_.dfd_length);
    word(4, "vendorId and descriptorType", 0);  // Khronos, basic format
    half_word(8, "descriptor versionNumber", 2);
    half_word(10, "descriptorBlockSize", header_.dfd_length - 4);
    byte(12, "colorModel", 1);        // RGBSDA
    byte(13, "colorPrimaries", 1);    // BT.709
    byte(14, "transferFunction", 1);  // linear
    byte(15, "flags", 0);             // straight alpha
    word(16, "texelBlockDimension", 0);
    word(20, "bytesPlane0 to bytesPlane3", layout_.channels * layout_.channel_bytes);
    word(24, "bytesPlane4 to bytesPlane7", 0);
    constexpr std::uint32_t kSignedFloat = 0xC0;
    constexpr std::uint32_t kChannels[] = {0, 1, 2, 15};  // red, green, blue, alpha
    for (std::uint32_t c = 0; c < layout_.channels; ++c) {
      const std::uint32_t sample = 28 + 16 * c, bits = 8 * layout_.channel_bytes;
      const std::string name = "sample " + std::to_string(c) + ' ';
      half_word(sample, name + "bitOffset", c * bits);
      byte(sample + 2, name + "bitLength", bits - 1);
      byte(sample + 3, name + "channelType and qualifiers", kSignedFloat | kChannels[c]);
      word(sample + 4, name + "samplePosition", 0);
      word(sample + 8, name + "sampleLower", 0xBF800000);   // -1
      word(sample + 12, name + "sampleUpper", 0x3F800000);  // 1
    }
    return problems_.empty();
  }

  bool key_values() {
    const std::uint64_t end = std::uint64_t{header_.kvd_offset} + header_.kvd_length;
    std::string_view previous_key;
    bool orientation = false, writer = false;
    for (std::uint64_t at = header_.kvd_offset; at < end;) {
      const std::uint32_t length =
          u32_at(file_, at);  // every pair begins at a multiple of 4, so that 4 bytes are there
      if (length < 2 || length > end - at - 4) {
        problem(at, "keyAndValueByteLength " + std::to_string(length) + " does not fit");
        return false;
      }
      const std::string_view pair(reinterpret_cast<const char*>(file_.data()) + at + 4, length);
      const std::string_view key = pair.substr(0, pair.find('\0'));
      const std::string_view rest = pair.substr(key.size());  // NUL, value, NUL
      if (key.empty() || rest.empty() || !is_text(key)) problem(at + 4, "a key is not UTF-8 text ended by NUL");
      if (key <= previous_key) problem(at + 4, "the keys are not sorted, or one appears twice");
      previous_key = key;
      const std::string_view value = rest.substr(rest.empty() ? 0 : 1);
      if (value.empty() || value.find('\0') != value.size() - 1 || !is_text(value)) {
        problem(at + 4 + key.size(), "the value of a key is not UTF-8 text ended by NUL");
      }
      const bool reserved = key.starts_with("KTX") || key.starts_with("ktx");
      if (key == "KTXorientation") {
        orientation = true;
        if (value != std::string_view("rd\0", 3)) problem(at + 4 + key.size() + 1, "KTXorientation is not rd");
      } else if (key == "KTXwriter") {
        writer = true;
      } else if (reserved) {
        problem(at + 4, "a reserved key that is not expected here");
      }
      const std::uint64_t pair_end = at + 4 + length;
      at = aligned(pair_end, 4);
      zeros(pair_end, at, "valuePadding");
    }
    if (!orientation) problem(header_.kvd_offset, "KTXorientation is missing");
    if (!writer) problem(header_.kvd_offset, "KTXwriter is missing");
    return problems_.empty();
  }

  void levels() {
    const bool compressed = header_.supercompression == kKtx2Zstandard;
    const std::uint64_t alignment = compressed ? 1 : std::lcm(layout_.texel_bytes(), 4u);
    std::uint64_t cursor = std::uint64_t{header_.kvd_offset} + header_.kvd_length;
    for (std::uint32_t p = header_.level_count; p-- > 0;) {  // as they lie in the file: the smallest first
      const std::uint64_t entry = kKtx2HeaderBytes + kKtx2LevelIndexBytes * p;
      const std::string name = "level " + std::to_string(p) + ' ';
      const Ktx2Level level = ktx2_level(file_, p);
      const std::uint64_t size = std::uint64_t{side_at_level(header_.pixel_width, p)} *
                                 side_at_level(header_.pixel_height, p) * header_.face_count * layout_.texel_bytes();
      expect(entry + 16, name + "uncompressedByteLength", level.uncompressed_length, size);
      expect(entry, name + "byteOffset", level.offset, aligned(cursor, alignment));
      if (!compressed) expect(entry + 8, name + "byteLength", level.length, size);
      if (level.offset > file_.size() || level.length > file_.size() - level.offset) {
        problem(entry + 8, name + "ends outside the file");
      }
      if (!problems_.empty()) return;
      zeros(cursor, level.offset, "mipPadding");
      if (compressed) frame(file_.subspan(level.offset, level.length), level.offset, size);
      cursor = level.offset + level.length;
    }
    if (cursor < file_.size()) problem(cursor, "bytes after the last level");
  }

  void frame(std::span<const std::byte> bytes, std::uint64_t offset, std::uint64_t size) {
    if (!has_zstd()) {
      problem(offset, "compressed by Zstandard, which this build does not have");
    } else if (zstd_content_size(bytes) != size) {
      problem(offset, "not one Zstandard frame of the level's size");
    }
  }

  void zeros(std::uint64_t begin, std::uint64_t end, std::string_view what) {
    for (std::uint64_t i = begin; i < end; ++i) {
      if (file_[i] != std::byte{0}) problem(i, std::string(what) + " is not zero");
    }
  }

  static bool is_text(std::string_view text) { return is_utf8(text) && !text.starts_with("\xEF\xBB\xBF"); }

  std::span<const std::byte> file_;
  Ktx2Header header_ = {};
  TexelLayout layout_ = {};
  std::vector<Ktx2Problem> problems_;
};

}  // namespace

std::vector<Ktx2Problem> check_ktx2(std::span<const std::byte> file) { return Checker(file).run(); }

}  // namespace zonal
