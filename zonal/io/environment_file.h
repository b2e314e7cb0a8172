#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "zonal/io/picture.h"
#include "zonal/light/environment.h"

namespace zonal {

struct EnvironmentLoadOptions {
  std::optional<Projection> from;  ///< nullopt: guessed from shape and name
  LoadOptions picture = {};
};

struct LoadedEnvironment {
  Environment environment;
  std::string projection_reason;             ///< why this projection, in words for the user
  std::vector<std::filesystem::path> files;  ///< what was read, in the order of the projection
  std::string format;                        ///< of the first file
  bool srgb_decoded = false;
  bool alpha = false;
  std::vector<std::string> notes;  ///< of all files, each once
  std::string hash;                ///< of all bytes of all files in order, "fnv1a64:..."
};

/// Reads an environment: one picture; a folder of six cube faces (named px nx py ny pz nz, posx negx ..., or right left
/// top bottom front back, alone or after a common beginning); six paths in the order +X -X +Y -Y +Z -Z; or two paths,
/// front and back (only with `from` a dual paraboloid or a dual fisheye). Throws Error{kInput}: what
/// load_picture() throws, faces that are missing or differ in size, nothing to guess the projection from, or a shape
/// that does not fit it (the hint names one that does).
LoadedEnvironment load_environment(const std::filesystem::path&, const EnvironmentLoadOptions& = {}, const Run& = {});
LoadedEnvironment load_environment(std::span<const std::filesystem::path>, const EnvironmentLoadOptions& = {},
                                   const Run& = {});

/// What people call the environment of these paths, of one at least: the last name of the first, and how many more.
std::string environment_name(std::span<const std::filesystem::path>);

/// Writes the picture of an environment as save_picture() does. A path that holds "%s" writes a cube stack as six
/// files, "%s" being px, nx, py, ny, pz and nz: all six are complete before the first one takes its name.
SaveReport save_environment(const Environment&, const std::filesystem::path&, const SaveOptions& = {});

}  // namespace zonal
