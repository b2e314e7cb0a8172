#include "zonal/io/exposure_time.h"

#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <libexif/exif-data.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "zonal/base/check.h"
#include "zonal/io/exif.h"
#include "zonal/io/exr_headers.h"
#include "zonal/io/exr_stream.h"

namespace zonal {
namespace {

struct Release {
  void operator()(ExifData* data) const { exif_data_unref(data); }
};

/// A tag's first value as a number; nullopt where it is not there or no number.
std::optional<double> number_of(ExifData* data, ExifTag tag) {
  for (const ExifIfd ifd : {EXIF_IFD_EXIF, EXIF_IFD_0}) {
    const ExifEntry* entry = exif_content_get_entry(data->ifd[ifd], tag);
    if (!entry || entry->components < 1 || entry->size < exif_format_get_size(entry->format)) continue;
    const ExifByteOrder order = exif_data_get_byte_order(data);
    switch (entry->format) {
      case EXIF_FORMAT_SHORT:
        return exif_get_short(entry->data, order);
      case EXIF_FORMAT_LONG:
        return exif_get_long(entry->data, order);
      case EXIF_FORMAT_RATIONAL: {
        const ExifRational r = exif_get_rational(entry->data, order);
        if (r.denominator != 0) return static_cast<double>(r.numerator) / r.denominator;
        break;
      }
      case EXIF_FORMAT_SRATIONAL: {
        const ExifSRational r = exif_get_srational(entry->data, order);
        if (r.denominator != 0) return static_cast<double>(r.numerator) / r.denominator;
        break;
      }
      default:
        break;
    }
  }
  return std::nullopt;
}

std::optional<double> positive(std::optional<double> value) {
  return value && *value > 0 && std::isfinite(*value) ? value : std::nullopt;
}

/// 2^(value * factor): the APEX units of EXIF.
std::optional<double> from_apex(std::optional<double> value, double factor) {
  return value ? positive(std::exp2(factor * *value)) : std::nullopt;
}

ExposureSettings settings_of_exif(const std::vector<std::uint8_t>& block) {
  const std::unique_ptr<ExifData, Release> data(
      exif_data_new_from_data(block.data(), static_cast<unsigned>(block.size())));
  if (!data) return {};
  ExposureSettings settings;
  settings.seconds = positive(number_of(data.get(), EXIF_TAG_EXPOSURE_TIME));
  if (!settings.seconds) settings.seconds = from_apex(number_of(data.get(), EXIF_TAG_SHUTTER_SPEED_VALUE), -1);
  settings.f_number = positive(number_of(data.get(), EXIF_TAG_FNUMBER));
  if (!settings.f_number) settings.f_number = from_apex(number_of(data.get(), EXIF_TAG_APERTURE_VALUE), 0.5);
  settings.iso = positive(number_of(data.get(), EXIF_TAG_ISO_SPEED_RATINGS));
  return settings;
}

ExposureSettings settings_of_exr(ByteReader& reader) {
  try {
    check_exr_headers(reader, {});
    ExrInput stream(reader);
    const Imf::MultiPartInputFile file(stream, 0, false);
    const Imf::Header& header = file.header(0);
    ExposureSettings settings;
    if (Imf::hasExpTime(header)) settings.seconds = positive(Imf::expTime(header));
    if (Imf::hasAperture(header)) settings.f_number = positive(Imf::aperture(header));
    if (Imf::hasIsoSpeed(header)) settings.iso = positive(Imf::isoSpeed(header));
    return settings;
  } catch (const std::exception&) {
    return {};  // whoever reads the picture says what is wrong with it
  }
}

ExposureSettings settings_in(ByteReader& reader) {
  constexpr std::array<std::uint8_t, 4> kExr = {0x76, 0x2f, 0x31, 0x01};
  const std::vector<std::uint8_t> head = reader.head(kExr.size());
  if (std::equal(head.begin(), head.end(), kExr.begin(), kExr.end())) return settings_of_exr(reader);
  const std::vector<std::uint8_t> block = find_exif(reader);
  return block.empty() ? ExposureSettings{} : settings_of_exif(block);
}

}  // namespace

ExposureSettings decode_exposure_settings(std::vector<std::byte> file) {
  ByteReader reader("", std::move(file));
  return settings_in(reader);
}

ExposureSettings read_exposure_settings(const std::filesystem::path& path) {
  ByteReader reader(path);
  return settings_in(reader);
}

double equivalent_seconds(const ExposureSettings& settings, const ExposureSettings& as) {
  check(settings.seconds.has_value(), "an exposure needs its time");
  double seconds = *settings.seconds * std::pow(10, as.density - settings.density);
  if (settings.f_number && as.f_number) seconds *= std::pow(*as.f_number / *settings.f_number, 2);
  if (settings.iso && as.iso) seconds *= *settings.iso / *as.iso;
  return seconds;
}

std::optional<double> full_code_luminance(const ExposureSettings& settings) {
  if (!settings.f_number || !settings.iso) return std::nullopt;
  constexpr double kSaturation = 78, kLens = 0.65;  // ISO 12232:2006
  return kSaturation / kLens * *settings.f_number * *settings.f_number / *settings.iso * std::pow(10, settings.density);
}

}  // namespace zonal
