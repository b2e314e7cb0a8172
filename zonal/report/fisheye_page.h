#pragma once

#include <string>
#include <vector>

#include "zonal/light/environment.h"
#include "zonal/light/fisheye_study.h"

namespace zonal {

/// A fisheye photograph, the maps that were made of it, and how.
struct FisheyePage {
  std::string photograph_name;
  const Environment* photograph =
      nullptr;         ///< an equidistant fisheye of 180 degrees; with the values that were averaged
  bool codes = false;  ///< the values are those of the file, else linear light
  Rgb ground = {};     ///< as the values
  FisheyeOutside outside = FisheyeOutside::kGround;
  std::string kept_options;                   ///< of the command, for those that the page suggests: "--mode published"
  std::vector<FisheyeStudy> studies;          ///< one for each shininess
  std::vector<FisheyeError> averaging_codes;  ///< for each of them; empty: the photograph has no codes
  std::string program;                        ///< and version
};

/// A self-contained page: published and corrected maps side by side with their difference in false colours, what each
/// of the published program's errors contributes, and the photograph with a circle that can be moved. Its one script
/// previews both maps for the moved circle, from a small copy of the photograph, and writes the command that makes
/// them.
std::string fisheye_page_html(const FisheyePage&);

/// The names of the command's options for the outside: "published", "extended", "two".
std::string_view name_of(FisheyeOutside);

}  // namespace zonal
