#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/zonal/call.h"
#include "zonal/io/environment_file.h"
#include "zonal/light/resample.h"
#include "zonal/light/survey.h"
#include "zonal/sphere/fineness.h"

namespace zonal {

/// What a user says about an input.
struct InputOptions {
  std::vector<std::filesystem::path> paths;
  std::optional<Layout> from;
  std::optional<LensModel> lens;
  std::optional<double> fov_deg;
  std::string center, radius;  ///< "X,Y" in pixels, "R" or "RX,RY"
  Encoding encoding = Encoding::kAuto;
  std::int64_t max_pixels = LoadOptions{}.max_pixels;
  bool fix = false;
  std::string rotate;  ///< "YAW[,PITCH[,ROLL]]" in degrees
  std::optional<Uncovered> uncovered;
  std::string ground;  ///< "R,G,B"
};

struct Input {
  LoadedEnvironment loaded;  ///< its pixels are those of the file, repaired if asked
  ImageSize file_size;
  Survey survey;     ///< of the pixels as they were in the file
  Repairs repaired;  ///< all 0 unless asked
};

/// Reads an input, says what was assumed about it, and warns of what is doubtful. Throws Error{kInput} for values that
/// are not finite, unless they are to be repaired or `any_values`.
Input read_input(const InputOptions&, Call&, bool any_values = false);

/// The projection that --from, --lens, --fov, --center and --radius describe; nullopt without --from. Throws
/// Error{kUsage} for what does not describe such a picture.
std::optional<Projection> projection_of(const InputOptions&);
/// How the options turn the light.
Rotation rotation_of(const InputOptions&);
/// What is in the directions that the picture does not show.
ResampleOptions resample_options_of(const InputOptions&);

/// An environment that shows the whole sphere.
struct WholeLight {
  Environment environment;
  std::optional<Environment> shown;  ///< 1 where the picture showed something, when the rest is to be left out
  Survey survey;
};

/// Turns the light and fills in what the picture does not show. Takes the pixels out of the input.
WholeLight whole_light(Input&, const InputOptions&, Call&);

/// The natural size of a picture of another layout that is about as fine.
int size_as_fine(Layout to, const Projection& from, ImageSize);

}  // namespace zonal
