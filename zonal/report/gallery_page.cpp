#include "zonal/report/gallery_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <span>
#include <string_view>

#include "zonal/base/check.h"
#include "zonal/io/png.h"
#include "zonal/report/gallery_light_figures.h"
#include "zonal/report/html.h"
#include "zonal/report/png_uri.h"
#include "zonal/report/svg.h"
#include "zonal/report/text.h"

namespace zonal {
namespace {

struct PageSize {
  double width = 0, height = 0;
};

/// From the viewBox="0 0 WIDTH HEIGHT" of a drawing.
PageSize size_of_svg(std::string_view svg) {
  constexpr std::string_view kBox = "viewBox=\"0 0 ";
  const std::size_t begin = svg.find(kBox);
  check(begin != std::string_view::npos, "a drawing of the gallery needs a viewBox that starts at 0 0");
  svg.remove_prefix(begin + kBox.size());
  PageSize size;
  const auto [rest, first] = std::from_chars(svg.data(), svg.data() + svg.size(), size.width);
  check(first == std::errc() && rest != svg.data() + svg.size(), "a drawing's viewBox needs four numbers");
  const auto second = std::from_chars(rest + 1, svg.data() + svg.size(), size.height).ec;
  check(second == std::errc() && size.width > 0 && size.height > 0, "a drawing's viewBox needs a size");
  return size;
}

/// Pictures of a row share its width in the proportion of their shapes, and so have one height.
std::string plate(const GalleryPicture& picture) {
  std::string inside;
  double width = 0, height = 0, least = 0;
  if (picture.svg.empty()) {
    const Image<Rgb8> shown = displayed(picture.picture);
    width = static_cast<double>(shown.width()) / picture.scale;
    height = static_cast<double>(shown.height()) / picture.scale;
    least = width;
    inside = html_picture({png_data_uri(shown), static_cast<int>(width), static_cast<int>(height), picture.alt});
  } else {
    const PageSize size = size_of_svg(picture.svg);
    width = 1.15 * size.width;
    height = 1.15 * size.height;
    least = 0.75 * size.width;  // letters can be read down to this size
    inside = picture.svg;
  }
  return fmt::format("<figure style=\"flex: {:.3f} 1 {:.0f}px; max-width: min(100%, {:.0f}px)\">\n{}\n</figure>\n",
                     width / height, least, width, inside);
}

/// Counts as counts.
std::string figures_of(double value, int digits) {
  const bool whole = value == std::round(value) && std::abs(value) < 1e5;
  return whole && value != 0 ? number(value, 1 + static_cast<int>(std::log10(std::abs(value)))) : number(value, digits);
}

std::string numbers_table(const std::vector<PublishedNumber>& numbers) {
  HtmlTable table = {"Numbers of the paper and ours.",
                     {{"number"}, {"printed"}, {"computed here", true}, {"difference", true}, {"allowed", true}},
                     {}};
  for (const PublishedNumber& n : numbers) {
    const std::string printed = n.printed.empty() ? "not printed; expected " + figures_of(n.expected, 6) : n.printed;
    table.rows.push_back({n.what, printed, figures_of(n.ours, 7),
                          number(n.ours - n.expected, 2) + (holds(n) ? "" : " (differs)"), number(n.tolerance, 2)});
  }
  return html_table(table);
}

std::string figure_section(const GalleryFigure& figure) {
  std::string out = "<div class=\"plates\">\n";
  for (const GalleryPicture& picture : figure.pictures) out += plate(picture);
  out += "</div>\n" + html_paragraph(figure.caption) + html_paragraph(figure.source, "quiet");
  return figure.numbers.empty() ? out : out + numbers_table(figure.numbers);
}

std::string file_name(const GalleryPicture& picture) { return picture.name + (picture.svg.empty() ? ".png" : ".svg"); }

std::string readout(const std::vector<GalleryFigure>& figures) {
  std::size_t pictures = 0, numbers = 0, held = 0;
  for (const GalleryFigure& figure : figures) {
    pictures += figure.pictures.size();
    numbers += figure.numbers.size();
    held += static_cast<std::size_t>(std::ranges::count_if(figure.numbers, holds));
  }
  return fmt::format(
      "<dl class=\"readout\">\n<div><dt>figures</dt><dd>{}</dd></div>\n<div><dt>pictures</dt><dd>{}</dd></div>\n"
      "<div><dt>numbers that agree</dt><dd>{} of {}</dd></div>\n</dl>\n",
      figures.size(), pictures, held, numbers);
}

}  // namespace

std::string gallery_page_html(const std::vector<GalleryFigure>& figures, const GalleryOrigin& origin) {
  HtmlPage page = {
      .title = "Spherical harmonics for light, drawn again",
      .subtitle =
          "The figures of “Stupid Spherical Harmonics (SH) Tricks” (Sloan 2008), each computed here, with the "
          "numbers the paper prints and ours beside them. Probe: " +
          origin.probe + ".",
      .lead_html = readout(figures),
      .sections = {},
      .footer = origin.program};
  for (const GalleryFigure& figure : figures)
    page.sections.push_back({figure.id, figure.title, figure_section(figure)});
  return html_page(page);
}

std::vector<GalleryFile> write_gallery(const std::vector<GalleryFigure>& figures, const GalleryOrigin& origin,
                                       OutputFolder& folder) {
  const std::string page = gallery_page_html(figures, origin);
  folder.add("index.html", page);
  std::vector<GalleryFile> files = {{"index.html", "a page with all figures", page.size()}};
  std::set<std::string> names;
  for (const GalleryFigure& figure : figures) {
    for (const GalleryPicture& picture : figure.pictures) {
      const std::string name = file_name(picture);
      check(names.insert(picture.name).second, "two pictures of the gallery have one name");
      if (picture.svg.empty()) {
        const std::vector<std::byte> png = encode_png(displayed(picture.picture));
        folder.add(name, png);
        files.push_back({name, figure.title, png.size()});
      } else {
        const std::string svg = standalone_svg(picture.svg);
        folder.add(name, svg);
        files.push_back({name, figure.title, svg.size()});
      }
    }
  }
  return files;
}

}  // namespace zonal
