#include "zonal/io/hdr.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "zonal/io/hdr_header.h"
#include "zonal/io/rgbe.h"

namespace zonal {
namespace {

/// The old code: pixels one by one, where 1, 1, 1, n repeats the last pixel n times; further such pixels in a row count
/// in units of 256, 65536, ... A flat file is one that never says so.
void read_old_row(ByteReader& reader, Rgbe first, std::span<Rgbe> row) {
  int shift = 0;
  Rgbe pixel = first;
  for (std::size_t x = 0; x < row.size();) {
    if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
      if (x == 0) reader.fail("broken Radiance HDR: a row begins with a repetition of nothing");
      const std::uint64_t count = shift < 32 ? std::uint64_t{pixel[3]} << shift : row.size() + 1;
      if (count > row.size() - x) reader.fail("broken Radiance HDR: a run is longer than its row");
      std::fill_n(row.begin() + static_cast<std::ptrdiff_t>(x), count, row[x - 1]);
      x += count;
      shift += 8;
    } else {
      row[x++] = pixel;
      shift = 0;
    }
    if (x < row.size()) reader.read(pixel);
  }
}

/// The new code: the four bytes of all pixels one after the other, each in runs (128 + length, value) and literals
/// (length, values).
void read_new_row(ByteReader& reader, std::span<Rgbe> row) {
  for (std::size_t component = 0; component < 4; ++component) {
    for (std::size_t x = 0; x < row.size();) {
      const int code = reader.byte();
      const std::size_t count = code > 128 ? code - 128 : code;
      if (count == 0) reader.fail("broken Radiance HDR: a run of no length");
      if (count > row.size() - x) reader.fail("broken Radiance HDR: a run is longer than its row");
      if (code > 128) {
        const std::uint8_t value = reader.byte();
        for (const std::size_t end = x + count; x < end; ++x) row[x][component] = value;
      } else {
        for (const std::size_t end = x + count; x < end; ++x) row[x][component] = reader.byte();
      }
    }
  }
}

void read_row(ByteReader& reader, std::span<Rgbe> row) {
  Rgbe start;
  reader.read(start);
  const int width = static_cast<int>(row.size());
  const bool marked = start[0] == 2 && start[1] == 2 && start[2] < 128;
  if (!marked || width < kMinRunWidth || width > kMaxRunWidth) {
    read_old_row(reader, start, row);
    return;
  }
  const bool fits = (start[2] << 8 | start[3]) == width;
  if (!fits) reader.fail("broken Radiance HDR: a row states another width than the header");
  read_new_row(reader, row);
}

/// 2^(e - 136) for each exponent byte, over one channel's exposure; exponent 0 is black whatever the mantissas say.
std::array<double, 256> scale_of_exponent(double exposure) {
  std::array<double, 256> scale = {};
  for (int e = 1; e < 256; ++e) scale[static_cast<std::size_t>(e)] = std::ldexp(1.0, e - 136) / exposure;
  return scale;
}

}  // namespace

std::optional<Picture> load_hdr(ByteReader& reader, const LoadOptions& options, const Run&) {
  const std::vector<std::uint8_t> magic = reader.head(2);
  if (magic != std::vector<std::uint8_t>{'#', '?'}) return std::nullopt;
  HdrHeader header = read_hdr_header(reader);
  check_picture_size(reader, header.width, header.height, options);
  const int rows = header.rows_are_columns ? header.width : header.height;
  const int row_width = header.rows_are_columns ? header.height : header.width;
  // The least a row can take is one old-style pixel.
  if (reader.remaining() < 4 * static_cast<std::uint64_t>(rows)) reader.fail_early_end();

  Picture picture;
  picture.format = "Radiance HDR";
  picture.notes = std::move(header.notes);
  picture.pixels = Image<Rgb>(header.width, header.height);
  const auto red = scale_of_exponent(header.exposure.r), green = scale_of_exponent(header.exposure.g),
             blue = scale_of_exponent(header.exposure.b);
  std::vector<Rgbe> row(static_cast<std::size_t>(row_width));
  for (int j = 0; j < rows; ++j) {
    read_row(reader, row);
    for (int i = 0; i < row_width; ++i) {
      const Rgbe& p = row[static_cast<std::size_t>(i)];
      const int x = header.rows_are_columns ? j : i, y = header.rows_are_columns ? i : j;
      picture.pixels(header.x_reversed ? header.width - 1 - x : x, header.y_reversed ? header.height - 1 - y : y) =
          Rgb(RgbD(p[0] * red[p[3]], p[1] * green[p[3]], p[2] * blue[p[3]]));
    }
  }
  return picture;
}

}  // namespace zonal
