#include <algorithm>
#include <bit>
#include <cstring>

#include "zonal/base/error.h"
#include "zonal/io/half.h"
#include "zonal/io/ktx2.h"
#include "zonal/io/ktx2_check.h"
#include "zonal/io/ktx2_zstd.h"

namespace zonal {
namespace {

static_assert(std::endian::native == std::endian::little, "texels are read as they lie in the file");

Ktx2Metadata metadata_of(std::span<const std::byte> file, const Ktx2Header& header) {
  Ktx2Metadata metadata;
  for (std::size_t at = header.kvd_offset; at < std::size_t{header.kvd_offset} + header.kvd_length;) {
    const std::uint32_t length = u32_at(file, at);
    const char* key = reinterpret_cast<const char*>(file.data()) + at + 4;  // the checker has seen both NULs
    metadata.emplace_back(key, key + std::strlen(key) + 1);
    at = aligned(at + 4 + length, 4);
  }
  return metadata;
}

void unpack_level(std::span<const std::byte> bytes, const TexelLayout& layout, std::span<Rgb> texels) {
  constexpr std::size_t kTexelsAtOnce = 1024;
  std::vector<std::uint16_t> halves(kTexelsAtOnce * layout.channels);
  std::vector<float> values(kTexelsAtOnce * layout.channels);
  for (std::size_t begin = 0; begin < texels.size(); begin += kTexelsAtOnce) {
    const std::size_t count = std::min(kTexelsAtOnce, texels.size() - begin);
    const std::byte* from = bytes.data() + begin * layout.texel_bytes();
    if (layout.channel_bytes == 2) {
      std::memcpy(halves.data(), from, count * layout.texel_bytes());
      floats_from_halves(halves, values);
    } else {
      std::memcpy(values.data(), from, count * layout.texel_bytes());
    }
    for (std::size_t i = 0; i < count; ++i) {
      const float* texel = &values[i * layout.channels];
      texels[begin + i] = {texel[0], texel[1], layout.channels > 2 ? texel[2] : 0};
    }
  }
}

}  // namespace

Ktx2Texture decode_ktx2(std::span<const std::byte> file, std::uint64_t max_texels) {
  if (const std::vector<Ktx2Problem> problems = check_ktx2(file); !problems.empty()) {
    throw Error(ErrorKind::kInput,
                "KTX2: " + problems[0].text + " (at byte " + std::to_string(problems[0].offset) + ")");
  }
  const Ktx2Header header = ktx2_header(file);
  const TexelLayout& layout = *std::ranges::find(kTexelLayouts, header.vk_format, &TexelLayout::vk_format);
  Ktx2Texture texture{.chain = {}, .format = layout.format, .metadata = metadata_of(file, header)};
  texture.chain.shape = header.face_count == 6 ? TextureShape::kCube : TextureShape::kPicture;

  std::uint64_t texels = 0;
  for (std::uint32_t p = 0; p < header.level_count; ++p) {
    texels += ktx2_level(file, p).uncompressed_length / layout.texel_bytes();
  }
  if (texels > max_texels) {
    throw Error(ErrorKind::kInput,
                "KTX2: " + std::to_string(texels) + " texels are more than the limit of " + std::to_string(max_texels));
  }
  std::vector<std::byte> inflated;
  for (std::uint32_t p = 0; p < header.level_count; ++p) {
    const Ktx2Level level = ktx2_level(file, p);
    std::span<const std::byte> bytes = file.subspan(level.offset, level.length);
    if (header.supercompression == kKtx2Zstandard) {
      inflated.resize(level.uncompressed_length);
      if (!zstd_decompress(bytes, inflated)) {
        throw Error(ErrorKind::kInput, "KTX2: level " + std::to_string(p) + " does not decompress");
      }
      bytes = inflated;
    }
    Image<Rgb>& image =
        texture.chain.levels.emplace_back(static_cast<int>(side_at_level(header.pixel_width, p)),
                                          static_cast<int>(side_at_level(header.pixel_height, p) * header.face_count));
    unpack_level(bytes, layout, image.values());
  }
  return texture;
}

}  // namespace zonal
