#pragma once

#include <filesystem>
#include <optional>

#include "apps/zonal/input.h"
#include "zonal/report/bake_files.h"

namespace zonal {

/// What was asked of the verb bake.
struct BakeCommand {
  InputOptions input;
  BakeOptions bake;
  std::optional<RoughnessMap> roughness_map;
  BakeFileOptions files;
  std::filesystem::path folder;
  bool verify = false;
  bool no_timings = false;
};

void run_bake(BakeCommand&, Call&);

}  // namespace zonal
