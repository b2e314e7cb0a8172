#pragma once

#include "zonal/base/run.h"
#include "zonal/image/image.h"

namespace zonal {

/// The second half of the split sum (Karis 2013): a GGX surface with Schlick's Fresnel term reflects f0 * scale + bias
/// of a white environment. Single scattering, Smith's height-correlated masking and shadowing (Heitz 2014, eq. 99).
struct SplitSum {
  double scale = 0, bias = 0;
};

/// n_dot_v in (0, 1], alpha in (0, 1]. Absolute error under 3e-6 for n_dot_v >= 1e-4 and alpha >= 1e-7
/// (docs/notes/dfg.md).
SplitSum ggx_split_sum(double n_dot_v, double alpha);

/// What a sheen of colour 1 reflects of a white environment: Charlie's D (Estevez & Kulla 2017) with the visibility
/// 1/(4 (n.l + n.v - n.l n.v)) (Neubelt & Pettineo 2013). This model does not conserve energy: where v grazes a smooth
/// sheen the value is above 1. Same domain; error under 1e-6, absolute below 1 and relative above.
double charlie_albedo(double n_dot_v, double alpha);

/// What the first two channels hold.
enum class DfgVariant {
  kStandard,      ///< scale, bias: specular = f0 * r + g (Karis 2013)
  kMultiscatter,  ///< bias, scale + bias: specular = mix(r, g, f0), to be multiplied by 1 + f0 (1/g - 1) for the light
                  ///< that single scattering loses (Lagarde & Golubev 2018, after Kulla & Conty 2017)
};

/// size x size table: column x is n.v = (x + 1/2)/size, row y is perceptual roughness (y + 1/2)/size with alpha =
/// roughness^2, the smoothest row first. Red and green as the variant says, blue is charlie_albedo. size in [1, 1024],
/// else Error{kUsage}.
Image<Rgb> dfg_table(int size, DfgVariant = DfgVariant::kStandard, const Run& = {});

}  // namespace zonal
