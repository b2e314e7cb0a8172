#include "apps/zonal/coefficients.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "apps/zonal/input_options.h"
#include "zonal/io/file.h"
#include "zonal/light/project.h"
#include "zonal/sh/rotate.h"

namespace zonal {
namespace fs = std::filesystem;
namespace {

/// 1024 bands of three doubles with all their digits are 80 MB.
constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 28;
/// The matrices of a turn of so many bands hold 180 MB.
constexpr int kMaxTurnedBands = 256;

bool is_standard_input(const fs::path& path) { return path == "-"; }

std::string standard_input() {
  std::string text;
  std::array<char, 1 << 16> buffer;
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), stdin)) {
    text.append(buffer.data(), count);
    if (text.size() > kMaxBytes) throw Error(ErrorKind::kInput, "standard input is longer than any coefficients");
  }
  if (std::ferror(stdin) != 0) throw Error(ErrorKind::kInput, "standard input cannot be read");
  return text;
}

bool holds_coefficients(const fs::path& path) {
  if (is_standard_input(path) || path.extension() == ".json") return true;
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored) || path.extension() == ".tga") return false;  // a TGA may begin with any byte
  std::ifstream file(path, std::ios::binary);
  char first = 0;
  return file >> first && first == '{';
}

/// Throws where the user described a picture.
void refuse_picture_options(const InputOptions& o) {
  const std::pair<bool, const char*> given[] = {{o.from.has_value(), "--from"},
                                                {o.lens.has_value(), "--lens"},
                                                {o.fov_deg.has_value(), "--fov"},
                                                {!o.center.empty(), "--center"},
                                                {!o.radius.empty(), "--radius"},
                                                {o.encoding != Encoding::kAuto, "--encoding"},
                                                {o.fix, "--fix"},
                                                {o.uncovered.has_value(), "--uncovered"},
                                                {!o.ground.empty(), "--ground"}};
  for (const auto& [is_given, option] : given) {
    if (is_given) {
      throw Error(ErrorKind::kUsage, fmt::format("{} describes a picture; this input holds coefficients", option),
                  "leave it out");
    }
  }
}

Sh<RgbD> turned(const Sh<RgbD>& sh, const InputOptions& options) {
  const Rotation rotation = rotation_of(options);
  if (rotation == Rotation::identity()) return sh;
  if (sh.bands() > kMaxTurnedBands && !is_about_z(rotation)) {
    throw Error(ErrorKind::kUsage, fmt::format("{} bands are too many to be pitched or rolled", sh.bands()),
                fmt::format("--bands {} leaves out the rest, or turn the picture they came from", kMaxTurnedBands));
  }
  return rotate(sh, rotation);
}

Coefficients from_file(const CoefficientOptions& options, Call& call) {
  refuse_picture_options(options.input);
  Coefficients result{read_sh_file(options.input.paths[0]), {}};
  Sh<RgbD>& sh = result.sh.coefficients;
  const int in_file = sh.bands(), bands = options.bands.value_or(in_file);
  if (bands < in_file) call.console.note(fmt::format("the first {} of the {} bands in the file", bands, in_file));
  if (bands > in_file) {
    call.console.note(fmt::format("the file has {} bands: those from there to {} are zero", in_file, bands));
  }
  // A turn keeps each band to itself, so those that are left out need not be turned.
  sh = with_bands(turned(with_bands(sh, std::min(bands, in_file)), options.input), bands);
  return result;
}

/// Of the part that the picture shows, scaled up to the whole sphere, when the rest is to be left out.
Coefficients from_picture(const CoefficientOptions& options, Call& call) {
  Input input = read_input(options.input, call);
  WholeLight light = whole_light(input, options.input, call);
  Sh<RgbD> sh = project(light.environment, options.bands.value_or(options.picture_bands), call.run);
  if (light.shown) {
    const double shown_share = project(*light.shown, 1, call.run)(0, 0).r / std::sqrt(4 * kPi);
    if (shown_share > 0) sh *= 1 / shown_share;
  }
  return {{ShQuantity::kRadiance, std::move(sh)}, std::move(light.environment)};
}

}  // namespace

void add_coefficient_options(CLI::App& verb, CoefficientOptions& options) {
  add_input_options(verb, options.input);
  verb.get_option("IN")->description(
      "a file of coefficients (sh.json), - for one on standard input, or a picture: EXR, HDR, PFM, PNG, JPEG, TGA, a "
      "folder with six cube faces, six pictures +X -X +Y -Y +Z -Z, or two (front, back)");
  verb.add_option("--bands", options.bands,
                  fmt::format("N bands are N² coefficients; {} of a picture and all of a file if not said. Fewer than "
                              "in the file leave out the rest, more are zero",
                              options.picture_bands))
      ->check(CLI::Range(1, 1024))
      ->group("Coefficients");
}

Coefficients read_coefficients(const CoefficientOptions& options, Call& call) {
  const auto& paths = options.input.paths;
  const auto file = std::find_if(paths.begin(), paths.end(), holds_coefficients);
  if (file == paths.end()) return from_picture(options, call);
  if (paths.size() > 1) {
    throw Error(ErrorKind::kUsage, fmt::format("{} holds coefficients and needs no other input", file->string()),
                "name one file of coefficients, or pictures");
  }
  return from_file(options, call);
}

std::string read_text(const fs::path& path) {
  if (is_standard_input(path)) return standard_input();
  const std::vector<std::byte> bytes = read_file(path, kMaxBytes);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

ShFile read_sh_file(const fs::path& path) {
  const std::string text = read_text(path);
  try {
    return parse_sh_json(text);
  } catch (const Error& e) {
    const std::string name = is_standard_input(path) ? "standard input" : path.string();
    throw Error(
        e.kind(), name + ": " + e.what(),
        e.hint().empty() ? "zonal sh, zonal light and zonal multiply write such files, without --json" : e.hint());
  }
}

JsonValue coefficients_json(std::span<const RgbD> coefficients) {
  JsonValue::Array list;
  for (const RgbD& c : coefficients) list.push_back(JsonValue::Array{c.r, c.g, c.b});
  return list;
}

void write_text(const std::string& text, const fs::path& path, const std::string& what, Call& call) {
  if (path.empty() || path == "-") {
    call.console.answer(std::string_view(text).substr(0, text.size() - 1));  // without the line's own end
    return;
  }
  write_file(path, text);
  call.console.wrote(path, text.size(), what);
}

void write_coefficients(const ShFile& file, const fs::path& path, Call& call) {
  const int bands = file.coefficients.bands();
  call.console.field("bands", bands);
  call.console.field("quantity", name_of(file.quantity));
  call.console.field("coefficients", coefficients_json(file.coefficients.values()));
  write_text(sh_json_text(file), path, fmt::format("{} bands of {}", bands, name_of(file.quantity)), call);
}

void add_text_output(CLI::App& verb, fs::path& path) {
  verb.add_option("-o,--output", path, "file to write; standard output for - or if not said")->group("Output");
}

}  // namespace zonal
