#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace zonal {

/// Takes the next word off the front of a text: blanks end words, lines do not matter. Empty at the end.
inline std::string_view next_word(std::string_view& text, std::string_view blanks = " \t\r\n") {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

/// Takes the next line, without its end.
inline std::string_view next_line(std::string_view& text) {
  std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(line.size() + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// The whole word as a number, "nan" and "inf" included; nullopt for anything else.
template <class Number>
std::optional<Number> word_number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

}  // namespace zonal
