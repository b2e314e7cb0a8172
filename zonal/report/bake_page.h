#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "zonal/base/run.h"
#include "zonal/light/convolve.h"
#include "zonal/light/environment.h"
#include "zonal/light/survey.h"
#include "zonal/report/bake_page_viewer.h"
#include "zonal/report/html.h"

namespace zonal {

// What a bake has to show. Radiance is in the units of the input ("radiance units": W·sr⁻¹·m⁻² when the input is
// calibrated), irradiance in radiance units · sr. Errors are fractions. Everything here is printed or drawn; nothing is
// measured again.

/// Differences from the brute-force sum over all texels.
struct Verification {
  int directions = 0;
  double rms = 0;    ///< of the relative difference
  double worst = 0;  ///< the largest relative difference
};

/// One level of the prefiltered chain. Level 0 is the environment itself, with an empty report.
struct ChainLevel {
  Environment map;
  double roughness = 0, alpha = 0;
  ConvolveReport report = {};
  std::optional<Verification> verified = {};
};

/// Irradiance from the first `bands` bands of the environment, beside the exact one.
struct ShFit {
  int bands = 0;
  Environment irradiance;
  double rms = 0, worst = 0;  ///< difference from the exact irradiance over the sphere, fractions of its maximum
};

struct WrittenFile {
  std::string name, what;
  std::uint64_t bytes = 0;
};

struct Timing {
  std::string stage;
  double seconds = 0;
};

/// A few lines of code or shell that use the result.
struct Snippet {
  std::string title, code;
};

struct BakePage {
  std::string title;     ///< the input's name, as it is
  std::string subtitle;  ///< format, size, projection and how it was recognised
  Environment panorama;  ///< any projection
  Survey survey;

  Environment irradiance;               ///< exact, any projection
  RgbD irradiance_up, irradiance_down;  ///< on horizontal surfaces facing +Z and -Z
  ConvolveReport irradiance_report;
  std::optional<Verification> irradiance_verified;

  std::string lobe;  ///< the chain's, in words: "GGX", "Phong"
  std::vector<ChainLevel> chain;
  std::vector<ShFit> sh;

  Image<Rgb> split_sum;  ///< n·v from left to right, roughness from top to bottom, both rising; empty: none was made
  std::string split_sum_channels;  ///< what red, green and blue hold

  std::vector<std::string> warnings;  ///< beyond those that the survey gives reason for
  std::vector<WrittenFile> files;
  std::vector<Fact> settings;
  std::vector<Timing> timings;
  std::vector<Snippet> loading;
  std::string footer;  ///< program and version

  BakePageViewer viewer;  ///< empty: the page has no viewer and no script
};

/// The self-contained page: at most about 3 MB beside its viewer, whatever the sizes of the maps. The same values give
/// the same bytes on any number of threads. Throws Error{kInput} when a map's size does not fit its projection,
/// Error{kCancelled}.
std::string bake_page_html(const BakePage&, const Run& = {});

}  // namespace zonal
