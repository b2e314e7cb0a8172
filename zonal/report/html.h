#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace zonal {

// The parts of a self-contained page: no network, no font of its own, no script but what a section brings. Arguments named html are markup and go
// in as they are; all other text is escaped here.

struct HtmlSection {
  std::string id;  ///< letters, digits and hyphens, unique in the page: the target of the contents list
  std::string heading;
  std::string html;
};

struct HtmlPage {
  std::string title;
  std::string subtitle;
  std::string lead_html = {};  ///< between the title and the first section
  std::vector<HtmlSection> sections;
  std::string footer = {};
  std::string style = {};    ///< beside the page's own
  bool has_scripts = false;  ///< a section holds script elements: the page lets them run
};

/// The whole document, with its style and a list of contents. Light or dark as the reader's system asks; readable from
/// a phone to paper.
std::string html_page(const HtmlPage&);

struct HtmlColumn {
  std::string name;
  bool numeric = false;  ///< to the right, digits of equal width
};

struct HtmlTable {
  std::string caption;
  std::vector<HtmlColumn> columns;
  std::vector<std::vector<std::string>> rows;  ///< each as long as `columns`; the first cell names the row
};

/// Columns that find no room wrap their words; the page never scrolls sideways for them.
std::string html_table(const HtmlTable&);

/// Names and values, one under the other.
struct Fact {
  std::string name, value;
};
std::string html_facts(const std::vector<Fact>&);

/// A picture with its natural size in pixels, so that nothing moves while the page is read. `alt` is empty for pictures
/// that only repeat what the text beside them says.
struct HtmlPicture {
  std::string uri;
  int width = 0, height = 0;
  std::string alt;
  std::string css_class = {};
};
std::string html_picture(const HtmlPicture&);

/// Pictures and words that belong together.
std::string html_figure(std::string_view html, std::string_view caption_html, std::string_view css_class = {});

std::string html_paragraph(std::string_view text, std::string_view css_class = {});
std::string html_heading(std::string_view text);  ///< below a section's own
std::string html_details(std::string_view summary,
                         std::string_view html);  ///< folded until asked for, unfolded on paper
std::string html_code(std::string_view text);     ///< long lines wrap

}  // namespace zonal
