#include "apps/zonal/output_options.h"

#include <CLI/CLI.hpp>
#include <string>

#include "apps/zonal/choices.h"
#include "apps/zonal/layouts.h"

namespace zonal {

void add_output_options(CLI::App& verb, OutputOptions& options, const char* size_help) {
  constexpr const char* kGroup = "Output";
  verb.add_option("-o,--output", options.path,
                  "OUT.exr, .hdr, .pfm, .png or .ktx2; for cubes also a folder or a name with %s: six files")
      ->required()
      ->group(kGroup);
  add_choice(verb, "--to", options.to, layout_or_alias, layout_names(), "how the map shows the sphere")->group(kGroup);
  verb.add_option("--size", options.size_px,
                  std::string("panorama height, cube face edge, disc diameter or side in pixels; ") + size_help)
      ->check(CLI::Range(1, 32768))
      ->group(kGroup);
  add_choice(verb, "--to-lens", options.lens, lens_model_named, "equidistant, equisolid, stereographic or orthographic",
             "lens of a fisheye to be written")
      ->group(kGroup);
  verb.add_option("--to-fov", options.fov_deg, "whole angle of a fisheye to be written, in degrees; 180 if not said")
      ->group(kGroup);
  verb.add_flag("--half", options.half, "EXR: 16 bit floats in place of 32")->group(kGroup);
  verb.add_flag("--png16", options.png16, "PNG: 16 bits in place of 8")->group(kGroup);
  verb.add_flag("--float32", options.float32, "KTX2: 32 bit floats in place of 16")->group(kGroup);
}

}  // namespace zonal
