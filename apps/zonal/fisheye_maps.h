#pragma once

#include <string>
#include <vector>

#include "zonal/io/output_folder.h"
#include "zonal/light/fisheye_study.h"

namespace zonal {

struct FisheyeFile {
  std::string name, what;
};

/// Adds the three forms of a map to a folder: NAME-paraboloid (or `first_form`), NAME-panorama and NAME-cube-cross.
/// Codes of 8 bits become PNG files of these very codes, all else EXR and, for screens, PNG. What was added: for the
/// list of files, once the folder is committed.
std::vector<FisheyeFile> add_fisheye_maps(const FisheyeForms&, const std::string& name, const std::string& first_form,
                                          bool codes, OutputFolder&);

}  // namespace zonal
