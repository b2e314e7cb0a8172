#include "zonal/io/hdr_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace zonal {
namespace {

/// Far above any real header, far below what would hurt.
constexpr std::size_t kMaxHeaderBytes = 1 << 20;

/// One line without its end; carriage returns of careless programs are dropped.
std::string read_line(ByteReader& reader) {
  std::string line;
  for (char c = static_cast<char>(reader.byte()); c != '\n'; c = static_cast<char>(reader.byte())) {
    if (reader.position() > kMaxHeaderBytes) reader.fail("broken Radiance HDR: the header does not end");
    line += c;
  }
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// `count` numbers from the text after a keyword; nothing when they are not there.
std::vector<double> numbers_in(std::string_view text, std::size_t count) {
  std::vector<double> numbers(count);
  const char *next = text.data(), *const end = next + text.size();
  for (double& number : numbers) {
    next = std::find_if_not(next, end, is_blank);
    if (next != end && *next == '+') ++next;  // from_chars() takes no plus
    const auto [rest, error] = std::from_chars(next, end, number);
    if (error != std::errc()) return {};
    next = rest;
  }
  return numbers;
}

/// The first words of a line; "" for those that it does not have.
template <std::size_t N>
std::array<std::string_view, N> words_of(std::string_view line) {
  std::array<std::string_view, N> words;
  for (std::string_view& word : words) {
    line.remove_prefix(std::find_if_not(line.begin(), line.end(), is_blank) - line.begin());
    word = line.substr(0, std::find_if(line.begin(), line.end(), is_blank) - line.begin());
    line.remove_prefix(word.size());
  }
  return words;
}

/// Multiplies a factor of the header into the total. A zero is written by programs that mean "none".
void apply_factor(const std::string& line, const std::vector<double>& factor, HdrHeader& header) {
  const auto usable = [](double f) { return std::isfinite(f) && f > 0; };
  if (!factor.empty()) {
    const RgbD total = header.exposure * RgbD(factor[0], factor[factor.size() / 2], factor.back());
    if (usable(total.r) && usable(total.g) && usable(total.b)) {
      header.exposure = total;
      if (factor[0] != 1 || factor.back() != 1) header.notes.push_back("values are divided by the header's " + line);
      return;
    }
  }
  header.notes.push_back("the header line \"" + line + "\" makes no sense and is ignored");
}

void read_primaries(const std::string& line, const std::vector<double>& values, HdrHeader& header) {
  constexpr std::array<double, 8> kRec709 = {0.640, 0.330, 0.300, 0.600, 0.150, 0.060, 0.3127, 0.3290};
  // Radiance's own default primaries and white (color.h of Radiance).
  constexpr std::array<double, 8> kRadiance = {0.640, 0.330, 0.290, 0.600, 0.150, 0.060, 1.0 / 3, 1.0 / 3};
  const auto close_to = [&](const std::array<double, 8>& known) {
    return std::equal(values.begin(), values.end(), known.begin(), known.end(),
                      [](double a, double b) { return std::abs(a - b) < 0.002; });
  };
  const bool all_zero = std::all_of(values.begin(), values.end(), [](double v) { return v == 0; });
  if (values.empty() || all_zero || close_to(kRec709) || close_to(kRadiance)) return;
  header.notes.push_back("the header line \"" + line + "\" is ignored: colours are taken as Rec. 709");
}

void read_variable(ByteReader& reader, const std::string& line, HdrHeader& header) {
  const std::size_t equals = line.find('=');
  if (line.empty() || line[0] == '#' || equals == std::string::npos) return;
  const std::string name = line.substr(0, equals), value = line.substr(equals + 1);
  if (name == "FORMAT") {
    if (value.find("32-bit_rle_rgbe") != std::string::npos) return;
    if (value.find("32-bit_rle_xyze") != std::string::npos) {
      reader.fail("this Radiance HDR holds XYZ, not RGB", "convert it with Radiance's ra_xyze -r");
    }
    reader.fail("this Radiance HDR has pixels of an unknown format: " + value, "only 32-bit_rle_rgbe is read");
  } else if (name == "EXPOSURE") {
    apply_factor(line, numbers_in(value, 1), header);
  } else if (name == "COLORCORR") {
    apply_factor(line, numbers_in(value, 3), header);
  } else if (name == "PRIMARIES") {
    read_primaries(line, numbers_in(value, 8), header);
  } else if (name == "PIXASPECT") {
    const std::vector<double> aspect = numbers_in(value, 1);
    if (!aspect.empty() && aspect[0] != 1) header.notes.push_back("the header line \"" + line + "\" is ignored");
  }
}

/// One "+X 1024" of the resolution line.
struct Axis {
  bool positive = false;
  char name = 0;
  int size = 0;
};

std::optional<Axis> parse_axis(std::string_view direction, std::string_view digits) {
  if (direction.size() != 2 || (direction[0] != '+' && direction[0] != '-')) return std::nullopt;
  if (direction[1] != 'X' && direction[1] != 'Y') return std::nullopt;
  Axis axis{direction[0] == '+', direction[1], 0};
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), axis.size);
  if (error != std::errc() || end != digits.data() + digits.size() || axis.size <= 0) return std::nullopt;
  return axis;
}

void read_resolution(ByteReader& reader, const std::string& line, HdrHeader& header) {
  const auto word = words_of<4>(line);
  const std::optional<Axis> slow = parse_axis(word[0], word[1]), fast = parse_axis(word[2], word[3]);
  if (!slow || !fast || slow->name == fast->name) {
    reader.fail("broken Radiance HDR: no resolution line such as \"-Y 512 +X 1024\"");
  }
  header.rows_are_columns = slow->name == 'X';
  const Axis& x = header.rows_are_columns ? *slow : *fast;
  const Axis& y = header.rows_are_columns ? *fast : *slow;
  header.width = x.size;
  header.height = y.size;
  header.x_reversed = !x.positive;
  header.y_reversed = y.positive;
}

}  // namespace

HdrHeader read_hdr_header(ByteReader& reader) {
  HdrHeader header;
  read_line(reader);  // "#?RADIANCE" or another program's name
  for (std::string line = read_line(reader); !line.empty(); line = read_line(reader)) {
    read_variable(reader, line, header);
  }
  read_resolution(reader, read_line(reader), header);
  return header;
}

}  // namespace zonal
