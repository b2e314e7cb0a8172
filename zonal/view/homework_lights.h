#pragma once

#include <span>
#include <string_view>

#include "zonal/math/vec.h"
#include "zonal/sh/sh.h"

namespace zonal {

/// Nine coefficients of the radiance of a place, as published.
struct HomeworkLight {
  std::string_view name;
  /// Index l(l+1)+m, real basis without the Condon-Shortley sign, as in memory; but in axes of their own: +X right, +Y
  /// up, +Z the centre of the angular map, which are those of the cube sampler (sphere/frame.h).
  double coefficients[9][3];
};

/// The ten light sets that a course on game graphics has its students shade by, a second each (Tokoi, ggsample10). They
/// are the tables of the "Orange Book" (Rost, OpenGL Shading Language, 2nd edition 2006, chapter 12), computed with the
/// program of Ramamoorthi & Hanrahan 2001 from Debevec's light probes; each scaled to look well, Grace Cathedral by
/// 5/16, others by 0.1 to 0.4.
std::span<const HomeworkLight> homework_lights();

/// The same in our axes, where the centre of the map is +X and up is +Z.
Sh<RgbD, 3> homework_radiance(const HomeworkLight&);

}  // namespace zonal
