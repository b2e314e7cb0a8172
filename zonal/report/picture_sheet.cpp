#include "zonal/report/picture_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

#include "zonal/base/check.h"
#include "zonal/report/png_uri.h"
#include "zonal/report/svg.h"

namespace zonal {
namespace {

// User units. All sheets are as wide as a page's column, so that their letters have one size.
constexpr double kWidth = 640, kGap = 12, kLargestCell = 151, kFontSize = 11.5;
constexpr double kLine = 15, kUnderPicture = 13, kBetweenRows = 14, kMarkRadius = 5;

int lines_of(std::string_view words) {
  return words.empty() ? 0 : 1 + static_cast<int>(std::ranges::count(words, '\n'));
}

std::string label_under(double x, double y, std::string_view words) {
  std::string out;
  for (; !words.empty(); y += kLine) {
    const std::size_t end = std::min(words.find('\n'), words.size());
    out += svg_text(x, y, "middle", words.substr(0, end));
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return out;
}

std::string drawn_cell(const SheetCell& cell, const std::string& clip, double x, double y, double size) {
  if (cell.picture.empty()) return {};
  const std::string cut = cell.round ? fmt::format(R"x( clip-path="url(#{})")x", clip) : "";
  std::string out = fmt::format(R"(<image x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}"{} href="{}"/>)", x, y,
                                size, size, cut, png_data_uri(cell.picture));
  if (cell.round) {
    // A thin rim, so that a white ball shows on white and a black one on black.
    out += fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}" fill="none" stroke="currentColor" )"
                       R"(stroke-opacity="0.2" stroke-width="0.7"/>)",
                       x + size / 2, y + size / 2, size / 2);
  }
  for (const SheetMark& mark : cell.marks) {
    for (const auto& [color, stroke] : {std::pair{"#000", 3.2}, std::pair{"#fff", 1.4}}) {
      out += fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{}" fill="none" stroke="{}" stroke-width="{}"/>)",
                         x + mark.x * size, y + mark.y * size, kMarkRadius, color, stroke);
    }
  }
  return out;
}

}  // namespace

std::string picture_sheet(const PictureSheet& sheet) {
  const auto fits = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-'; };
  check(!sheet.name.empty() && std::ranges::all_of(sheet.name, fits), "a sheet's name has letters, digits and hyphens");
  std::size_t columns = sheet.columns.size();
  for (const SheetRow& row : sheet.rows) columns = std::max(columns, row.cells.size());
  check(!sheet.rows.empty() && columns >= 1 && columns <= 7, "a sheet has rows of one to seven pictures");

  const double count = static_cast<double>(columns);
  const double size = std::min(kLargestCell, (kWidth - kGap * (count - 1)) / count);
  const auto left = [&](std::size_t column) { return static_cast<double>(column) * (size + kGap); };
  const std::string clip = sheet.name + "-disc";
  double y = 2;
  std::string inside;
  if (!sheet.columns.empty()) {
    for (std::size_t i = 0; i < sheet.columns.size(); ++i) {
      inside += svg_text(left(i) + size / 2, y + 11, "middle", sheet.columns[i]);
    }
    y += kLine + 4;
  }
  for (const SheetRow& row : sheet.rows) {
    if (!row.heading.empty()) {
      inside += fmt::format(R"(<g font-weight="600">{}</g>)", svg_text(0, y + 11, "start", row.heading));
      y += kLine + 4;
    }
    int lines = 0;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const SheetCell& cell = row.cells[i];
      inside += drawn_cell(cell, clip, left(i), y, size);
      inside += label_under(left(i) + size / 2, y + size + kUnderPicture, cell.label);
      lines = std::max(lines, lines_of(cell.label));
    }
    y += size + (lines > 0 ? kUnderPicture - 11 + kLine * lines : 0) + kBetweenRows;
  }
  y -= kBetweenRows - 2;
  const std::string disc = fmt::format(
      R"(<clipPath id="{}" clipPathUnits="objectBoundingBox"><circle cx="0.5" cy="0.5" r="0.5"/></clipPath>)", clip);
  return svg_frame(kWidth, std::ceil(y), "sheet", sheet.description,
                   fmt::format(R"({}<g font-size="{}">{}</g>)", disc, kFontSize, inside));
}

}  // namespace zonal
