#pragma once

#include <vector>

#include "zonal/math/vec.h"

namespace zonal {

/// `count` unit directions that repel each other like electrons on the sphere, at rest (Thomson 1904): start points for
/// a search (Sloan 2008), which takes 1, 3, 6, 10, 15, 22 of them for functions of 1 to 6 bands. Every direction is
/// then within 0.75 to 0.82 of the way from the peak of a delta function of that many bands to its first zero. That
/// misses a maximum now and then; find_peaks() starts from more. A rest may be local: for 1 to 15 and for 22 electrons
/// it is the deepest known. For 1..200; O(count^2) a step, mostly some
/// hundred steps. The same points every time.
std::vector<Vec3> repelled_directions(int count);

/// The energy of electrons there: the sum of 1/distance over all pairs.
double repulsion_energy(const std::vector<Vec3>& directions);

}  // namespace zonal
