#include "apps/zonal/merge_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "apps/zonal/numbers.h"
#include "zonal/base/parallel.h"
#include "zonal/io/exposure_list.h"
#include "zonal/io/file.h"
#include "zonal/io/picture.h"

namespace zonal {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t kLargestList = 1 << 20;
/// How far from the colour to be ignored a code may be: scanners and scaling blur it a little.
constexpr float kIgnoreTolerance = 15.0f / 255;

std::vector<ExposureSettings> settings_from_files(const std::vector<fs::path>& paths) {
  std::vector<ExposureSettings> settings;
  for (const fs::path& path : paths) {
    settings.push_back(read_exposure_settings(path));
    if (settings.back().seconds) continue;
    throw Error(
        ErrorKind::kInput, path.string() + ": the file does not say how long it was exposed",
        "say it: --times 1/1000,1/250,1/60 in the order of the pictures, or --times with a file that lists them; "
        "pictures alone cannot tell");
  }
  return settings;
}

/// Settings by the names in a list, or in its order where it has none. Names count without their folder, and without
/// their extension when no extension fits: lists outlive conversions.
std::vector<ExposureSettings> settings_from_list(const fs::path& list, const std::vector<fs::path>& paths) {
  const std::vector<std::byte> bytes = read_file(list, kLargestList);
  const std::vector<ListedExposure> listed =
      parse_exposure_list(list.string(), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  const bool named = std::none_of(listed.begin(), listed.end(), [](const auto& l) { return l.file.empty(); });
  std::vector<ExposureSettings> settings;
  if (!named) {
    if (listed.size() != paths.size()) {
      throw Error(ErrorKind::kInput,
                  fmt::format("{} lists {} exposures for {} pictures", list.string(), listed.size(), paths.size()),
                  "one line for each picture, in their order");
    }
    for (const ListedExposure& l : listed) settings.push_back(l.settings);
    return settings;
  }
  for (const fs::path& path : paths) {
    const auto with = [&](auto part) {
      return std::find_if(listed.begin(), listed.end(),
                          [&](const ListedExposure& l) { return part(fs::path(l.file)) == part(path); });
    };
    auto found = with([](const fs::path& p) { return p.filename(); });
    if (found == listed.end()) found = with([](const fs::path& p) { return p.stem(); });
    if (found == listed.end()) {
      throw Error(ErrorKind::kInput, fmt::format("{} does not list {}", list.string(), path.filename().string()),
                  "add a line with its name and its exposure");
    }
    settings.push_back(found->settings);
  }
  return settings;
}

std::vector<ExposureSettings> settings_of(const BracketOptions& options) {
  if (options.times.empty()) return settings_from_files(options.paths);
  std::error_code ignored;
  if (fs::exists(options.times, ignored)) return settings_from_list(options.times, options.paths);
  const std::vector<double> times = parse_exposure_times(options.times);
  if (times.size() != options.paths.size()) {
    throw Error(ErrorKind::kUsage, fmt::format("--times: {} times for {} pictures", times.size(), options.paths.size()),
                "one for each picture, in their order");
  }
  std::vector<ExposureSettings> settings(times.size());
  for (std::size_t i = 0; i < times.size(); ++i) settings[i].seconds = times[i];
  return settings;
}

/// What some pictures state and others do not cannot be allowed for.
void warn_of_gaps(const std::vector<ExposureSettings>& settings, Console& console) {
  const auto gap = [&](auto member) {
    const auto known =
        std::count_if(settings.begin(), settings.end(), [&](const auto& s) { return member(s).has_value(); });
    return known != 0 && known != static_cast<std::ptrdiff_t>(settings.size());
  };
  if (gap([](const ExposureSettings& s) { return s.f_number; })) {
    console.warn("only some of the pictures state their aperture: it is taken to be the same for all");
  }
  if (gap([](const ExposureSettings& s) { return s.iso; })) {
    console.warn("only some of the pictures state their ISO speed: it is taken to be the same for all");
  }
}

struct Loaded {
  CodedPicture picture;
  bool is_float = false;
  std::vector<std::string> notes;
};

Loaded load(const fs::path& path, std::int64_t max_pixels) {
  // The codes as they are: what they mean is the response's business.
  Picture picture = load_picture(path, {.max_pixels = max_pixels, .encoding = Encoding::kLinear});
  const bool is_float = picture.format == "OpenEXR" || picture.format == "Radiance HDR" || picture.format == "PFM";
  try {
    return {CodedPicture(picture.pixels), is_float, std::move(picture.notes)};
  } catch (const Error& e) {
    throw Error(e.kind(), path.string() + ": " + e.what(), e.hint());
  }
}

void ignore_color(const std::string& codes, Bracket& bracket, Console& console) {
  const std::vector<double> color = numbers_in(codes, 3, 3, "--ignore");
  const Rgb encoded{static_cast<float>(color[0] / 255), static_cast<float>(color[1] / 255),
                    static_cast<float>(color[2] / 255)};
  std::int64_t most = 0;
  for (Exposure& exposure : bracket.exposures) most = std::max(most, mark_missing(exposure, encoded, kIgnoreTolerance));
  console.note(fmt::format("--ignore {}: up to {} texels of a picture hold no data", codes, most));
}

}  // namespace

Bracket read_bracket(const BracketOptions& options, Call& call) {
  const std::vector<ExposureSettings> settings = settings_of(options);
  warn_of_gaps(settings, call.console);
  std::vector<Loaded> loaded(options.paths.size());
  for_each_block(call.run, "reading", static_cast<int>(loaded.size()), 1,
                 [&](Block block) { loaded[block.begin] = load(options.paths[block.begin], options.max_pixels); });

  std::set<std::string> notes;
  std::size_t floats = 0;
  for (const Loaded& one : loaded) {
    notes.insert(one.notes.begin(), one.notes.end());
    floats += one.is_float;
  }
  for (const std::string& note : notes) call.console.note(note);
  if (floats != 0 && floats != loaded.size()) {
    throw Error(ErrorKind::kInput, "some of the pictures are linear floats and some are not",
                "develop all photographs of a bracket alike");
  }
  Bracket bracket;
  bracket.reference = settings[0];
  bracket.linear = floats != 0;
  for (std::size_t i = 0; i < loaded.size(); ++i) {
    bracket.exposures.push_back(
        {options.paths[i].string(), equivalent_seconds(settings[i], bracket.reference), std::move(loaded[i].picture)});
  }
  arrange(bracket.exposures);
  if (!options.ignore.empty()) ignore_color(options.ignore, bracket, call.console);
  return bracket;
}

}  // namespace zonal
