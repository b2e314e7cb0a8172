#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace zonal {

/// What a camera wrote about how a photograph was exposed. Only positive, finite values.
struct ExposureSettings {
  std::optional<double> seconds;
  std::optional<double> f_number;
  std::optional<double> iso;  ///< ISO 12232 speed
  double density = 0;         ///< optical density of neutral filters: light times 10^-density

  bool operator==(const ExposureSettings&) const = default;
};

/// The settings that a file states: in the EXIF block of a JPEG or PNG (EXIF 2.3: ExposureTime or ShutterSpeedValue,
/// FNumber or ApertureValue, PhotographicSensitivity), or as an OpenEXR file's standard attributes (expTime, aperture,
/// isoSpeed). Empty for files without them and for other formats. Any bytes are safe. Throws Error{kInput} when the
/// file cannot be read.
ExposureSettings read_exposure_settings(const std::filesystem::path&);
ExposureSettings decode_exposure_settings(std::vector<std::byte> file);

/// The exposure relative to that at `as`: seconds at its aperture, sensitivity and filter. Settings that either does
/// not state do not count. seconds must be there.
double equivalent_seconds(const ExposureSettings&, const ExposureSettings& as);

/// The luminance in cd/m² that fills full code in an exposure of 1 s (at this aperture and sensitivity):
/// saturation-based speed, ISO 12232:2006, S = 78 / H, with H = 0.65 L t / N² on the sensor: L = 120 N² / S. nullopt
/// unless both are known. A camera's own curve and lens make it right to some ten per cent only.
std::optional<double> full_code_luminance(const ExposureSettings&);

}  // namespace zonal
