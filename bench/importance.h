#pragma once

#include <vector>

#include "zonal/light/environment.h"

namespace zonal::bench {

/// How the field prefilters: for each texel `samples` GGX half vectors of a Hammersley sequence, each light direction
/// read from a mip level of the cube by its probability (Karis 2013; Křivánek & Colbert 2008), weighted by n·l. The
/// baseline that our convolution is measured against; written for this benchmark. `cubes` is the mip chain of a cube
/// stack, largest first.
Image<Rgb> importance_sampled_ggx(const std::vector<Image<Rgb>>& cubes, double alpha, int face_size, int samples,
                                  int threads);

}  // namespace zonal::bench
