#include "zonal/io/environment_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/io/face_files.h"
#include "zonal/io/hash.h"
#include "zonal/io/picture_writer.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace fs = std::filesystem;
namespace {

std::string words_of(ImageSize size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

ImageSize size_of(const Image<Rgb>& image) { return {image.width(), image.height()}; }

/// Records where a picture came from and gives its pixels away.
Image<Rgb> take_pixels(Picture picture, const fs::path& path, LoadedEnvironment& loaded) {
  if (loaded.files.empty()) loaded.format = picture.format;
  loaded.files.push_back(path);
  loaded.srgb_decoded |= picture.srgb_decoded;
  loaded.alpha |= picture.alpha;
  for (std::string& note : picture.notes) {
    if (std::find(loaded.notes.begin(), loaded.notes.end(), note) == loaded.notes.end())
      loaded.notes.push_back(std::move(note));
  }
  return std::move(picture.pixels);
}

/// Throws, with the file's name, where a picture of this shape cannot be what it is said to be.
void check_shape(const Projection& projection, ImageSize size, const fs::path& path) {
  try {
    const Mapping mapping(projection, size);
  } catch (const Error& error) {
    throw Error(error.kind(), path.string() + ": " + error.what(), error.hint());
  }
}

Guess guess_or_throw(ImageSize size, const fs::path& path) {
  std::optional<Guess> guess = guess_projection(size, path.filename().string());
  if (guess) return *guess;
  std::string names;
  for (const Layout layout : all_layouts()) names += (names.empty() ? "" : ", ") + std::string(name_of(layout));
  throw Error(ErrorKind::kInput,
              path.string() + ": neither its shape, " + words_of(size) + ", nor its name says how it shows the sphere",
              "say it with --from, one of " + names);
}

/// Reads pictures of one size and puts them side by side, or each under the last.
Image<Rgb> read_tiles(std::span<const fs::path> paths, bool downward, const EnvironmentLoadOptions& options,
                      const Run& run, LoadedEnvironment& loaded) {
  Image<Rgb> all;
  ImageSize size;
  int done = 0;
  for (const fs::path& path : paths) {
    const Image<Rgb> tile = take_pixels(load_picture(path, options.picture, run), path, loaded);
    const int count = static_cast<int>(paths.size());
    if (done == 0) {
      size = size_of(tile);
      all = downward ? Image<Rgb>(size.width, size.height * count) : Image<Rgb>(size.width * count, size.height);
    } else if (size_of(tile) != size) {
      throw Error(
          ErrorKind::kInput,
          path.string() + ": " + words_of(size_of(tile)) + ", but " + paths[0].string() + " is " + words_of(size),
          "all pictures of one environment must have one size");
    }
    for (int y = 0; y < size.height; ++y) {
      const std::span<const Rgb> row = tile.row(y);
      std::copy(
          row.begin(), row.end(),
          downward ? all.row(done * size.height + y).begin() : all.row(y).begin() + std::ptrdiff_t{done} * size.width);
    }
    ++done;
  }
  return all;
}

Error wrong_count(const std::string& what, const std::string& hint) { return Error(ErrorKind::kUsage, what, hint); }

void load_one(const fs::path& path, const EnvironmentLoadOptions& options, const Run& run, LoadedEnvironment& loaded) {
  Image<Rgb> pixels = take_pixels(load_picture(path, options.picture, run), path, loaded);
  const Guess guess = options.from ? Guess{*options.from, "as asked"} : guess_or_throw(size_of(pixels), path);
  check_shape(guess.projection, size_of(pixels), path);
  loaded.projection_reason = guess.reason;
  loaded.environment = {std::move(pixels), guess.projection};
}

void load_two(std::span<const fs::path> paths, const EnvironmentLoadOptions& options, const Run& run,
              LoadedEnvironment& loaded) {
  const bool dual =
      options.from && (options.from->layout == Layout::kDualParaboloid || options.from->layout == Layout::kDualFisheye);
  if (!dual) {
    throw wrong_count("two pictures make an environment only as a front and a back",
                      "say --from dual-paraboloid or dual-fisheye");
  }
  Image<Rgb> pixels = read_tiles(paths, false, options, run, loaded);
  check_shape(*options.from, size_of(pixels), paths[0]);
  loaded.projection_reason = "a front and a back picture";
  loaded.environment = {std::move(pixels), *options.from};
}

void load_six(std::span<const fs::path> paths, const EnvironmentLoadOptions& options, const Run& run,
              LoadedEnvironment& loaded) {
  const Projection stack = {Layout::kCubeStack};
  if (options.from && *options.from != stack) {
    throw wrong_count("six pictures are the faces of a cube, not " + std::string(name_of(options.from->layout)),
                      "leave out --from or give one picture");
  }
  Image<Rgb> pixels = read_tiles(paths, true, options, run, loaded);
  check_shape(stack, size_of(pixels), paths[0]);
  loaded.projection_reason = "six cube faces";
  loaded.environment = {std::move(pixels), stack};
}

/// Where "%s" stands in the file name.
std::optional<std::size_t> face_mark(const fs::path& path) {
  const std::size_t at = path.filename().string().find("%s");
  return at == std::string::npos ? std::nullopt : std::optional(at);
}

SaveReport save_faces(const Environment& environment, const fs::path& pattern, std::size_t mark,
                      const SaveOptions& options) {
  if (environment.projection.layout != Layout::kCubeStack) {
    throw Error(ErrorKind::kUsage,
                pattern.string() + ": only a cube stack is written as six files, not " +
                    std::string(name_of(environment.projection.layout)),
                "convert it to a cube stack first, or write one file");
  }
  const PictureWriter write = require_picture_writer(pattern);
  const int edge = environment.radiance.width();
  check(environment.radiance.height() == 6 * edge, "a cube stack is six squares");
  SaveReport total;
  std::array<std::unique_ptr<OutputFile>, 6> files;
  Image<Rgb> face(edge, edge);
  for (std::size_t f = 0; f < files.size(); ++f) {
    const std::span<const Rgb> from = environment.radiance.values().subspan(f * face.size(), face.size());
    std::copy(from.begin(), from.end(), face.values().begin());
    std::string name = pattern.filename().string();
    name.replace(mark, 2, kFaceNames[f]);
    files[f] = std::make_unique<OutputFile>(pattern.parent_path() / name);
    total.clipped_pixels += write(face, *files[f], options).clipped_pixels;
    files[f]->flush();
  }
  for (const auto& file : files) file->commit();
  return total;
}

}  // namespace

LoadedEnvironment load_environment(const fs::path& path, const EnvironmentLoadOptions& options, const Run& run) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) return load_environment(std::span(&path, 1), options, run);
  return load_environment(find_face_files(path), options, run);
}

LoadedEnvironment load_environment(std::span<const fs::path> paths, const EnvironmentLoadOptions& options,
                                   const Run& run) {
  LoadedEnvironment loaded;
  switch (paths.size()) {
    case 1:
      load_one(paths[0], options, run, loaded);
      break;
    case 2:
      load_two(paths, options, run, loaded);
      break;
    case 6:
      load_six(paths, options, run, loaded);
      break;
    default:
      throw wrong_count(std::to_string(paths.size()) + " pictures make no environment",
                        "give one picture, two (front, back) or six (+X -X +Y -Y +Z -Z)");
  }
  Fnv1a hash;
  for (const fs::path& file : loaded.files) add_file(hash, file);
  loaded.hash = hash.text();
  return loaded;
}

std::string environment_name(std::span<const fs::path> paths) {
  check(!paths.empty(), "an environment needs a picture");
  const fs::path& first = paths[0];
  // A folder may be written with a slash at its end.
  const std::string name = (first.has_filename() ? first : first.parent_path()).filename().string();
  return paths.size() == 1 ? name : fmt::format("{} and {} more", name, paths.size() - 1);
}

SaveReport save_environment(const Environment& environment, const fs::path& path, const SaveOptions& options) {
  if (const std::optional<std::size_t> mark = face_mark(path)) return save_faces(environment, path, *mark, options);
  return save_picture(environment.radiance, path, options);
}

}  // namespace zonal
