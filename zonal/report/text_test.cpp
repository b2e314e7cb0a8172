#include "zonal/report/text.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

#include "zonal/io/utf8.h"

namespace zonal {
namespace {

constexpr const char* kReplacement = "\xEF\xBF\xBD";

TEST(Escape, NoByteStringLeavesItsPlace) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> byte(0, 255), length(0, 40);
  int compared = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string name(static_cast<std::size_t>(length(random)), ' ');
    for (char& c : name) c = static_cast<char>(byte(random));
    const std::string safe = escape(name);
    ASSERT_EQ(safe.find_first_of("<>\"'"), std::string::npos) << i;
    ASSERT_TRUE(is_utf8(safe)) << i;
    ASSERT_EQ(safe.find('\0'), std::string::npos) << i;
    ++compared;
  }
  EXPECT_EQ(compared, 20000);
}

TEST(Escape, WritesEntities) {
  EXPECT_EQ(escape("<script>alert('x' & \"y\")</script>"),
            "&lt;script&gt;alert(&#39;x&#39; &amp; &quot;y&quot;)&lt;/script&gt;");
  EXPECT_EQ(escape("Zürich 夜景 🌇.exr"), "Zürich 夜景 🌇.exr");
  EXPECT_EQ(escape("two\nlines\tand a tab"), "two\nlines\tand a tab");
}

TEST(Escape, ReplacesControlsAndBrokenSequences) {
  EXPECT_EQ(escape(std::string_view("a\0b", 3)), std::string("a") + kReplacement + "b");
  EXPECT_EQ(escape("a\x7f\x1b"), std::string("a") + kReplacement + kReplacement);
  EXPECT_EQ(escape("\xC2\x85"), kReplacement);                              // C1
  EXPECT_EQ(escape("\xC0\xBC"), std::string(kReplacement) + kReplacement);  // overlong <
  EXPECT_EQ(escape("\xE2\x82"), std::string(kReplacement) + kReplacement);  // cut short
}

TEST(Number, WritesSignificantDigits) {
  const std::array<std::pair<double, const char*>, 14> cases = {{{0.0, "0"},
                                                                 {1.0, "1.00"},
                                                                 {-1.5, "−1.50"},
                                                                 {2048, "2048"},
                                                                 {9.996, "10.0"},
                                                                 {0.0123, "0.0123"},
                                                                 {0.00099996, "0.00100"},
                                                                 {3.2e-5, "3.20×10⁻⁵"},
                                                                 {-3.2e-5, "−3.20×10⁻⁵"},
                                                                 {123456, "123456"},
                                                                 {1234567, "1.23×10⁶"},
                                                                 {1e300, "1.00×10³⁰⁰"},
                                                                 {-HUGE_VAL, "−∞"},
                                                                 {std::nan(""), "not a number"}}};
  for (const auto& [value, words] : cases) EXPECT_EQ(number(value), words);
  EXPECT_THROW(number(1, 0), std::logic_error);
}

/// Back from typographic to a double.
double parsed(std::string text) {
  const std::array<std::pair<std::string, std::string>, 13> ascii = {{{"−", "-"},
                                                                      {"⁻", "-"},
                                                                      {"×10", "e"},
                                                                      {"⁰", "0"},
                                                                      {"¹", "1"},
                                                                      {"²", "2"},
                                                                      {"³", "3"},
                                                                      {"⁴", "4"},
                                                                      {"⁵", "5"},
                                                                      {"⁶", "6"},
                                                                      {"⁷", "7"},
                                                                      {"⁸", "8"},
                                                                      {"⁹", "9"}}};
  for (const auto& [from, to] : ascii) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from))
      text.replace(at, from.size(), to);
  }
  return std::strtod(text.c_str(), nullptr);
}

TEST(Number, IsTheNumberGiven) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> mantissa(-10, 10), exponent(-40, 40);
  int compared = 0;
  for (int i = 0; i < 5000; ++i) {
    const double value = mantissa(random) * std::pow(10, exponent(random));
    for (const int digits : {1, 2, 3, 6, 12}) {
      // Half a unit of the last of `digits` digits, at most 5 units of the digit after the leading one; and its own
      // rounding.
      const double tolerance = std::abs(value) * (0.5 * std::pow(10, 1 - digits) + 1e-15);
      ASSERT_NEAR(parsed(number(value, digits)), value, tolerance) << value << " in " << digits;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 25000);
}

TEST(Number, Units) {
  EXPECT_EQ(percent(0.0123), "1.23 %");
  EXPECT_EQ(byte_count(0), "0 B");
  EXPECT_EQ(byte_count(999), "999 B");
  EXPECT_EQ(byte_count(1500000), "1.50 MB");
  EXPECT_EQ(byte_count(999999), "1.00 MB");
  EXPECT_EQ(byte_count(std::numeric_limits<std::uint64_t>::max()), "1.84×10⁷ TB");
  EXPECT_EQ(duration(0.041), "41.0 ms");
  EXPECT_EQ(duration(0.9996), "1.00 s");
  EXPECT_EQ(power_of_ten(-12), "10⁻¹²");
}

}  // namespace
}  // namespace zonal
