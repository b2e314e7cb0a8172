#pragma once

#include <vector>

#include "zonal/base/grid.h"
#include "zonal/base/run.h"
#include "zonal/math/vec.h"
#include "zonal/sht/transform.h"

namespace zonal {

/// How much of the sphere is how bright, and which texels outshine the rest: all that error bounds need to know about a
/// map. Brightness is the largest absolute channel. Texels are looked at in groups of 16 neighbours that count as
/// bright as their brightest.
class Distribution {
 public:
  struct Bin {
    float upper = 0;         ///< no texel of the bin is brighter
    double solid_angle = 0;  ///< steradians
  };
  /// A texel that outshines the rest.
  struct Peak {
    GridTexel texel;
    double energy = 0;  ///< brightness times solid angle
  };

  /// `weights[y]` is the solid angle of a texel of row y. Takes out as peaks the texels that hold more than
  /// `peak_share` of the energy each and are ten times as bright as the mean, at most `most_peaks` of them (the
  /// largest). The same for any number of threads. Throws Error{kInput} when a value is not finite.
  Distribution(const Grid<Rgb>& map, const std::vector<double>& weights, double peak_share, int most_peaks,
               const Run& run);

  double energy() const { return energy_; }   ///< ∫ of the mean absolute channel, peaks included
  float maximum() const { return maximum_; }  ///< the greatest brightness
  bool any_negative() const { return any_negative_; }
  const std::vector<Peak>& peaks() const { return peaks_; }  ///< brightest first
  const std::vector<Bin>& rest() const { return rest_; }     ///< the others, brightest first, in steps of 1/8 octave

 private:
  double energy_ = 0;
  float maximum_ = 0;
  bool any_negative_ = false;
  std::vector<Peak> peaks_;
  std::vector<Bin> rest_;
};

/// The most that Σ f(s) |e(s)| can be over all arrangements of f on the sphere, when |e| takes `errors[i]` on
/// `solid_angles[i]`: the brightest parts meet the largest errors (Hardy, Littlewood & Pólya 1934, theorem 368).
double rearrangement_bound(const std::vector<Distribution::Bin>& bins, std::vector<double> errors,
                           const std::vector<double>& solid_angles);

}  // namespace zonal
