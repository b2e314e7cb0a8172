#include "apps/zonal/output.h"

#include <fmt/format.h>

#include "apps/zonal/layouts.h"
#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/io/environment_file.h"
#include "zonal/io/face_files.h"
#include "zonal/io/ktx2.h"
#include "zonal/io/output_folder.h"
#include "zonal/light/rearrange.h"

namespace zonal {
namespace fs = std::filesystem;
namespace {

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return !path.has_filename() || fs::is_directory(path, ignored);
}

bool is_six_files(const fs::path& path) {
  return is_folder(path) || path.filename().string().find("%s") != std::string::npos;
}

bool is_ktx2(const fs::path& path) { return path.extension() == ".ktx2"; }

Environment as_stack(const Environment& cube) {
  const int edge = *natural_size(cube.projection.layout, {cube.radiance.width(), cube.radiance.height()});
  std::optional<Environment> stack = rearranged(cube, {Layout::kCubeStack}, image_size(Layout::kCubeStack, edge));
  check(stack.has_value(), "all cube layouts hold the same texels");
  return std::move(*stack);
}

void warn_of_clipping(std::int64_t clipped, const fs::path& path, const std::string& hint, Call& call) {
  if (clipped == 0) return;
  call.console.warn(fmt::format("{}: {} pixels are outside what the format holds and were clipped; {}", path.string(),
                                clipped, hint));
}

void write_ktx2(const Environment& map, const OutputOptions& options, const std::string& quantity, Call& call) {
  const bool cube = is_cube(map.projection.layout);
  TextureChain texture{cube ? TextureShape::kCube : TextureShape::kPicture, {}};
  texture.levels.push_back(cube ? as_stack(map).radiance : map.radiance);
  Ktx2Options ktx2{.format = options.float32 ? TexelFormat::kRgba32f : TexelFormat::kRgba16f, .writer = kProgram};
  ktx2.metadata = {{"zonal:quantity", quantity}, {"zonal:projection", std::string(name_of(map.projection.layout))}};
  warn_of_clipping(static_cast<std::int64_t>(save_ktx2(options.path, texture, ktx2)), options.path,
                   "--float32 keeps them", call);
}

void write_faces(const Environment& map, const OutputOptions& options, const SaveOptions& saving,
                 const std::string& what, Call& call) {
  const fs::path pattern = is_folder(options.path) ? options.path / "%s.exr" : options.path;
  OutputFolder folder(pattern.has_parent_path() ? pattern.parent_path() : fs::path("."));
  const SaveReport report = save_environment(as_stack(map), pattern, saving);
  folder.commit();
  warn_of_clipping(report.clipped_pixels, pattern, "EXR keeps them", call);
  for (const std::string_view face : kFaceNames) {
    std::string name = pattern.filename().string();
    name.replace(name.find("%s"), 2, face);
    const fs::path path = pattern.parent_path() / name;
    call.console.wrote(path, fs::file_size(path), fmt::format("{}, face {}", what, face));
  }
}

}  // namespace

Projection target_of(const OutputOptions& options, Layout fallback) {
  Projection target = {options.to.value_or(fallback)};
  if (options.lens) target.lens.model = *options.lens;
  if (options.fov_deg) target.lens.fov_deg = *options.fov_deg;
  return target;
}

void check_output(const OutputOptions& options, Layout layout) {
  if (is_six_files(options.path)) {
    if (!is_cube(layout)) {
      throw Error(
          ErrorKind::kUsage,
          fmt::format("{}: a folder takes the six faces of a cube, not {}", options.path.string(), name_of(layout)),
          "name a file, or say --to cube");
    }
    if (is_folder(options.path)) return;
  }
  if (!is_ktx2(options.path) && !can_save_picture(options.path)) {
    throw Error(ErrorKind::kUsage, options.path.string() + ": this extension names no format that can be written",
                "use .exr, .hdr, .pfm, .png or .ktx2");
  }
  if (is_ktx2(options.path) && is_six_files(options.path)) {
    throw Error(ErrorKind::kUsage, options.path.string() + ": a KTX2 file holds all six faces", "leave out the %s");
  }
}

void write_map(const Environment& map, const OutputOptions& options, const std::string& quantity,
               const std::string& what, Call& call) {
  const SaveOptions saving{.png_bits = options.png16 ? 16 : 8, .exr_half = options.half};
  const ImageSize size{map.radiance.width(), map.radiance.height()};
  const std::string words = fmt::format("{}, {} {}", what, name_of(map.projection.layout), words_of(size));
  if (call.run.stop.stop_requested()) throw Error(ErrorKind::kCancelled, "cancelled");
  if (is_six_files(options.path)) {
    write_faces(map, options, saving, words, call);
    return;
  }
  if (is_ktx2(options.path)) {
    write_ktx2(map, options, quantity, call);
  } else {
    warn_of_clipping(save_environment(map, options.path, saving).clipped_pixels, options.path, "EXR keeps them", call);
  }
  call.console.wrote(options.path, fs::file_size(options.path), words);
}

std::string words_of(ImageSize size) { return fmt::format("{}x{}", size.width, size.height); }

}  // namespace zonal
