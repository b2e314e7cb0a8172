#include "zonal/report/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "zonal/base/check.h"
#include "zonal/io/utf8.h"

namespace zonal {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

/// True for what HTML allows in no text: C0 controls but tab and line feed, DEL, and C1 controls (U+0080 to U+009F).
bool is_control(std::string_view sequence) {
  const auto first = static_cast<unsigned char>(sequence[0]);
  if (sequence.size() == 1) return (first < 0x20 && first != '\n' && first != '\t') || first == 0x7F;
  return sequence.size() == 2 && first == 0xC2 && static_cast<unsigned char>(sequence[1]) < 0xA0;
}

bool is_plain(char c) { return c >= ' ' && c < 0x7F && c != '&' && c != '<' && c != '>' && c != '"' && c != '\''; }

}  // namespace

std::string escape(std::string_view text) {
  std::string out;
  out.reserve(text.size() + text.size() / 8);
  while (!text.empty()) {
    // Most text, and every embedded picture, is letters, digits and harmless signs.
    const std::size_t plain = std::find_if_not(text.begin(), text.end(), is_plain) - text.begin();
    out += text.substr(0, plain);
    text.remove_prefix(plain);
    if (text.empty()) break;
    const std::size_t length = utf8_character_length(text);
    const std::string_view sequence = text.substr(0, length == 0 ? 1 : length);
    text.remove_prefix(sequence.size());
    if (length == 0 || is_control(sequence)) {
      out += kReplacement;
      continue;
    }
    switch (sequence[0]) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += sequence;
    }
  }
  return out;
}

std::string angle(double radians) {
  const double hundredths = std::round(radians * (180 / std::numbers::pi) * 100);
  return (hundredths < 0 ? "−" : "") + fmt::format("{:.2f}°", std::abs(hundredths) / 100);
}

std::string power_of_ten(int exponent) {
  static constexpr std::array<std::string_view, 10> kRaised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) out += kRaised[static_cast<std::size_t>(digit - '0')];
  return out;
}

std::string number(double value, int digits) {
  check(digits >= 1 && digits <= 17, "digits must be in [1, 17]");
  if (std::isnan(value)) return "not a number";
  if (std::isinf(value)) return value > 0 ? "∞" : "\u2212∞";
  if (value == 0) return "0";
  const char* sign = value < 0 ? "\u2212" : "";
  const double size = std::abs(value);
  // Rounded first: the exponent of 9.996 to three digits is that of 10.0.
  const std::string rounded = fmt::format("{:.{}e}", size, digits - 1);
  const std::size_t e = rounded.find('e');
  const int exponent = std::atoi(rounded.c_str() + e + 1);
  if (exponent >= -3 && exponent <= 5) return fmt::format("{}{:.{}f}", sign, size, std::max(0, digits - 1 - exponent));
  return fmt::format("{}{}×{}", sign, rounded.substr(0, e), power_of_ten(exponent));
}

std::string percent(double fraction, int digits) { return number(100 * fraction, digits) + " %"; }

std::string byte_count(std::uint64_t bytes) {
  static constexpr std::array<const char*, 4> kUnits = {"kB", "MB", "GB", "TB"};
  if (bytes < 1000) return fmt::format("{} B", bytes);
  double value = static_cast<double>(bytes) / 1000;
  std::size_t unit = 0;
  for (; value >= 999.5 && unit + 1 < kUnits.size(); ++unit) value /= 1000;
  return number(value) + " " + kUnits[unit];
}

std::string duration(double seconds) {
  if (std::abs(seconds) >= 0.9995) return number(seconds) + " s";
  return number(1000 * seconds) + " ms";
}

}  // namespace zonal
