#include "zonal/report/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "zonal/base/check.h"
#include "zonal/report/style.h"
#include "zonal/report/text.h"

namespace zonal {
namespace {

bool is_id(std::string_view id) {
  const auto allowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
  return !id.empty() && std::all_of(id.begin(), id.end(), allowed);
}

/// ` class="..."`, or nothing.
std::string class_attribute(std::string_view css_class) {
  return css_class.empty() ? std::string() : fmt::format(R"( class="{}")", escape(css_class));
}

}  // namespace

std::string html_page(const HtmlPage& page) {
  std::string contents, body;
  std::set<std::string> ids;
  for (const HtmlSection& section : page.sections) {
    check(is_id(section.id), "a section's id must be letters, digits and hyphens");
    check(ids.insert(section.id).second, "a section's id must be unique");
    const std::string heading = escape(section.heading);
    contents += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", section.id, heading);
    body += fmt::format(
        "<section id=\"{0}\" aria-labelledby=\"{0}-h\">\n<h2 id=\"{0}-h\">{1}</h2>\n<div>\n{2}</div>\n</section>\n",
        section.id, heading, section.html);
  }
  // <bdi>: a name with right-to-left marks must not turn the words around it.
  return fmt::format(R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="referrer" content="no-referrer">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'{7}">
<link rel="icon" href="data:,">
<title>{0}</title>
<style>{1}{8}</style>
</head>
<body>
<header>
<h1><bdi>{0}</bdi></h1>
<p class="subtitle">{2}</p>
</header>
<nav aria-label="Contents">
<ul>
{3}</ul>
</nav>
<main>
{4}{5}</main>
{6}</body>
</html>
)",
                     escape(page.title), page_style(), escape(page.subtitle), contents, page.lead_html, body,
                     page.footer.empty() ? "" : fmt::format("<footer>{}</footer>\n", escape(page.footer)),
                     page.has_scripts ? "; script-src 'unsafe-inline'" : "", page.style);
}

std::string html_table(const HtmlTable& table) {
  const auto kind = [&](std::size_t column) { return table.columns[column].numeric ? R"( class="n")" : ""; };
  // A narrow screen sets the cells of a wide table below each other, each with its column's name.
  const bool wide = table.columns.size() > 4;
  std::string out = fmt::format("<table{}>\n<caption>{}</caption>\n<thead><tr>", class_attribute(wide ? "stacks" : ""),
                                escape(table.caption));
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    out += fmt::format(R"(<th scope="col"{}>{}</th>)", kind(c), escape(table.columns[c].name));
  }
  out += "</tr></thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : table.rows) {
    check(row.size() == table.columns.size(), "a table's row must have a cell for each column");
    out += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string_view open = c == 0 ? R"(<th scope="row")" : "<td", close = c == 0 ? "</th>" : "</td>";
      const std::string label = wide && c > 0 ? fmt::format(R"( data-label="{}")", escape(table.columns[c].name)) : "";
      out += fmt::format("{}{}{}><bdi>{}</bdi>{}", open, kind(c), label, escape(row[c]), close);
    }
    out += "</tr>\n";
  }
  return out + "</tbody>\n</table>\n";
}

std::string html_facts(const std::vector<Fact>& facts) {
  std::string out = "<dl>\n";
  for (const auto& [name, value] : facts) {
    out += fmt::format("<div><dt>{}</dt><dd><bdi>{}</bdi></dd></div>\n", escape(name), escape(value));
  }
  return out + "</dl>\n";
}

std::string html_picture(const HtmlPicture& picture) {
  return fmt::format(R"(<img{} src="{}" width="{}" height="{}" alt="{}" decoding="async">)",
                     class_attribute(picture.css_class), escape(picture.uri), picture.width, picture.height,
                     escape(picture.alt));
}

std::string html_figure(std::string_view html, std::string_view caption_html, std::string_view css_class) {
  const std::string caption =
      caption_html.empty() ? std::string() : fmt::format("<figcaption>{}</figcaption>\n", caption_html);
  return fmt::format("<figure{}>\n{}\n{}</figure>\n", class_attribute(css_class), html, caption);
}

std::string html_paragraph(std::string_view text, std::string_view css_class) {
  return fmt::format("<p{}>{}</p>\n", class_attribute(css_class), escape(text));
}

std::string html_heading(std::string_view text) { return fmt::format("<h3>{}</h3>\n", escape(text)); }

std::string html_details(std::string_view summary, std::string_view html) {
  return fmt::format("<details>\n<summary>{}</summary>\n{}</details>\n", escape(summary), html);
}

std::string html_code(std::string_view text) { return fmt::format("<pre><code>{}</code></pre>\n", escape(text)); }

}  // namespace zonal
