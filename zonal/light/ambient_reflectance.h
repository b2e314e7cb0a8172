#pragma once

#include <vector>

#include "zonal/base/run.h"
#include "zonal/light/brdf.h"

namespace zonal {

/// What a surface reflects of a white environment, and how wrong that may be.
struct Reflectance {
  RgbD value;
  double error = 0;  ///< absolute, the largest channel's
};

/// The ambient reflectance R_A(v) = int f(l, v) n.l dl over the hemisphere of light, which takes ambient radiance L_A
/// to outgoing radiance R_A L_A: albedo for a Lambertian surface, at most 1 for any that does not create light.
///
/// `n_dot_v` in (0, 1]. Directions of light are taken in polar coordinates about the mirror direction, in variables in
/// which the horizon is an edge, with cells that shrink towards the mirror direction (to 1e-5 rad), the horizon and the
/// plane of v and n. Cells are quartered where two Gauss rules (10 and 7 nodes a side) differ most, until all their
/// differences sum to less than `tolerance`. The stated error is that sum, which belongs to the coarser rule: at 250
/// random pairs of n.v and alpha in [1e-3, 1] (Phong, Blinn-Phong, GGX) the value was never off by more than a fifth of
/// it. It is larger than asked for where two million values of f do not suffice; where f jumps it may be a few times
/// too small; and it knows nothing of a peak elsewhere that is too thin for any cell to see.
///
/// Throws Error{kUsage} for n_dot_v or a tolerance (1e-12 to 1) outside their domain, Error{kInput} where f is not
/// finite.
Reflectance ambient_reflectance(const Brdf&, double n_dot_v, double tolerance = 1e-6);

struct ReflectanceTable {
  std::vector<RgbD> values;  ///< values[i]: n.v = (i + 1/2)/size, as the columns of dfg_table
  double error = 0;          ///< the largest of any entry
};

/// The same as a table over the cosine. size in [1, 4096], else Error{kUsage}. The BRDF is called from several threads.
/// Throws Error{kCancelled}.
ReflectanceTable ambient_reflectance_table(const Brdf&, int size, double tolerance = 1e-6, const Run& = {});

}  // namespace zonal
