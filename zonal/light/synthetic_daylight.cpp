#include <algorithm>
#include <array>
#include <cmath>

#include "zonal/base/error.h"
#include "zonal/base/parallel.h"
#include "zonal/light/synthetic.h"
#include "zonal/light/synthetic_disc.h"
#include "zonal/light/synthetic_texel.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

// Preetham, Shirley & Smits 1999, "A practical analytic model for daylight", appendix A.

/// The five parameters of Perez et al. 1993, each linear in the turbidity: {slope, constant}.
using Perez = std::array<std::array<double, 2>, 5>;
constexpr Perez kLuminance = {
    {{0.1787, -1.4630}, {-0.3554, 0.4275}, {-0.0227, 5.3251}, {0.1206, -2.5771}, {-0.0670, 0.3703}}};
constexpr Perez kChromaX = {
    {{-0.0193, -0.2592}, {-0.0665, 0.0008}, {-0.0004, 0.2125}, {-0.0641, -0.8989}, {-0.0033, 0.0452}}};
constexpr Perez kChromaY = {
    {{-0.0167, -0.2608}, {-0.0950, 0.0092}, {-0.0079, 0.2102}, {-0.0441, -1.6537}, {-0.0109, 0.0529}}};

/// Zenith chromaticity: rows for T², T, 1; columns for θ³, θ², θ, 1 of the sun's zenith angle.
using ZenithTable = std::array<std::array<double, 4>, 3>;
constexpr ZenithTable kZenithX = {
    {{0.00166, -0.00375, 0.00209, 0}, {-0.02903, 0.06377, -0.03202, 0.00394}, {0.11693, -0.21196, 0.06052, 0.25886}}};
constexpr ZenithTable kZenithY = {
    {{0.00275, -0.00610, 0.00317, 0}, {-0.04214, 0.08970, -0.04153, 0.00516}, {0.15346, -0.26756, 0.06670, 0.26688}}};

constexpr double kSunDiameterDeg = 0.533;
/// Illuminance by the sun outside the atmosphere, in thousand lux (Littlefair 1985: 128).
constexpr double kSolarKilolux = 128;

double zenith_chroma(const ZenithTable& table, double turbidity, double theta) {
  double sum = 0;
  for (const auto& row : table) sum = sum * turbidity + ((row[0] * theta + row[1]) * theta + row[2]) * theta + row[3];
  return sum;
}

/// Perez's distribution over the sky, relative to its value at the zenith (eq. 3).
class Distribution {
 public:
  Distribution(const Perez& table, double turbidity, double sun_zenith_angle, double at_zenith) {
    for (int i = 0; i < 5; ++i) p_[i] = table[i][0] * turbidity + table[i][1];
    scale_ = at_zenith / shape(1, sun_zenith_angle);
  }
  double operator()(double cos_zenith_angle, double angle_to_sun) const {
    return scale_ * shape(cos_zenith_angle, angle_to_sun);
  }

 private:
  double shape(double cos_zenith_angle, double gamma) const {
    const double c = std::cos(gamma);
    return (1 + p_[0] * std::exp(p_[1] / cos_zenith_angle)) * (1 + p_[2] * std::exp(p_[3] * gamma) + p_[4] * c * c);
  }
  std::array<double, 5> p_{};
  double scale_ = 0;
};

/// CIE xyY to linear Rec. 709 (ITU-R BT.709-6 primaries, D65), colours outside its gamut moved to its border.
RgbD rgb_from_xyy(double x, double y, double luminance_value) {
  const double big_x = x / y * luminance_value, big_y = luminance_value, big_z = (1 - x - y) / y * luminance_value;
  return {std::max(0.0, 3.2406 * big_x - 1.5372 * big_y - 0.4986 * big_z),
          std::max(0.0, -0.9689 * big_x + 1.8758 * big_y + 0.0415 * big_z),
          std::max(0.0, 0.0557 * big_x - 0.2040 * big_y + 1.0570 * big_z)};
}

class ClearSky {
 public:
  ClearSky(Vec3 toward_sun, double turbidity)
      : toward_sun_(toward_sun),
        theta_(std::acos(std::clamp(toward_sun.z, -1.0, 1.0))),
        luminance_(kLuminance, turbidity, theta_, zenith_luminance(turbidity)),
        x_(kChromaX, turbidity, theta_, zenith_chroma(kZenithX, turbidity, theta_)),
        y_(kChromaY, turbidity, theta_, zenith_chroma(kZenithY, turbidity, theta_)) {}

  /// Radiance from a direction of the upper half.
  RgbD operator()(Vec3 d) const {
    // The model divides by the cosine; at the horizon itself its limit is reached long before this.
    const double up = std::max(d.z, 1e-3), gamma = angle_between(d, toward_sun_);
    return rgb_from_xyy(x_(up, gamma), y_(up, gamma), std::max(0.0, luminance_(up, gamma)));
  }

  /// On level ground: the midpoint rule in z² and azimuth, in which cos θ dω is uniform.
  RgbD irradiance() const {
    constexpr int kRings = 64, kAround = 128;
    RgbD sum;
    for (int i = 0; i < kRings; ++i) {
      const double z = std::sqrt((i + 0.5) / kRings), s = std::sqrt(1 - z * z);
      for (int j = 0; j < kAround; ++j) {
        const double azimuth = 2 * kPi * (j + 0.5) / kAround;
        sum += (*this)({s * std::cos(azimuth), s * std::sin(azimuth), z});
      }
    }
    return (kPi / (kRings * kAround)) * sum;
  }

 private:
  double zenith_luminance(double t) const {
    const double chi = (4.0 / 9 - t / 120) * (kPi - 2 * theta_);
    return (4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192;
  }

  Vec3 toward_sun_;
  double theta_;  // the sun's zenith angle
  Distribution luminance_, x_, y_;
};

/// What the air lets through of the sun's light, per channel at its dominant wavelength: Rayleigh and aerosol
/// scattering of the paper's appendix A.1 (ozone, gas and water vapour, a few percent, are left out). White outside the
/// atmosphere.
RgbD transmittance(double elevation_deg, double turbidity) {
  const double zenith_deg = 90 - elevation_deg;
  const double air_mass = 1 / (std::sin(radians(elevation_deg)) + 0.15 * std::pow(93.885 - zenith_deg, -1.253));
  const double beta = 0.04608 * turbidity - 0.04586;
  const auto at = [&](double micrometres) {
    return std::exp(-air_mass * (0.008735 * std::pow(micrometres, -4.08) + beta * std::pow(micrometres, -1.3)));
  };
  return {at(0.6112), at(0.5491), at(0.4643)};  // dominant wavelengths of the Rec. 709 primaries
}

}  // namespace

Environment daylight_sky(const Projection& projection, ImageSize size, const DaylightOptions& options, const Run& run) {
  if (!(options.elevation_deg > 0 && options.elevation_deg <= 90)) {
    throw Error(ErrorKind::kUsage, "the sun must stand above the horizon", "give an elevation in (0, 90] degrees");
  }
  if (!(options.turbidity >= 2 && options.turbidity <= 10)) {
    throw Error(ErrorKind::kUsage, "the sky model holds for a turbidity of 2 to 10");
  }
  const double elevation = radians(options.elevation_deg), azimuth = radians(options.azimuth_deg);
  const Vec3 toward_sun = {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                           std::sin(elevation)};
  const ClearSky sky(toward_sun, options.turbidity);

  const double sun_radius = radians(kSunDiameterDeg) / 2;
  const RgbD sun_irradiance = kSolarKilolux * transmittance(options.elevation_deg, options.turbidity);
  const RgbD sun_radiance = (1 / (2 * kPi * (1 - std::cos(sun_radius)))) * sun_irradiance;
  RgbD ground_irradiance = sky.irradiance();
  if (options.sun) ground_irradiance += toward_sun.z * sun_irradiance;
  const RgbD ground = (1 / kPi) * (RgbD(options.ground_albedo) * ground_irradiance);

  const Mapping mapping(projection, size);
  Environment result{Image<Rgb>(size.width, size.height), projection};
  const auto radiance = [&](Vec3 d) { return d.z > 0 ? sky(d) : ground; };
  for_each_block(run, "daylight", size.height, 8, [&](Block block) {
    for (int y = block.begin; y < block.end; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const auto toward = mapping.texel_direction(x, y);
        if (!toward) continue;
        // Only texels that the horizon may cross are worth more than one point.
        const bool horizon = std::abs(toward->z) < 2 * std::sqrt(mapping.solid_angle(x, y));
        result.radiance(x, y) = Rgb(texel_mean<RgbD>(mapping, x, y, horizon ? 4 : 1, radiance));
      }
    }
  });
  if (options.sun) add_disc(result, toward_sun, sun_radius, sun_radiance);
  return result;
}

}  // namespace zonal
