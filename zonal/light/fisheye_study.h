#pragma once

#include <vector>

#include "zonal/base/run.h"
#include "zonal/light/environment.h"
#include "zonal/light/fisheye_light.h"
#include "zonal/light/fisheye_published.h"

namespace zonal {

/// One map in the three forms that renderers read.
struct FisheyeForms {
  Image<Rgb> paraboloid;  ///< a square; two of them side by side with FisheyeOutside::kTwo
  Environment equirect;   ///< as many rows as the paraboloid
  Environment cube;       ///< a stack of faces, of half the paraboloid's edge
};

/// A difference over the pixels inside of a paraboloid map's circle, as a fraction of the greatest channel of the exact
/// map: as formulas of several skies are compared.
struct FisheyeError {
  double rms = 0, most = 0;
};

/// The published map beside the corrected one.
struct FisheyeStudy {
  double shininess = 0;
  FisheyeForms published, corrected;
  FisheyeError total;          ///< of the published means
  FisheyeError weights_alone;  ///< of the published weights, the ground put right
  FisheyeError ground_alone;   ///< of the square's corners as ground, the weights put right
  FisheyeError library;        ///< of the corrected map (zonal convolution) against the direct sums over pixels
};

/// The corrected map of shininess i.
FisheyeForms corrected_forms(const FisheyeLight&, int i, int size_px, const Run& = {});

/// Both programs' maps of one photograph, for each `shininess` (1: irradiance over pi). options.shininess is not used.
/// The errors are measured by direct sums on a coarse grid of directions. Throws as fisheye_means() and FisheyeLight
/// do: equidistant lenses of 180 degrees only.
std::vector<FisheyeStudy> fisheye_study(const Environment& photograph, const std::vector<double>& shininess,
                                        const PublishedOptions& options, const Run& = {});

/// The photograph with every block of factor x factor pixels as one, and its lens: for comparisons that need not wait
/// for sums over all pixels.
Environment smaller_photograph(const Environment&, int factor);

/// What is lost where the codes of an sRGB photograph are averaged in place of light: the means of `codes`, decoded,
/// against the means of the decoded photograph. `ground` is a code, too. Weights and ground are right in both.
FisheyeError error_of_averaging_codes(const Environment& codes, Rgb ground, double shininess, const Run& = {});

/// The map of the first published program in the same forms: its disc is an equidistant fisheye.
FisheyeForms first_published_forms(const Environment& photograph, const PublishedOptions&, const Run& = {});

}  // namespace zonal
