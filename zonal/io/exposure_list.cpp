#include "zonal/io/exposure_list.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>

#include "zonal/base/error.h"

namespace zonal {
namespace {

std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// "1/250", "0.004" or "-8ev"; nullopt: none of them, or not positive.
std::optional<double> seconds_in(std::string_view text) {
  std::optional<double> seconds;
  if (text.ends_with("ev") || text.ends_with("EV")) {
    const std::optional<double> steps = number_in(text.substr(0, text.size() - 2));
    if (steps) seconds = std::exp2(*steps);
  } else if (const std::size_t slash = text.find('/'); slash != std::string_view::npos) {
    const std::optional<double> top = number_in(text.substr(0, slash)), bottom = number_in(text.substr(slash + 1));
    if (top && bottom && *bottom > 0) seconds = *top / *bottom;
  } else {
    seconds = number_in(text);
  }
  return seconds && *seconds > 0 && std::isfinite(*seconds) ? seconds : std::nullopt;
}

std::vector<std::string_view> split(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(separators), text.size());
    if (end > 0) parts.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

/// The columns of hdrgen and its relatives; nullopt: they are none.
std::optional<ExposureSettings> hdrgen_settings(std::span<const std::string_view> columns, bool gain) {
  ExposureSettings settings;
  const std::optional<double> rate = number_in(columns[0]);
  if (!rate || !(*rate > 0)) return std::nullopt;
  settings.seconds = 1 / *rate;
  if (columns.size() > 1) {
    settings.f_number = number_in(columns[1]);
    if (!settings.f_number || !(*settings.f_number > 0)) return std::nullopt;
  }
  if (columns.size() > 2) {
    const std::optional<double> value = number_in(columns[2]);
    if (!value) return std::nullopt;
    // A gain only compares exposures with each other: as a time it does that, and claims no ISO speed.
    if (gain) *settings.seconds *= std::exp2(*value / 3);
    if (!gain && *value > 0) settings.iso = *value;
  }
  if (columns.size() > 3) {
    const std::optional<double> density = number_in(columns[3]);
    if (!density || *density < 0) return std::nullopt;
    settings.density = *density;
  }
  return settings;
}

std::optional<ListedExposure> exposure_in(std::span<const std::string_view> columns, bool gain) {
  ListedExposure exposure;
  if (columns.size() <= 2) {
    exposure.settings.seconds = seconds_in(columns.back());
    if (!exposure.settings.seconds) return std::nullopt;
    if (columns.size() == 2) exposure.file = columns[0];
    return exposure;
  }
  if (columns.size() > 5) return std::nullopt;
  const std::optional<ExposureSettings> settings = hdrgen_settings(columns.subspan(1), gain);
  if (!settings) return std::nullopt;
  return ListedExposure{std::string(columns[0]), *settings};
}

}  // namespace

std::vector<double> parse_exposure_times(std::string_view text) {
  std::vector<double> times;
  std::size_t evs = 0;
  while (true) {
    const std::size_t end = std::min(text.find(','), text.size());
    const std::string_view word = text.substr(0, end);
    const std::optional<double> seconds = seconds_in(word);
    if (!seconds) {
      throw Error(ErrorKind::kUsage, "--times: '" + std::string(word) + "' is no exposure time",
                  "give positive seconds as in 1/1000,1/250,0.5, steps as in -2ev,0ev,2ev, or a file that lists them");
    }
    times.push_back(*seconds);
    evs += word.ends_with("ev") || word.ends_with("EV");
    if (end == text.size()) break;
    text.remove_prefix(end + 1);
  }
  if (evs != 0 && evs != times.size()) {
    throw Error(ErrorKind::kUsage, "--times: seconds and ev steps in one list", "use one of them for all exposures");
  }
  return times;
}

std::vector<ListedExposure> parse_exposure_list(const std::string& name, std::string_view text) {
  std::vector<ListedExposure> exposures;
  bool gain = false;
  int line_number = 0, count_line = 0;
  for (std::size_t begin = 0; begin < text.size(); ++line_number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    if (const std::size_t comment = line.find('#'); comment != std::string_view::npos) {
      std::string words(line.substr(comment));
      std::transform(words.begin(), words.end(), words.begin(),
                     [](char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
      gain = gain || words.find("gain") != std::string::npos;
      line = line.substr(0, comment);
    }
    const std::vector<std::string_view> columns = split(line, " \t\r");
    if (columns.empty()) continue;
    const std::optional<ListedExposure> exposure = exposure_in(columns, gain);
    if (!exposure) {
      throw Error(ErrorKind::kInput,
                  name + ", line " + std::to_string(line_number + 1) + ": '" + std::string(line) + "' is no exposure",
                  "a line is TIME, FILE TIME, or FILE 1/SECONDS F-NUMBER ISO DENSITY");
    }
    if (exposures.empty()) count_line = columns.size() == 1 ? 1 : 0;
    exposures.push_back(*exposure);
  }
  // "16" before lines of several columns says how many there are.
  if (count_line == 1 && exposures.size() > 1 && !exposures[1].file.empty()) exposures.erase(exposures.begin());
  if (exposures.empty())
    throw Error(ErrorKind::kInput, name + ": the list holds no exposure", "one line for each picture");
  return exposures;
}

}  // namespace zonal
