#include "zonal/report/exposure_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "zonal/base/check.h"
#include "zonal/report/pixel_text.h"

namespace zonal {
namespace {

constexpr Rgb8 kPaper = {246, 245, 242}, kInk = {30, 30, 30};
constexpr int kNarrowest = 200;  // so that a small picture's legend can be read

Rgb8 color_of(std::uint8_t source, std::size_t exposures) {
  if (source == kOnlySaturated) return {255, 255, 255};
  if (source == kOnlyBlack) return {0, 0, 0};
  if (source == kInConflict) return {255, 0, 255};
  if (source == kNoData) return {128, 128, 128};
  // Inside the scale's ends, which black and saturated texels have.
  const double place = exposures > 1 ? static_cast<double>(source) / static_cast<double>(exposures - 1) : 0.5;
  return false_color(0.88 - 0.73 * place);
}

struct Entry {
  Rgb8 color;
  std::string words;
};

std::vector<Entry> entries_of(const Merge& merge, std::span<const std::string> names) {
  std::array<std::int64_t, 256> counts = {};
  for (const std::uint8_t source : merge.source.values()) ++counts[source];
  const auto entry = [&](std::uint8_t source, const std::string& name) {
    const double share = 100 * static_cast<double>(counts[source]) / static_cast<double>(merge.source.size());
    return Entry{color_of(source, names.size()), fmt::format("{} {:.{}f}%", name, share, share < 9.95 ? 1 : 0)};
  };
  std::vector<Entry> entries;
  for (std::size_t k = 0; k < names.size(); ++k) entries.push_back(entry(static_cast<std::uint8_t>(k), names[k]));
  constexpr std::array<std::pair<std::uint8_t, const char*>, 4> kOthers = {
      {{kOnlySaturated, "SATURATED"}, {kOnlyBlack, "BLACK"}, {kInConflict, "CONFLICT"}, {kNoData, "NO DATA"}}};
  for (const auto& [source, name] : kOthers) {
    if (counts[source] > 0) entries.push_back(entry(source, name));
  }
  return entries;
}

void fill(Image<Rgb8>& picture, int left, int top, int width, int height, Rgb8 color) {
  for (int y = top; y < std::min(top + height, picture.height()); ++y) {
    for (int x = left; x < std::min(left + width, picture.width()); ++x) picture(x, y) = color;
  }
}

/// Swatches with words in columns of one width.
Image<Rgb8> legend(const std::vector<Entry>& entries, int width) {
  const int dot = std::max(1, width / 450), unit = kPixelTextDots * dot;
  int column = 0;
  for (const Entry& entry : entries) column = std::max(column, pixel_text_width(entry.words, dot) + 5 * unit);
  const int columns = std::max(1, (width - unit) / column),
            rows = (static_cast<int>(entries.size()) + columns - 1) / columns;
  const int line = 2 * unit;
  Image<Rgb8> picture(width, rows * line + unit, kPaper);
  for (int i = 0; i < static_cast<int>(entries.size()); ++i) {
    // Down the columns, so that neighbouring exposures stand below each other.
    const int x = unit + i / rows * column, y = unit + i % rows * line;
    fill(picture, x - 1, y - 1, 2 * unit + 2, unit + 2, kInk);
    fill(picture, x, y, 2 * unit, unit, entries[static_cast<std::size_t>(i)].color);
    draw_pixel_text(picture, x + 3 * unit, y, entries[static_cast<std::size_t>(i)].words, dot, kInk);
  }
  return picture;
}

}  // namespace

std::string exposure_words(double seconds) {
  const double rate = 1 / seconds;
  if (seconds < 0.4 && std::abs(rate - std::round(rate)) < 0.02 * rate) return fmt::format("1/{:.0f} s", rate);
  return fmt::format("{:.3g} s", seconds);
}

Image<Rgb8> exposure_map(const Merge& merge, std::span<const std::string> names) {
  check(!merge.source.empty() && !names.empty(), "a map of exposures needs a merge and names");
  const int width = std::max(kNarrowest, merge.source.width());
  const Image<Rgb8> below = legend(entries_of(merge, names), width);
  Image<Rgb8> picture(width, merge.source.height() + below.height(), kPaper);
  for (int y = 0; y < merge.source.height(); ++y) {
    const auto row = merge.source.row(y);
    std::transform(row.begin(), row.end(), picture.row(y).begin(),
                   [&](std::uint8_t source) { return color_of(source, names.size()); });
  }
  for (int y = 0; y < below.height(); ++y) {
    std::copy(below.row(y).begin(), below.row(y).end(), picture.row(merge.source.height() + y).begin());
  }
  return picture;
}

}  // namespace zonal
