#include <algorithm>
#include <cmath>

#include "zonal/io/hdr.h"
#include "zonal/io/rgbe.h"

namespace zonal {
namespace {

/// The largest value there is.
constexpr float kLargest = 255 * 0x1p119f;  // 119 = 255 - 136

struct Encoded {
  Rgbe pixel;
  bool clipped;
};

Encoded encode(Rgb value) {
  bool clipped = false;
  const auto in_range = [&](float v) {
    if (v >= 0 && v <= kLargest) return v;
    clipped = true;
    return v > 0 ? kLargest : 0.0f;  // NaN compares false: 0
  };
  const Rgb v(in_range(value.r), in_range(value.g), in_range(value.b));
  const float largest = max_channel(v);
  int exponent = 0;
  // largest = [1/2, 1) * 2^exponent, so that its mantissa is 128..255, or 256 when rounded up.
  std::frexp(largest, &exponent);
  if (std::lround(std::ldexp(largest, 8 - exponent)) == 256) ++exponent;
  if (largest == 0 || exponent + 128 < 1) return {{0, 0, 0, 0}, clipped};
  const auto byte = [&](float c) { return static_cast<std::uint8_t>(std::lround(std::ldexp(c, 8 - exponent))); };
  return {{byte(v.r), byte(v.g), byte(v.b), static_cast<std::uint8_t>(exponent + 128)}, clipped};
}

/// Runs shorter than this cost more than literals.
constexpr std::size_t kShortestRun = 4;

void append_runs(const std::vector<std::uint8_t>& bytes, std::vector<std::uint8_t>& out) {
  const auto run_length = [&](std::size_t at) {
    std::size_t end = at + 1;
    while (end < bytes.size() && end - at < 127 && bytes[end] == bytes[at]) ++end;
    return end - at;
  };
  for (std::size_t x = 0; x < bytes.size();) {
    const std::size_t run = run_length(x);
    if (run >= kShortestRun) {
      out.push_back(static_cast<std::uint8_t>(128 + run));
      out.push_back(bytes[x]);
      x += run;
      continue;
    }
    std::size_t end = x + run;
    while (end < bytes.size() && end - x < 128 && run_length(end) < kShortestRun) ++end;
    out.push_back(static_cast<std::uint8_t>(end - x));
    out.insert(out.end(), bytes.begin() + static_cast<std::ptrdiff_t>(x),
               bytes.begin() + static_cast<std::ptrdiff_t>(end));
    x = end;
  }
}

void append_row(const std::vector<Rgbe>& row, std::vector<std::uint8_t>& out) {
  const int width = static_cast<int>(row.size());
  if (width < kMinRunWidth || width > kMaxRunWidth) {
    for (const Rgbe& pixel : row) out.insert(out.end(), pixel.begin(), pixel.end());
    return;
  }
  out.insert(out.end(), {2, 2, static_cast<std::uint8_t>(width >> 8), static_cast<std::uint8_t>(width & 255)});
  std::vector<std::uint8_t> bytes(row.size());
  for (std::size_t component = 0; component < 4; ++component) {
    for (std::size_t x = 0; x < row.size(); ++x) bytes[x] = row[x][component];
    append_runs(bytes, out);
  }
}

}  // namespace

SaveReport write_hdr(const Image<Rgb>& image, OutputFile& file, const SaveOptions&) {
  const std::string header = "#?RADIANCE\nSOFTWARE=zonal\nFORMAT=32-bit_rle_rgbe\n\n-Y " +
                             std::to_string(image.height()) + " +X " + std::to_string(image.width()) + "\n";
  file.write(std::as_bytes(std::span(header)));
  SaveReport report;
  std::vector<Rgbe> row(static_cast<std::size_t>(image.width()));
  std::vector<std::uint8_t> bytes;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const Encoded encoded = encode(image(x, y));
      row[static_cast<std::size_t>(x)] = encoded.pixel;
      report.clipped_pixels += encoded.clipped;
    }
    bytes.clear();
    append_row(row, bytes);
    file.write(std::as_bytes(std::span(bytes)));
  }
  return report;
}

}  // namespace zonal
