#pragma once

#include <string>
#include <vector>

#include "zonal/io/environment_file.h"
#include "zonal/io/json_text.h"
#include "zonal/report/bake.h"
#include "zonal/report/bake_files.h"

namespace zonal {

/// Where a bake came from: what its page and its recipe say besides what was measured.
struct BakeOrigin {
  std::string program;               ///< and version
  std::vector<std::string> command;  ///< what to type to do it again
  std::string name;                  ///< of the input, for people
  LoadedEnvironment input;           ///< the pixels may have been moved away
  ImageSize input_size;
  std::vector<std::string> warnings;  ///< beyond those that the survey gives reason for
  bool timings = true;                ///< false: the recipe and the page repeat to the byte
};

/// recipe.json: input and its hash, settings, every result with its hash, every map with its error bounds.
std::string bake_recipe_json(const Bake&, const Survey&, const BakeOptions&, const BakeFileOptions&, const BakeOrigin&,
                             const std::vector<BakedFile>&);

/// What index.html shows. Takes the maps out of the bake.
BakePage page_of(Bake&&, const Survey&, const BakeOptions&, const BakeFileOptions&, const BakeOrigin&,
                 const std::vector<BakedFile>&);

}  // namespace zonal
