#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <half.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "zonal/base/error.h"
#include "zonal/io/exr.h"
#include "zonal/io/exr_stream.h"

namespace zonal {
namespace {

constexpr int kBlockRows = 16;  // the rows in a ZIP chunk

/// The largest half. Rounding would turn values from 65520 up into infinity, so everything beyond it is clipped.
constexpr float kLargestHalf = 65504;

/// One block of rows as halves; infinities and NaN are stored as they are. Returns the number of clipped pixels.
std::int64_t to_half(const Image<Rgb>& image, int first_row, int rows, std::vector<std::array<half, 3>>& out) {
  std::int64_t clipped = 0;
  std::size_t at = 0;
  for (int y = first_row; y < first_row + rows; ++y) {
    for (const Rgb& pixel : image.row(y)) {
      bool clips = false;
      const auto fit = [&](float v) {
        if (!std::isfinite(v) || std::abs(v) <= kLargestHalf) return half(v);
        clips = true;
        return half(std::copysign(kLargestHalf, v));
      };
      out[at++] = {fit(pixel.r), fit(pixel.g), fit(pixel.b)};
      clipped += clips;
    }
  }
  return clipped;
}

Imf::FrameBuffer frame_of(Imf::PixelType type, const char* first, std::size_t channel_bytes, std::size_t row_bytes) {
  constexpr std::array kNames = {"R", "G", "B"};
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < kNames.size(); ++c) {
    // OpenEXR's slices are not const; an output file only reads through them.
    frame.insert(kNames[c],
                 Imf::Slice(type, const_cast<char*>(first) + c * channel_bytes, 3 * channel_bytes, row_bytes));
  }
  return frame;
}

}  // namespace

SaveReport write_exr(const Image<Rgb>& image, OutputFile& file, const SaveOptions& options) {
  const Imf::PixelType type = options.exr_half ? Imf::HALF : Imf::FLOAT;
  const auto width = static_cast<std::size_t>(image.width());
  SaveReport report;
  try {
    Imf::Header header(image.width(), image.height());
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* name : {"R", "G", "B"}) header.channels().insert(name, Imf::Channel(type));
    ExrOutput stream(file);
    Imf::OutputFile out(stream, header, 0);
    if (!options.exr_half) {
      out.setFrameBuffer(
          frame_of(type, reinterpret_cast<const char*>(image.values().data()), sizeof(float), width * sizeof(Rgb)));
      out.writePixels(image.height());
    } else {
      std::vector<std::array<half, 3>> block(width * kBlockRows);
      const auto* bytes = reinterpret_cast<const char*>(block.data());
      for (int y = 0; y < image.height(); y += kBlockRows) {
        const int rows = std::min(kBlockRows, image.height() - y);
        report.clipped_pixels += to_half(image, y, rows, block);
        const std::size_t row_bytes = width * sizeof(block[0]);
        out.setFrameBuffer(frame_of(type, bytes - row_bytes * static_cast<std::size_t>(y), sizeof(half), row_bytes));
        out.writePixels(rows);
      }
    }
  } catch (const Error&) {
    throw;
  } catch (const Iex::BaseExc& error) {
    throw Error(ErrorKind::kOutput, "cannot write " + file.path().string() + ": " + error.what());
  }
  return report;
}

}  // namespace zonal
