// Writes KTX2 files of every kind into a folder, and beside each the facts that a reader must find in it.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>

#include "zonal/io/file.h"
#include "zonal/io/json_text.h"
#include "zonal/io/ktx2.h"
#include "zonal/io/ktx2_zstd.h"

namespace zonal {
namespace {

constexpr std::string_view kVkNames[] = {"VK_FORMAT_R16G16_SFLOAT", "VK_FORMAT_R16G16B16A16_SFLOAT",
                                         "VK_FORMAT_R32G32B32A32_SFLOAT"};

/// Halves hold these exactly (integers up to 2048); no two faces of a level begin alike.
Rgb texel_value(int level, int x, int y) {
  const float n = static_cast<float>(256 * level + 16 * y + x);
  return {n, -n / 8, 0.25f};
}

JsonValue texel_fact(Rgb texel, TexelFormat format) {
  if (format == TexelFormat::kRg16f) return JsonValue::Array{texel.r, texel.g};
  return JsonValue::Array{texel.r, texel.g, texel.b, 1.0f};
}

void write_sample(const std::filesystem::path& folder, const std::string& name, TextureShape shape, int width,
                  int height, int levels, const Ktx2Options& options) {
  const int faces = shape == TextureShape::kCube ? 6 : 1;
  TextureChain chain{shape, {}};
  JsonValue::Array level_facts;
  for (int p = 0; p < levels; ++p) {
    const int w = std::max(1, width >> p), h = std::max(1, height >> p);
    Image<Rgb>& image = chain.levels.emplace_back(w, h * faces);
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < w; ++x) image(x, y) = texel_value(p, x, y);
    }
    JsonValue::Array corners;  // of each face: the first texel and the last
    for (int face = 0; face < faces; ++face) {
      corners.emplace_back(texel_fact(image(0, face * h), options.format));
      corners.emplace_back(texel_fact(image(w - 1, face * h + h - 1), options.format));
    }
    const int bytes = static_cast<int>(layout_of(options.format).texel_bytes()) * w * h * faces;
    JsonValue::Object facts = {{"width", w}, {"height", h}, {"bytes", bytes}};
    if (options.zstd_level == 0) facts.emplace_back("corners", std::move(corners));
    level_facts.emplace_back(std::move(facts));
  }
  JsonValue::Object keys = {{"KTXorientation", "rd"}, {"KTXwriter", options.writer}};
  for (const auto& [key, value] : options.metadata) keys.emplace_back(key, value);
  save_ktx2(folder / (name + ".ktx2"), chain, options);
  write_file(
      folder / (name + ".json"),
      json_text(JsonValue::Object{{"format", kVkNames[static_cast<std::size_t>(options.format)]},
                                  {"faces", faces},
                                  {"supercompression", options.zstd_level > 0 ? "zstd" : "none"},
                                  {"channels", static_cast<int>(layout_of(options.format).channels)},
                                  {"channel_bits", static_cast<int>(8 * layout_of(options.format).channel_bytes)},
                                  {"levels", std::move(level_facts)},
                                  {"keys", std::move(keys)}}));
}

void write_samples(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const Ktx2Metadata metadata = {{"zonal.note", "caf\xC3\xA9"}};
  for (const TexelLayout& layout : kTexelLayouts) {
    const std::string bits = std::to_string(layout.channels) + "x" + std::to_string(8 * layout.channel_bytes);
    for (const int zstd_level : {0, 5}) {
      if (zstd_level > 0 && !has_zstd()) continue;
      const std::string name = bits + (zstd_level > 0 ? "-zstd" : "");
      const Ktx2Options options = {
          .format = layout.format, .zstd_level = zstd_level, .writer = "zonal samples", .metadata = metadata};
      write_sample(folder, "cube-" + name, TextureShape::kCube, 16, 16, 5, options);
      write_sample(folder, "picture-" + name, TextureShape::kPicture, 9, 5, 1, options);
      write_sample(folder, "mipped-" + name, TextureShape::kPicture, 12, 5, 4, options);
    }
  }
}

}  // namespace
}  // namespace zonal

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: ktx2_samples FOLDER\n", stderr);
    return 2;
  }
  zonal::write_samples(argv[1]);
}
