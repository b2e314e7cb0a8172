#pragma once

#include <cstdio>

#include "zonal/zonal.h"

inline void write_readme_sky() {
  using namespace zonal;
  save_environment(daylight_sky({Layout::kEquirect}, {256, 128}), "sky.hdr");
}

inline void readme_program() {
  using namespace zonal;
  // README begins
  const Environment sky = load_environment("sky.hdr").environment;
  const Sh<Rgb, 3> shade = irradiance(project<3>(sky));  // E, by normal
  const Rgb floor_light = evaluate(shade, {0, 0, 1});
  const Convolved gloss = convolve(sky, Lobe::ggx(0.16), {Layout::kEquirect}, {512, 256});
  save_environment(gloss.map, "gloss.hdr");
  std::printf("%.3f falls on the floor; gloss is right to %.1e\n", floor_light.g, gloss.report.error_bound);
  // README ends
}
