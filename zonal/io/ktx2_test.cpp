#include "zonal/io/ktx2.h"

#include <gtest/gtest.h>

#include <bit>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <string>

#include "zonal/base/error.h"
#include "zonal/io/file.h"
#include "zonal/io/ktx2_check.h"
#include "zonal/io/ktx2_zstd.h"

namespace zonal {
namespace {

/// Values that halves hold exactly and that differ from texel to texel.
Image<Rgb> numbered(int width, int height, float first) {
  Image<Rgb> image(width, height);
  for (std::size_t i = 0; i < image.size(); ++i) {
    const float n = first + static_cast<float>(i % 512);
    image.values()[i] = {n, -n / 4, n + 0.5f};
  }
  return image;
}

TextureChain cube_chain(int side, int levels) {
  TextureChain chain;
  for (int p = 0; p < levels; ++p)
    chain.levels.push_back(numbered(side >> p, 6 * (side >> p), static_cast<float>(8 * p)));
  return chain;
}

std::vector<std::byte> bytes_of(std::string_view hex) {
  std::vector<std::byte> bytes;
  for (std::size_t i = 0; i < hex.size(); ++i) {
    if (std::isxdigit(static_cast<unsigned char>(hex[i])) == 0) continue;
    bytes.push_back(static_cast<std::byte>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16)));
    ++i;
  }
  return bytes;
}

// Laid out by hand from the specification, byte by byte.
TEST(Ktx2, APictureOfTwoHalvesIsBitExact) {
  TextureChain chain{.shape = TextureShape::kPicture, .levels = {Image<Rgb>(2, 1)}};
  chain.levels[0](0, 0) = {1.0f, 0.5f, 9.0f};
  chain.levels[0](1, 0) = {-2.0f, 65504.0f, 9.0f};
  const Ktx2File file =
      encode_ktx2(chain, {.format = TexelFormat::kRg16f, .writer = "z 1", .metadata = {{"A", "\xC3\xBC"}}});
  EXPECT_EQ(file.bytes, bytes_of("AB4B5458 203230BB 0D0A1A0A"                             // identifier
                                 "53000000 02000000 02000000 01000000 00000000 00000000"  // 83, 2, 2 x 1, 0, 0
                                 "01000000 01000000 00000000"                             // 1 face, 1 level, stored
                                 "68000000 3C000000 A4000000 38000000"                    // 104+60, 164+56
                                 "0000000000000000 0000000000000000"                      // no global data
                                 "DC00000000000000 0800000000000000 0800000000000000"     // level 0 at 220
                                 "3C000000 00000000 02003800 01010100 00000000 04000000 00000000"  // descriptor
                                 "00000FC0 00000000 000080BF 0000803F"                             // red
                                 "10000FC1 00000000 000080BF 0000803F"                             // green
                                 "05000000 41 00 C3BC 00 000000"                                   // A: ue
                                 "12000000 4B54586F7269656E746174696F6E 00 7264 00 0000"           // KTXorientation: rd
                                 "0E000000 4B5458777269746572 00 7A2031 00 0000"                   // KTXwriter: z 1
                                 "003C 0038 00C0 FF7B"));
  EXPECT_EQ(file.clipped_texels, 0u);
  EXPECT_TRUE(check_ktx2(file.bytes).empty());
}

TEST(Ktx2, EveryShapeFormatAndSchemeReadsBackExactly) {
  int files = 0;
  std::size_t texels = 0;
  for (const TexelLayout& layout : kTexelLayouts) {
    for (const int zstd_level : {0, 3}) {
      if (zstd_level > 0 && !has_zstd()) continue;
      for (const bool cube : {true, false}) {
        for (const int levels : {1, 2, 5}) {
          TextureChain chain = cube_chain(16, levels);
          if (!cube) {
            chain = {TextureShape::kPicture, {}};
            for (int p = 0; p < levels; ++p)
              chain.levels.push_back(numbered(std::max(1, 19 >> p), std::max(1, 3 >> p), 1));
          }
          const Ktx2File file = encode_ktx2(chain, {.format = layout.format, .zstd_level = zstd_level});
          const std::vector<Ktx2Problem> problems = check_ktx2(file.bytes);
          ASSERT_TRUE(problems.empty()) << problems[0].text << " at " << problems[0].offset;
          const Ktx2Texture read = decode_ktx2(file.bytes);
          ASSERT_EQ(read.format, layout.format);
          ASSERT_EQ(read.chain.shape, chain.shape);
          ASSERT_EQ(read.chain.levels.size(), chain.levels.size());
          for (std::size_t p = 0; p < chain.levels.size(); ++p) {
            Image<Rgb> expected = chain.levels[p];
            if (layout.channels == 2) {
              for (Rgb& texel : expected.values()) texel.b = 0;
            }
            ASSERT_EQ(read.chain.levels[p], expected);
            texels += expected.size();
          }
          ++files;
        }
      }
    }
  }
  EXPECT_EQ(files, 3 * 2 * 3 * (has_zstd() ? 2 : 1));
  EXPECT_GT(texels, 10000u);
}

TEST(Ktx2, SmallLevelsComeFirstInTheFileAndLastInTheIndex) {
  const Ktx2File file = encode_ktx2(cube_chain(16, 5));
  std::uint64_t previous_end = file.bytes.size();
  for (std::size_t p = 0; p < 5; ++p) {
    const Ktx2Level level = ktx2_level(file.bytes, p);
    EXPECT_EQ(level.length, (256u >> (2 * p)) * 6 * 8);
    EXPECT_EQ(level.offset + level.length, previous_end);  // a texel of 8 bytes leaves no gap between levels
    EXPECT_EQ(level.offset % 8, 0u);
    previous_end = level.offset;
  }
}

TEST(Ktx2, FacesLieOneAfterTheOther) {
  TextureChain chain{.levels = {Image<Rgb>(2, 12)}};
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < 2; ++row) {
      for (int x = 0; x < 2; ++x)
        chain.levels[0](x, 2 * face + row) = {static_cast<float>(100 * face + 10 * row + x), 0, 0};
    }
  }
  const Ktx2File file = encode_ktx2(chain, {.format = TexelFormat::kRgba32f});
  const std::size_t start = ktx2_level(file.bytes, 0).offset;
  int compared = 0;
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < 2; ++row) {
      for (int x = 0; x < 2; ++x, ++compared) {
        const std::uint32_t bits = u32_at(file.bytes, start + 16 * static_cast<std::size_t>(compared));
        EXPECT_EQ(std::bit_cast<float>(bits), static_cast<float>(100 * face + 10 * row + x));
      }
    }
  }
  EXPECT_EQ(compared, 24);
}

TEST(Ktx2, MetadataIsSortedByKeyAndReadBack) {
  const Ktx2File file =
      encode_ktx2(cube_chain(1, 1), {.writer = "zonal 0.1", .metadata = {{"zonal.roughness", "linear"}, {"B", ""}}});
  const Ktx2Metadata expected = {
      {"B", ""}, {"KTXorientation", "rd"}, {"KTXwriter", "zonal 0.1"}, {"zonal.roughness", "linear"}};
  EXPECT_EQ(decode_ktx2(file.bytes).metadata, expected);
}

TEST(Ktx2, RefusesMetadataThatTheFormatDoesNotAllow) {
  const std::vector<Ktx2Metadata> refused = {{{"", "x"}},
                                             {{"KTXx", "x"}},
                                             {{"ktxx", "x"}},
                                             {{"a", "\xff"}},
                                             {{"a\xC0", "x"}},
                                             {{"a", std::string("x\0y", 3)}},
                                             {{"a", "1"}, {"a", "2"}},
                                             {{"\xEF\xBB\xBF", "x"}}};
  int thrown = 0;
  for (const Ktx2Metadata& metadata : refused) {
    try {
      (void)encode_ktx2(cube_chain(1, 1), {.metadata = metadata});
    } catch (const Error& error) {
      thrown += error.kind() == ErrorKind::kUsage;
    }
  }
  EXPECT_EQ(thrown, 8);
}

TEST(Ktx2, TexelsBeyondTheHalfRangeAreClampedAndCounted) {
  TextureChain chain = cube_chain(4, 3);
  chain.levels[0](1, 1) = {1e6f, 1e6f, 0};
  chain.levels[2](0, 5) = {0, 0, -INFINITY};
  const Ktx2File half = encode_ktx2(chain);
  EXPECT_EQ(half.clipped_texels, 2u);
  const Ktx2Texture read = decode_ktx2(half.bytes);
  EXPECT_EQ(read.chain.levels[0](1, 1), (Rgb{65504, 65504, 0}));
  EXPECT_EQ(read.chain.levels[2](0, 5), (Rgb{0, 0, -65504}));
  const Ktx2File full = encode_ktx2(chain, {.format = TexelFormat::kRgba32f});
  EXPECT_EQ(full.clipped_texels, 0u);
  EXPECT_EQ(decode_ktx2(full.bytes).chain.levels[2](0, 5).b, -INFINITY);
}

TEST(Ktx2, WrongChainsAreMistakesOfTheCaller) {
  EXPECT_THROW((void)encode_ktx2({}), std::logic_error);
  EXPECT_THROW((void)encode_ktx2({.levels = {Image<Rgb>(4, 4)}}), std::logic_error);
  EXPECT_THROW((void)encode_ktx2({.levels = {Image<Rgb>(4, 24), Image<Rgb>(1, 6)}}), std::logic_error);
  EXPECT_THROW((void)encode_ktx2({.levels = {Image<Rgb>(1, 6), Image<Rgb>(1, 6)}}), std::logic_error);
  EXPECT_THROW((void)encode_ktx2({.levels = {Image<Rgb>(0, 0)}}), std::logic_error);
}

TEST(Ktx2, SidesAreLimited) {
  EXPECT_NO_THROW((void)encode_ktx2({TextureShape::kPicture, {Image<Rgb>(65536, 1)}}));
  EXPECT_THROW((void)encode_ktx2({TextureShape::kPicture, {Image<Rgb>(1, 65537)}}), Error);
}

TEST(Ktx2, SavesTheBytesItEncodes) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "zonal_ktx2_test.ktx2";
  EXPECT_EQ(save_ktx2(path, cube_chain(8, 4)), 0u);
  EXPECT_EQ(read_file(path), encode_ktx2(cube_chain(8, 4)).bytes);
  std::filesystem::remove(path);
}

TEST(Ktx2, MoreTexelsThanTheLimitAreRefused) {
  const Ktx2File file = encode_ktx2(cube_chain(4, 1));
  EXPECT_NO_THROW((void)decode_ktx2(file.bytes, 96));
  EXPECT_THROW((void)decode_ktx2(file.bytes, 95), Error);
}

}  // namespace
}  // namespace zonal
