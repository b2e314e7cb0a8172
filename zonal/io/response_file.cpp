#include "zonal/io/response_file.h"

#include <charconv>
#include <cmath>
#include <vector>

#include "zonal/base/error.h"
#include "zonal/io/file.h"
#include "zonal/io/json_text.h"

namespace zonal {
namespace {

constexpr std::uint64_t kLargestFile = 1 << 20;

/// Appends the numbers of a line. False when a word is no finite number from 0 up.
bool numbers_of(std::string_view line, std::vector<double>& numbers) {
  while (true) {
    const std::size_t begin = line.find_first_not_of(" \t\r,");
    if (begin == std::string_view::npos) return true;
    line.remove_prefix(begin);
    double value = 0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), value);
    if (error != std::errc() || !std::isfinite(value) || value < 0) return false;
    numbers.push_back(value);
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
  }
}

}  // namespace

std::string response_text(const Response& response) {
  std::string text = "# camera response: exposure (radiance times seconds) for codes 0..255, red green blue\n";
  for (int z = 0; z < kCodes; ++z) {
    text += shortest(response.exposure[0][z]) + ' ' + shortest(response.exposure[1][z]) + ' ' +
            shortest(response.exposure[2][z]) + '\n';
  }
  return text;
}

Response parse_response(const std::string& name, std::string_view text) {
  const auto fail = [&](int line, const std::string& what) {
    throw Error(ErrorKind::kInput, name + ", line " + std::to_string(line) + ": " + what,
                "a response has 256 lines of one or three numbers that do not fall, for codes 0 to 255");
  };
  Response response;
  int code = 0, line_number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    ++line_number;
    line = line.substr(0, line.find('#'));
    std::vector<double> numbers;
    if (!numbers_of(line, numbers)) fail(line_number, std::string(line) + " holds what is no number from 0 up");
    if (numbers.empty()) continue;
    if (numbers.size() != 1 && numbers.size() != 3) fail(line_number, "there are neither one nor three numbers");
    if (code == kCodes) fail(line_number, "there are more than 256 codes");
    for (int c = 0; c < 3; ++c) {
      const double value = numbers[numbers.size() == 3 ? static_cast<std::size_t>(c) : 0];
      if (code > 0 && value < response.exposure[c][code - 1]) fail(line_number, "the curve falls");
      response.exposure[c][code] = value;
    }
    ++code;
  }
  if (code != kCodes) fail(line_number, "there are only " + std::to_string(code) + " codes");
  for (const ResponseCurve& curve : response.exposure) {
    if (!(curve[kCodes - 1] > 0)) fail(line_number, "a channel's curve is zero throughout");
  }
  return response;
}

Response load_response(const std::filesystem::path& path) {
  const std::vector<std::byte> bytes = read_file(path, kLargestFile);
  return parse_response(path.string(), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace zonal
