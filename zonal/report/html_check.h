#pragma once

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace zonal {

/// What a strict reader finds in a page that we wrote. Only for tests.
struct HtmlCheck {
  std::vector<std::string> problems;  ///< empty for a good page
  std::map<std::string, int> tags;    ///< opened elements by name
  std::set<std::string> ids;
  std::string text;  ///< all words outside of tags and style, entities decoded
};

/// Reads our subset of HTML: every element closed in order (but void ones), attributes in double quotes, entities only
/// as we write them. Also demands unique ids, inner links with a target, an alt text and a size on every picture, a
/// caption in every table, one h1, no skipped heading level, and no address outside the page.
class HtmlReader {
 public:
  static HtmlCheck read(std::string_view html) {
    HtmlReader reader;
    reader.document(html);
    return std::move(reader.check_);
  }

 private:
  using Attributes = std::map<std::string, std::string>;

  void problem(const std::string& words) { check_.problems.push_back(words); }

  void document(std::string_view html) {
    while (!html.empty()) {
      if (html[0] != '<') {
        const std::size_t end = std::min(html.find('<'), html.size());
        check_.text += decoded(html.substr(0, end));
        html.remove_prefix(end);
        continue;
      }
      const std::size_t end = html.find('>');
      if (end == std::string_view::npos) return problem("a tag is not closed");
      tag(html.substr(1, end - 1));
      html.remove_prefix(end + 1);
      for (const std::string raw : {"style", "script"}) {  // their text is no markup
        if (!open_.empty() && open_.back() == raw)
          html.remove_prefix(std::min(html.find("</" + raw + ">"), html.size()));
      }
    }
    for (const std::string& name : open_) problem("<" + name + "> stays open");
    for (const std::string& target : links_) {
      if (!check_.ids.contains(target)) problem("no target #" + target);
    }
    if (check_.tags["h1"] != 1) problem("not exactly one h1");
    if (check_.tags["table"] != check_.tags["caption"]) problem("a table without a caption");
  }

  void tag(std::string_view inside) {
    if (inside == "!DOCTYPE html") return;
    const bool closing = inside.starts_with('/');
    if (closing) inside.remove_prefix(1);
    const bool empty = inside.ends_with('/');
    if (empty) inside.remove_suffix(1);
    const std::string name(take_while(inside, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }));
    if (name.empty()) return problem("a tag without a name");
    if (closing) return close(name);
    ++check_.tags[name];
    attributes(name, inside);
    static const std::set<std::string> kVoid = {"meta", "link", "img", "br"};
    if (kVoid.contains(name) || empty) return;
    open_.push_back(name);
    heading(name);
  }

  /// The longest beginning whose characters are all wanted, taken away from `text`.
  template <class Wanted>
  static std::string_view take_while(std::string_view& text, Wanted wanted) {
    const auto end = std::find_if_not(text.begin(), text.end(), wanted);
    const std::string_view taken = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(taken.size());
    return taken;
  }

  void close(const std::string& name) {
    if (open_.empty() || open_.back() != name) return problem("</" + name + "> closes nothing");
    open_.pop_back();
  }

  void heading(const std::string& name) {
    if (name.size() != 2 || name[0] != 'h' || name[1] < '1' || name[1] > '6') return;
    const int level = name[1] - '0';
    if (level > heading_ + 1) problem("heading level skipped before " + name);
    heading_ = level;
  }

  /// name="value" each, with blanks before it.
  Attributes parsed(const std::string& tag_name, std::string_view list) {
    Attributes all;
    while (!list.empty()) {
      const std::string_view blanks = take_while(list, [](char c) { return c == ' '; });
      if (list.empty()) break;
      const std::string_view key = take_while(list, [](char c) { return c != '=' && c != ' ' && c != '"'; });
      const std::size_t end = list.starts_with("=\"") ? list.find('"', 2) : std::string_view::npos;
      if (blanks.empty() || key.empty() || end == std::string_view::npos) {
        problem("not an attribute of ours in <" + tag_name + ">");
        break;
      }
      if (!all.emplace(key, decoded(list.substr(2, end - 2))).second) problem("attribute twice in <" + tag_name + ">");
      list.remove_prefix(end + 1);
    }
    return all;
  }

  void attributes(const std::string& name, std::string_view list) {
    Attributes all = parsed(name, list);
    if (all.contains("id") && !check_.ids.insert(all["id"]).second) problem("id twice: " + all["id"]);
    for (const char* key : {"src", "href"}) {
      if (!all.contains(key)) continue;
      const std::string& address = all[key];
      if (address.starts_with("#"))
        links_.insert(address.substr(1));
      else if (!address.starts_with("data:"))
        problem("an address outside the page: " + address);
    }
    if (name == "img" && !(all.contains("alt") && all.contains("width") && all.contains("height"))) {
      problem("a picture without alt or size");
    }
    if (name == "svg" && !all.contains("aria-label") && !all.contains("aria-hidden")) problem("an svg without words");
  }

  std::string decoded(std::string_view text) {
    static const std::map<std::string, std::string, std::less<>> kEntities = {
        {"&amp;", "&"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}};
    std::string out;
    while (!text.empty()) {
      std::size_t length = 1;
      if (text[0] == '>') problem("a bare >");
      if (text[0] == '&') {
        length = std::min(text.find(';') + 1, text.size());
        const auto entity = kEntities.find(text.substr(0, length));
        if (length == 0 || entity == kEntities.end())
          problem("an entity that is none of ours");
        else
          out += entity->second;
        length = std::max<std::size_t>(length, 1);
      } else {
        out += text[0];
      }
      text.remove_prefix(length);
    }
    return out;
  }

  HtmlCheck check_;
  std::vector<std::string> open_;
  std::set<std::string> links_;
  int heading_ = 0;
};

}  // namespace zonal
