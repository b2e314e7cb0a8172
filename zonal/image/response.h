#pragma once

#include <array>

#include "zonal/image/exposures.h"

namespace zonal {

/// The codes at which a response is tabulated: i / 255. Values between them are interpolated.
inline constexpr int kCodes = 256;
using ResponseCurve = std::array<double, kCodes>;

/// How a camera's encoded values answer to light: for each channel the exposure (radiance times seconds) that gives
/// code i / 255, never falling with i.
///
/// Scale. A curve is known up to a factor. Ours makes radiance 1 that which fills an exposure of 1 s: exactly so for
/// the curves given (1 at full code); an estimated curve has at code 128, where it is known best, the value that sRGB
/// has there. The channels get the same value, so that a grey 128 is grey radiance.
struct Response {
  std::array<ResponseCurve, 3> exposure = {};

  static Response linear();
  static Response srgb();
  /// The exposure for an encoded value; beyond 0..1 the straight continuation of the ends (float pictures).
  double operator()(int channel, double encoded) const;
};

/// The code at which curves are tied together, and the exposure there.
inline constexpr int kMiddleCode = 128;
double middle_exposure();

/// The nearest curve, by weighted least squares, that does not fall: runs that do are replaced by their mean (pool
/// adjacent violators, Ayer et al. 1955). Returns how many codes changed.
int make_monotone(std::span<double> curve, std::span<const double> weights);

/// How a code counts in sums over exposures.
enum class CodeWeight {
  kHat,       ///< Debevec & Malik 1997, eq. 4: linear from 0 at the lowest trusted code to 1 in the middle and back
  kGaussian,  ///< Robertson et al. 1999: exp(-4 ((z - middle) / half)²), lowered and scaled so as to end at 0
};

/// The range of trusted codes, in 0..255: at `lowest` and below it a value counts as black, from `highest` up as
/// saturated.
struct TrustedCodes {
  double lowest = 0, highest = 255;
  bool operator==(const TrustedCodes&) const = default;
};
using TrustedRanges = std::array<TrustedCodes, 3>;  ///< of red, green and blue

/// The weight of an encoded value 0..1, in 0..1; NaN (no data) has none.
double code_weight(CodeWeight, TrustedCodes, double encoded);

/// An estimated response and what it rests on.
struct ResponseFit {
  Response response;
  int pixels = 0;                           ///< that were looked at
  std::array<int, 3> codes_seen = {};       ///< of 256, with weight; the others are interpolated
  std::array<int, 3> codes_flattened = {};  ///< where the raw curve fell and was levelled
  std::array<double, 3> rms_log2 = {};      ///< weighted RMS of log2(exposure / (radiance * seconds)), in stops
  int iterations = 0;                       ///< Robertson's; 0: a direct solution
  bool converged = true;
};

}  // namespace zonal
