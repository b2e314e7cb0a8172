#include "apps/zonal/numbers.h"

#include <charconv>
#include <cmath>

#include "zonal/base/error.h"

namespace zonal {
namespace {

std::string count_in_words(std::size_t least, std::size_t most) {
  if (least == most) return std::to_string(least);
  return std::to_string(least) + " to " + std::to_string(most);
}

}  // namespace

std::vector<double> numbers_in(std::string_view text, std::size_t least, std::size_t most, std::string_view option) {
  const auto wrong = [&] {
    return Error(ErrorKind::kUsage, std::string(option) + ": '" + std::string(text) + "' is not a list of numbers",
                 "give " + count_in_words(least, most) + " with commas between them and no spaces");
  };
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  while (true) {
    double value = 0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !std::isfinite(value)) throw wrong();
    numbers.push_back(value);
    if (next == end) break;
    if (*next != ',') throw wrong();
    at = next + 1;
  }
  if (numbers.size() < least || numbers.size() > most) throw wrong();
  return numbers;
}

Rgb color_in(std::string_view text, std::string_view option) {
  const std::vector<double> v = numbers_in(text, 1, 3, option);
  if (v.size() == 2)
    throw Error(ErrorKind::kUsage, std::string(option) + ": a colour has one number or three", "as in 0.2,0.3,0.4");
  const RgbD color = v.size() == 1 ? RgbD{v[0], v[0], v[0]} : RgbD{v[0], v[1], v[2]};
  return static_cast<Rgb>(color);
}

}  // namespace zonal
