#include "zonal/io/ktx2_check.h"

#include <gtest/gtest.h>

#include <random>
#include <string_view>

#include "zonal/base/error.h"
#include "zonal/io/ktx2.h"
#include "zonal/io/ktx2_zstd.h"

namespace zonal {
namespace {

struct Sample {
  std::vector<std::byte> bytes;
  std::size_t free_begin = 0, free_end = 0;  // key and value of the free metadata: other text there is as good
  std::size_t writer_begin = 0, writer_end = 0;
  std::size_t texels_begin = 0;
};

constexpr std::string_view kFreeKey = "note", kFreeValue = "free text", kWriter = "a writer";

std::size_t find(const std::vector<std::byte>& bytes, std::string_view text) {
  return std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()).find(text);
}

Sample sample(TextureShape shape, TexelFormat format, int zstd_level, int levels) {
  TextureChain chain{shape, {}};
  for (int p = 0; p < levels; ++p) {
    chain.levels.emplace_back(8 >> p, (8 >> p) * (shape == TextureShape::kCube ? 6 : 1), Rgb{1, 2, 3});
  }
  Ktx2Options options{.format = format, .zstd_level = zstd_level, .writer = std::string(kWriter)};
  options.metadata.emplace_back(kFreeKey, kFreeValue);
  Sample made{.bytes = encode_ktx2(chain, options).bytes};
  made.free_begin = find(made.bytes, kFreeKey);
  made.free_end = made.free_begin + kFreeKey.size() + 1 + kFreeValue.size();
  made.writer_begin = find(made.bytes, kWriter);
  made.writer_end = made.writer_begin + kWriter.size();
  const Ktx2Header header = ktx2_header(made.bytes);
  made.texels_begin = ktx2_level(made.bytes, header.level_count - 1).offset;
  return made;
}

std::vector<Sample> samples() {
  std::vector<Sample> all;
  for (const int zstd_level : {0, 1}) {
    if (zstd_level > 0 && !has_zstd()) continue;
    all.push_back(sample(TextureShape::kCube, TexelFormat::kRgba16f, zstd_level, 4));
    all.push_back(sample(TextureShape::kCube, TexelFormat::kRgba32f, zstd_level, 2));
    all.push_back(sample(TextureShape::kPicture, TexelFormat::kRg16f, zstd_level, 1));
    all.push_back(sample(TextureShape::kPicture, TexelFormat::kRgba16f, zstd_level, 3));
  }
  return all;
}

std::string all_texts(const std::vector<Ktx2Problem>& problems) {
  std::string texts;
  for (const Ktx2Problem& problem : problems) texts += std::to_string(problem.offset) + ": " + problem.text + '\n';
  return texts;
}

TEST(Ktx2Check, AcceptsWhatWeWrite) {
  for (const Sample& made : samples()) EXPECT_EQ(all_texts(check_ktx2(made.bytes)), "");
}

// Everything before the texels, padding included, has exactly one right value, save the text of the writer and of free
// metadata.
TEST(Ktx2Check, NoticesEveryChangedByteBeforeTheTexels) {
  for (const Sample& made : samples()) {
    std::size_t tried = 0, noticed = 0;
    for (std::size_t i = 0; i < made.texels_begin; ++i) {
      if ((i >= made.free_begin && i < made.free_end) || (i >= made.writer_begin && i < made.writer_end)) continue;
      for (int flip = 1; flip < 256; ++flip, ++tried) {
        std::vector<std::byte> changed = made.bytes;
        changed[i] ^= static_cast<std::byte>(flip);
        noticed += !check_ktx2(changed).empty();
      }
    }
    EXPECT_EQ(noticed, tried);
    const std::size_t free_bytes = made.free_end - made.free_begin + kWriter.size();
    EXPECT_EQ(tried, 255 * (made.texels_begin - free_bytes));
    EXPECT_GT(tried, 255u * 200);
  }
}

TEST(Ktx2Check, FreeTextMayBeOtherTextButOnlyText) {
  const Sample made = samples().front();
  int other_text = 0, refused = 0;
  for (std::size_t i = made.free_begin + kFreeKey.size() + 1; i < made.free_end; ++i) {
    std::vector<std::byte> changed = made.bytes;
    changed[i] = std::byte{'Q'};
    other_text += check_ktx2(changed).empty();
    for (const int bad : {0x00, 0x80, 0xC3, 0xFF}) {
      changed[i] = static_cast<std::byte>(bad);
      refused += !check_ktx2(changed).empty();
    }
  }
  EXPECT_EQ(other_text, static_cast<int>(kFreeValue.size()));
  EXPECT_EQ(refused, 4 * static_cast<int>(kFreeValue.size()));
}

TEST(Ktx2Check, NoticesEveryTruncationAndExtension) {
  std::size_t truncations = 0, noticed = 0;
  for (const Sample& made : samples()) {
    for (std::size_t size = 0; size < made.bytes.size(); ++size, ++truncations) {
      noticed += !check_ktx2(std::span(made.bytes).first(size)).empty();
    }
    std::vector<std::byte> longer = made.bytes;
    longer.push_back(std::byte{0});
    EXPECT_FALSE(check_ktx2(longer).empty());
  }
  EXPECT_EQ(noticed, truncations);
  EXPECT_GT(truncations, 5000u);
}

TEST(Ktx2Check, SaysWhatAndWhere) {
  Sample made = samples().front();
  made.bytes[36] = std::byte{5};
  EXPECT_EQ(all_texts(check_ktx2(made.bytes)), "36: faceCount is 5, must be 1 or 6\n");
  made = samples().front();
  made.bytes[find(made.bytes, "rd")] = std::byte{'l'};
  EXPECT_NE(all_texts(check_ktx2(made.bytes)).find("KTXorientation is not rd"), std::string::npos);
}

TEST(Ktx2Check, HostileBytesAreReadWithinBoundsAndNeverTrusted) {
  std::mt19937 random(11);
  int mutants = 0, refused = 0, decoded = 0;
  for (const Sample& made : samples()) {
    for (int i = 0; i < 3000; ++i, ++mutants) {
      std::vector<std::byte> mutant = made.bytes;
      if (random() % 4 == 0) mutant.resize(random() % (mutant.size() + 64));
      const int changes = 1 + static_cast<int>(random() % 6);
      for (int c = 0; c < changes && !mutant.empty(); ++c) {
        // Whole words of extreme values next to single bytes; mostly where the structure is.
        const std::size_t reach = random() % 3 == 0 ? mutant.size() : std::min(mutant.size(), made.texels_begin);
        const std::size_t at = random() % reach;
        const auto value = static_cast<std::byte>(random() % 2 ? 0xff : random() % 256);
        const std::size_t length = random() % 2 ? 1 : 4 + 4 * (random() % 2);
        for (std::size_t k = at; k < std::min(mutant.size(), at + length); ++k) mutant[k] = value;
      }
      try {
        const Ktx2Texture texture = decode_ktx2(mutant, 1 << 16);
        decoded += !texture.chain.levels.empty();
      } catch (const Error& error) {
        refused += error.kind() == ErrorKind::kInput;
      }
    }
  }
  EXPECT_EQ(refused + decoded, mutants);
  EXPECT_GT(refused, mutants / 2);
  EXPECT_GT(decoded, 0);  // a change of texels or of free text is no damage
}

TEST(Ktx2Check, ABombOfZerosIsRefusedBeforeItIsInflated) {
  if (!has_zstd()) GTEST_SKIP() << "built without Zstandard";
  TextureChain chain{TextureShape::kPicture, {Image<Rgb>(1024, 1024)}};
  const Ktx2File file = encode_ktx2(chain, {.zstd_level = 19});
  EXPECT_LT(file.bytes.size(), 4096u);
  EXPECT_THROW((void)decode_ktx2(file.bytes, 1024 * 1024 - 1), Error);
  EXPECT_NO_THROW((void)decode_ktx2(file.bytes, 1024 * 1024));
}

}  // namespace
}  // namespace zonal
