#include "zonal/report/bake_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "zonal/base/check.h"
#include "zonal/io/half.h"
#include "zonal/io/hash.h"
#include "zonal/io/json_text.h"
#include "zonal/io/ktx2.h"
#include "zonal/io/ktx2_check.h"
#include "zonal/io/picture_writer.h"
#include "zonal/io/sh_json.h"
#include "zonal/io/shader.h"
#include "zonal/light/rearrange.h"
#include "zonal/report/text.h"
#include "zonal/sh/sh.h"
#include "zonal/sphere/frame.h"

namespace zonal {
namespace {

constexpr int kMostShaderBands = 6;                                                      // shader_text() takes no more
constexpr std::array<std::string_view, 4> kFormatNames = {"ktx2", "exr", "hdr", "png"};  // in the order of MapFormat

/// A map of one name, with all its levels.
struct CubeChain {
  std::string name, what;
  std::vector<const Environment*> levels;
  double error_bound = -1;
  Ktx2Metadata metadata;
};

class BakeWriter {
 public:
  BakeWriter(const BakeFileOptions& options, OutputFolder& folder) : options_(options), folder_(folder) {
    if (options.engine) turn_ = cube_turn(*options.engine);
    frame_ = options.engine ? std::string(options.engine->name) : "z-up-right-handed";
  }

  void cubes(const CubeChain& chain) {
    if (options_.format == MapFormat::kKtx2) {
      TextureChain texture{TextureShape::kCube, {}};
      for (const Environment* level : chain.levels) texture.levels.push_back(turned_cube(*level, Layout::kCubeStack));
      Ktx2Metadata metadata = chain.metadata;
      metadata.emplace_back("zonal:frame", frame_);
      ktx2(chain.name, chain.what, texture, options_.float32 ? TexelFormat::kRgba32f : TexelFormat::kRgba16f,
           std::move(metadata), chain.error_bound);
      return;
    }
    for (std::size_t i = 0; i < chain.levels.size(); ++i) {
      const std::string number = chain.levels.size() > 1 ? fmt::format("_{}", i) : "";
      const std::string what = chain.levels.size() > 1 ? fmt::format("{}, level {}", chain.what, i) : chain.what;
      picture(chain.name + number + "." + std::string(name_of(options_.format)), what,
              turned_cube(*chain.levels[i], options_.layout), {}, chain.error_bound);
    }
  }

  void table(const std::string& name, const std::string& what, const Image<Rgb>& table) {
    if (options_.format == MapFormat::kKtx2) {
      const TexelFormat format = options_.float32 ? TexelFormat::kRgba32f : TexelFormat::kRgba16f;
      ktx2(name, what, {TextureShape::kPicture, {table}}, format, {}, -1);
    } else if (options_.format == MapFormat::kExr) {
      picture(name + ".exr", what, table, {}, -1);
    } else {
      // The shared exponent of Radiance HDR leaves eight bits: sixteen of PNG serve numbers up to 1 better.
      picture(name + ".png", what, table, {.png_bits = 16, .png_linear = true}, -1);
    }
  }

  void text(const std::string& name, const std::string& what, std::string_view content) {
    Fnv1a hash;
    hash.add(std::as_bytes(std::span(content)));
    folder_.add(name, content);
    files_.push_back({{name, what, content.size()}, hash.text(), -1, {}});
  }

  std::vector<BakedFile> take() { return std::move(files_); }

 private:
  Image<Rgb> turned_cube(const Environment& cube, Layout layout) const {
    const ImageSize size = image_size(layout, cube.radiance.width());
    std::optional<Environment> turned = rearranged(cube, {layout}, size, turn_);
    check(turned.has_value(), "an engine's axes must be ours in another order");
    return std::move(turned->radiance);
  }

  void ktx2(const std::string& name, const std::string& what, const TextureChain& texture, TexelFormat format,
            Ktx2Metadata metadata, double error_bound) {
    const Ktx2File encoded =
        encode_ktx2(texture, {.format = format, .writer = options_.writer, .metadata = std::move(metadata)});
    const std::vector<Ktx2Problem> problems = check_ktx2(encoded.bytes);
    check(problems.empty(), problems.empty() ? "" : problems.front().text.c_str());
    BakedFile file{{name + ".ktx2", what, encoded.bytes.size()}, {}, error_bound, {}};
    Fnv1a hash;
    hash.add(encoded.bytes);
    file.hash = hash.text();
    folder_.add(file.file.name, encoded.bytes);
    if (encoded.clipped_texels > 0) {
      file.warning = fmt::format(
          "{}: {} texels are brighter than {:.0f}, the largest 16-bit float, and were clipped to it; --float32 or "
          "--format exr keeps them",
          file.file.name, encoded.clipped_texels, kHalfMax);
    }
    files_.push_back(std::move(file));
  }

  void picture(const std::string& name, const std::string& what, const Image<Rgb>& pixels, const SaveOptions& options,
               double error_bound) {
    OutputFile& out = folder_.add(name);
    const SaveReport report = require_picture_writer(name)(pixels, out, options);
    out.flush();
    BakedFile file{{name, what, std::filesystem::file_size(out.temporary_path())}, {}, error_bound, {}};
    Fnv1a hash;
    add_file(hash, out.temporary_path());
    file.hash = hash.text();
    if (report.clipped_pixels > 0) {
      file.warning =
          fmt::format("{}: {} pixels are outside what the format holds and were clipped; --format exr keeps them", name,
                      report.clipped_pixels);
    }
    files_.push_back(std::move(file));
  }

  const BakeFileOptions& options_;
  OutputFolder& folder_;
  Rotation turn_;
  std::string frame_;
  std::vector<BakedFile> files_;
};

std::string engine_sh_json(const ShFile& sh, const EngineConvention& engine) {
  JsonValue::Array coefficients;
  for (const RgbD& c : engine_coefficients(sh, engine)) coefficients.push_back(JsonValue::Array{c.r, c.g, c.b});
  return json_text(JsonValue::Object{{"format", "zonal-engine-sh"},
                                     {"engine", engine.name},
                                     {"source", engine.source},
                                     {"quantity", name_of(engine.sh.quantity)},
                                     {"condon_shortley", engine.sh.condon_shortley},
                                     {"times_basis_constants", engine.sh.times_constants},
                                     {"coefficients", std::move(coefficients)}});
}

std::string plural(int count, const char* word) { return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s"); }

void write_sh(const Bake& bake, const EngineConvention* engine, BakeWriter& writer) {
  const ShFile sh{ShQuantity::kRadiance, bake.radiance};
  const int bands = bake.radiance.bands();
  writer.text("sh.json", plural(bands, "band") + " of radiance", sh_json_text(sh));

  const int shader_bands = std::min(bands, kMostShaderBands);
  ShFile few{ShQuantity::kRadiance, with_bands(bake.radiance, shader_bands)};
  if (engine) {
    const int most = engine->sh.max_bands > 0 ? engine->sh.max_bands : shader_bands;
    const int engine_bands = std::min(shader_bands, most);
    writer.text(fmt::format("sh.{}.json", engine->name),
                plural(engine_bands, "band") + " as " + std::string(engine->name) + " takes them",
                engine_sh_json({ShQuantity::kRadiance, with_bands(bake.radiance, engine_bands)}, *engine));
    few.coefficients = transformed(few.coefficients, engine->engine_from_world);
  }
  ShaderOptions options;
  if (engine) options.frame = "the world axes of " + std::string(engine->name);
  writer.text("sh.glsl", "irradiance from " + plural(shader_bands, "band") + ", a GLSL function",
              shader_text(few, options));
}

}  // namespace

std::string_view name_of(MapFormat format) { return kFormatNames[static_cast<std::size_t>(format)]; }

std::optional<MapFormat> map_format_named(std::string_view name) {
  const auto found = std::find(kFormatNames.begin(), kFormatNames.end(), name);
  if (found == kFormatNames.end()) return std::nullopt;
  return static_cast<MapFormat>(found - kFormatNames.begin());
}

Rotation cube_turn(const EngineConvention& engine) {
  constexpr Rotation kWorldFromSampler = {
      {world_from_sampler({1, 0, 0}), world_from_sampler({0, 1, 0}), world_from_sampler({0, 0, 1})}};
  return transpose(kWorldFromSampler) * engine.cube_from_world();
}

std::vector<BakedFile> write_bake(const Bake& bake, const BakeOptions& options, const BakeFileOptions& file_options,
                                  OutputFolder& folder) {
  BakeWriter writer(file_options, folder);
  const int size = options.size_px;
  writer.cubes({"environment",
                fmt::format("radiance, cube {}", size),
                {&bake.chain[0].map},
                -1,
                {{"zonal:quantity", "radiance"}}});
  writer.cubes({"irradiance",
                fmt::format("irradiance E, cube {}", options.irradiance_px),
                {&bake.irradiance},
                bake.irradiance_report.bound_to_mean,
                {{"zonal:quantity", "irradiance"}}});

  CubeChain specular{"specular",
                     fmt::format("{} chain, cube {}, {}", name_of(options.lobe), size,
                                 plural(static_cast<int>(bake.chain.size()), "level")),
                     {},
                     -1,
                     {{"zonal:quantity", "radiance"}, {"zonal:lobe", std::string(name_of(options.lobe))}}};
  std::string roughnesses;
  for (const ChainLevel& level : bake.chain) {
    specular.levels.push_back(&level.map);
    if (level.report.bands > 0) specular.error_bound = std::max(specular.error_bound, level.report.bound_to_mean);
    if (!roughnesses.empty()) roughnesses += ' ';
    roughnesses += shortest(level.roughness);
  }
  specular.metadata.emplace_back("zonal:roughness", roughnesses);
  writer.cubes(specular);

  const std::string table = fmt::format("split-sum table {}, ", bake.split_sum.width());
  writer.table("dfg", table + "scale, bias, Charlie", bake.split_sum);
  writer.table("dfg_multiscatter", table + "bias, scale + bias, Charlie", multiscatter_from_standard(bake.split_sum));
  write_sh(bake, file_options.engine, writer);
  return writer.take();
}

}  // namespace zonal
