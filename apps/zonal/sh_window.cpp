#include "apps/zonal/sh_window.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "apps/zonal/choices.h"
#include "apps/zonal/numbers.h"
#include "zonal/base/error.h"
#include "zonal/report/text.h"
#include "zonal/sh/minimum.h"
#include "zonal/sh/nonnegative.h"

namespace zonal {
namespace {

/// Finding the least value takes longer with the cube of the bands: a second here.
constexpr int kMaxMinimumBands = 10;
/// And the weakest window that leaves nothing negative, half a minute here.
constexpr int kMaxNonNegativeBands = 64;
constexpr double kDefaultFraction = 0.5;
constexpr std::array kChannels = {&RgbD::r, &RgbD::g, &RgbD::b};

using Maker = std::function<Window(const Sh<RgbD>&)>;

Error unknown(const WindowOptions& options) {
  return Error(ErrorKind::kUsage, "--window: '" + options.window + "' is no window",
               "say hann[:WIDTH], lanczos[:WIDTH[:POWER]], laplacian[:FRACTION], laplacian-weight:WEIGHT or "
               "nonnegative[:FAMILY]");
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c == ':') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

Maker nonnegative_maker(const std::string& family) {
  NonNegativeOptions search;
  if (family == "hann") {
    search.family = WindowKind::kHann;
  } else if (family == "lanczos") {
    search.family = WindowKind::kLanczos;
  } else if (family == "laplacian") {
    search.family = WindowKind::kLaplacian;
  } else {
    throw Error(ErrorKind::kUsage, "--window: nonnegative has no family '" + family + "'",
                "say nonnegative:hann, nonnegative:lanczos or nonnegative:laplacian");
  }
  return [search](const Sh<RgbD>& sh) {
    if (sh.bands() > kMaxNonNegativeBands) {
      throw Error(ErrorKind::kUsage, fmt::format("--window nonnegative takes {} bands at most", kMaxNonNegativeBands),
                  "--bands leaves out the rest");
    }
    return nonnegative_window(sh, search).window;
  };
}

/// How to make the window for a function.
Maker maker_of(const WindowOptions& options) {
  const std::vector<std::string> words = words_of(options.window);
  const std::string& name = words[0];
  const auto takes = [&](std::size_t least, std::size_t most) {
    if (words.size() - 1 < least || words.size() - 1 > most) throw unknown(options);
  };
  std::vector<double> amounts;
  if (name != "nonnegative") {
    for (std::size_t i = 1; i < words.size(); ++i) amounts.push_back(numbers_in(words[i], 1, 1, "--window")[0]);
  }
  if (options.channels && name != "laplacian") {
    throw Error(ErrorKind::kUsage, "--channels: only the window laplacian:FRACTION can differ between channels",
                "leave it out");
  }
  // A width that is not said is the number of bands: the last one is used, the next would be zero.
  const auto width = [amounts](const Sh<RgbD>& sh) { return amounts.empty() ? sh.bands() : amounts[0]; };
  if (name == "hann") {
    takes(0, 1);
    return [width](const Sh<RgbD>& sh) { return Window::hann(width(sh)); };
  }
  if (name == "lanczos") {
    takes(0, 2);
    const double power = amounts.size() > 1 ? amounts[1] : 1;
    return [width, power](const Sh<RgbD>& sh) { return Window::lanczos(width(sh), power); };
  }
  if (name == "laplacian") {
    takes(0, 1);
    const double fraction = amounts.empty() ? kDefaultFraction : amounts[0];
    const WindowChannels channels = options.channels.value_or(WindowChannels::kJoint);
    return [=](const Sh<RgbD>&) { return Window::laplacian_fraction(fraction, channels); };
  }
  if (name == "laplacian-weight") {
    takes(1, 1);
    return [amounts](const Sh<RgbD>&) { return Window::laplacian(amounts[0]); };
  }
  if (name == "nonnegative") {
    takes(0, 1);
    return nonnegative_maker(words.size() > 1 ? words[1] : "hann");
  }
  throw unknown(options);
}

/// The windows that look at the function, as what they come to: one for all channels, or one for each.
std::vector<Window> settled(const Window& window, const Sh<RgbD>& sh) {
  if (window.kind() != WindowKind::kLaplacianFraction) return {window};
  const std::vector<RgbD> energies = band_energies(sh);
  std::vector<std::vector<double>> spectra;
  if (window.channels() == WindowChannels::kJoint) {
    for (const RgbD& e : energies) spectra.resize(1), spectra[0].push_back(e.r + e.g + e.b);
  } else {
    for (const auto channel : kChannels) {
      std::vector<double>& one = spectra.emplace_back();
      for (const RgbD& e : energies) one.push_back(e.*channel);
    }
  }
  std::vector<Window> windows;
  for (const auto& spectrum : spectra) {
    windows.push_back(Window::laplacian(laplacian_weight(spectrum, window.amount())));
  }
  return windows;
}

/// The least value of all channels.
Minimum least_value(const Sh<RgbD>& sh) {
  double square = 0;
  for (const RgbD& c : sh.values()) square += c.r * c.r + c.g * c.g + c.b * c.b;
  if (square == 0) return {};
  Minimum least;
  least.found = least.guaranteed = std::numeric_limits<double>::infinity();
  Sh<double> one(sh.bands());
  for (const auto channel : kChannels) {
    for (std::size_t i = 0; i < sh.size(); ++i) one[i] = sh[i].*channel;
    // To a hundred-thousandth of the function's size.
    const Minimum minimum = certified_minimum(one, {.tolerance = 1e-5 * std::sqrt(square / (4 * kPi))});
    least.found = std::min(least.found, minimum.found);
    least.guaranteed = std::min(least.guaranteed, minimum.guaranteed);
  }
  return least;
}

std::string_view name_of(WindowKind kind) {
  constexpr std::string_view kNames[] = {"none", "hann", "lanczos", "laplacian-weight", "laplacian"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string weights_in_words(const std::vector<Window>& windows) {
  std::vector<std::string> weights;
  for (const Window& w : windows) weights.push_back(fmt::format("{:.6g}", w.amount()));
  return fmt::format("{} {}", weights.size() > 1 ? "weights" : "weight", fmt::join(weights, " "));
}

std::string in_words(const Window& window, const std::vector<Window>& settled_windows) {
  switch (window.kind()) {
    case WindowKind::kNone:
      return "no window is needed";
    case WindowKind::kHann:
      return fmt::format("Hann window, {:.6g} bands wide", window.amount());
    case WindowKind::kLanczos:
      return fmt::format("Lanczos window, {:.6g} bands wide, power {:.6g}", window.amount(), window.power());
    case WindowKind::kLaplacian:
      return "Laplacian window, " + weights_in_words(settled_windows);
    case WindowKind::kLaplacianFraction:
      break;
  }
  return fmt::format("Laplacian window, squared Laplacian reduced to {}, {}", percent(window.amount()),
                     weights_in_words(settled_windows));
}

JsonValue window_json(const Window& window, const std::vector<Window>& settled_windows, int bands) {
  JsonValue::Object object{{"kind", name_of(window.kind())}};
  if (window.kind() == WindowKind::kHann || window.kind() == WindowKind::kLanczos) {
    object.emplace_back("width_bands", window.amount());
  }
  if (window.kind() == WindowKind::kLanczos) object.emplace_back("power", window.power());
  JsonValue::Array weights, factors;
  for (const Window& w : settled_windows) {
    if (w.kind() == WindowKind::kLaplacian) weights.emplace_back(w.amount());
    JsonValue::Array list;
    for (const double factor : window_factors(w, bands)) list.emplace_back(factor);
    factors.emplace_back(std::move(list));
  }
  if (window.kind() == WindowKind::kLaplacianFraction) object.emplace_back("fraction", window.amount());
  if (!weights.empty()) object.emplace_back("weights", std::move(weights));
  object.emplace_back("factors", std::move(factors));
  return object;
}

}  // namespace

void add_window_options(CLI::App& verb, WindowOptions& options) {
  constexpr const char* kGroup = "Window";
  verb.add_option("--window", options.window,
                  "take out ringing: hann[:WIDTH] and lanczos[:WIDTH[:POWER]], WIDTH in bands, all of them if not "
                  "said; laplacian[:FRACTION], which reduces the squared Laplacian to that part of it, 0.5 if not "
                  "said; laplacian-weight:WEIGHT; nonnegative[:hann|lanczos|laplacian], the weakest of that family "
                  "that leaves nothing negative. It acts on the --quantity")
      ->group(kGroup);
  add_choice(
      verb, "--channels", options.channels,
      [](std::string_view name) -> std::optional<WindowChannels> {
        if (name == "joint") return WindowChannels::kJoint;
        if (name == "each") return WindowChannels::kEach;
        return std::nullopt;
      },
      "joint or each", "laplacian:FRACTION: one weight for all channels, or one for each")
      ->group(kGroup);
}

void check_window(const WindowOptions& options) {
  if (options.window.empty()) {
    if (options.channels) throw Error(ErrorKind::kUsage, "--channels says how a --window acts", "say which window");
    return;
  }
  const Maker make = maker_of(options);
  Sh<RgbD> white(1);
  white[0] = {1, 1, 1};
  make(white);  // for a width, power, fraction or weight outside its domain
}

Sh<RgbD> windowed(const Sh<RgbD>& sh, const WindowOptions& options, Call& call) {
  if (options.window.empty()) return sh;
  const Window chosen = maker_of(options)(sh);
  const std::vector<Window> windows = settled(chosen, sh);
  Sh<RgbD> result = window(sh, chosen);
  call.console.note(in_words(chosen, windows));
  call.console.field("window", window_json(chosen, windows, sh.bands()));
  if (sh.bands() > kMaxMinimumBands) return result;
  const Minimum before = least_value(sh), after = least_value(result);
  call.console.note(fmt::format("least value {:.6g}; it was {:.6g}. Nowhere below {:.6g}", after.found, before.found,
                                after.guaranteed));
  call.console.field("minimum", JsonValue::Object{{"before", before.found},
                                                  {"after", after.found},
                                                  {"guaranteed_before", before.guaranteed},
                                                  {"guaranteed_after", after.guaranteed}});
  return result;
}

}  // namespace zonal
