#include "zonal/io/exr.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticitiesAttribute.h>
#include <OpenEXR/ImfEnvmapAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <algorithm>
#include <vector>

#include "zonal/base/error.h"
#include "zonal/base/parallel.h"
#include "zonal/io/exr_channels.h"
#include "zonal/io/exr_headers.h"
#include "zonal/io/exr_stream.h"

namespace zonal {
namespace {

/// A multiple of the rows in a chunk of every compression, so that no chunk is decoded twice.
constexpr int kBlockRows = 256;

/// OpenEXR's own threads stay off (they belong to the whole process): blocks of rows run on ours, each with a reader.
constexpr int kNoLibraryThreads = 0;

class ExrFile {
 public:
  explicit ExrFile(const ByteReader& reader) : stream_(reader), file_(stream_, kNoLibraryThreads, false) {}
  Imf::MultiPartInputFile& operator*() { return file_; }
  Imf::MultiPartInputFile* operator->() { return &file_; }

 private:
  ExrInput stream_;
  Imf::MultiPartInputFile file_;
};

ExrWindow window_of(const Imath::Box2i& box) { return {box.min.x, box.min.y, box.max.x, box.max.y}; }

ExrPart part_of(const Imf::Header& header) {
  ExrPart part;
  if (header.hasName()) part.name = header.name();
  part.is_deep = header.hasType() && Imf::isDeepData(header.type());
  const Imf::ChannelList& channels = header.channels();
  for (auto it = channels.begin(); it != channels.end(); ++it) part.channels.emplace_back(it.name());
  part.data = window_of(header.dataWindow());
  part.display = window_of(header.displayWindow());
  if (Imf::hasChromaticities(header)) {
    const Imf::Chromaticities& c = Imf::chromaticities(header);
    part.chromaticities = {c.red.x, c.red.y, c.green.x, c.green.y, c.blue.x, c.blue.y, c.white.x, c.white.y};
  }
  if (Imf::hasEnvmap(header)) part.envmap = Imf::envmap(header);
  return part;
}

std::vector<ExrPart> parts_of(const Imf::MultiPartInputFile& file) {
  std::vector<ExrPart> parts;
  for (int i = 0; i < file.parts(); ++i) parts.push_back(part_of(file.header(i)));
  return parts;
}

/// Rows that may be decoded at once without decoding a chunk for two blocks.
int block_rows(const Imf::Header& header) {
  if (!header.hasTileDescription()) return kBlockRows;
  const int tile = static_cast<int>(std::min(header.tileDescription().ySize, 1u << 20));
  return (kBlockRows + tile - 1) / tile * tile;
}

static_assert(sizeof(Rgb) == 3 * sizeof(float), "a channel is a slice of the picture");

/// Decodes rows straight into the picture; OpenEXR converts half and integer channels to float on the way.
void read_rows(const ByteReader& reader, const ExrChoice& choice, Block rows, Image<Rgb>& pixels) {
  ExrFile file(reader);
  Imf::InputPart part(*file, choice.part);
  const Imath::Box2i window = part.header().dataWindow();
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < choice.channels.size(); ++c) {
    float* first = &pixels.values().data()->r + c;
    frame.insert(choice.channels[c], Imf::Slice::Make(Imf::FLOAT, first, window, sizeof(Rgb),
                                                      sizeof(Rgb) * static_cast<std::size_t>(pixels.width())));
  }
  part.setFrameBuffer(frame);
  part.readPixels(window.min.y + rows.begin, window.min.y + rows.end - 1);
  if (choice.kind != ExrChoice::kLuminance) return;
  for (int y = rows.begin; y < rows.end; ++y) {
    for (Rgb& pixel : pixels.row(y)) pixel.g = pixel.b = pixel.r;
  }
}

/// Luminance-chroma goes through OpenEXR's own reconstruction, which keeps neighbouring rows and so runs in order.
void read_luminance_chroma(const ByteReader& reader, const ExrChoice& choice, Image<Rgb>& pixels) {
  ExrInput stream(reader);
  const std::string layer = choice.layer.empty() ? "" : choice.layer.substr(0, choice.layer.size() - 1);
  Imf::RgbaInputFile file(stream, layer, kNoLibraryThreads);
  const Imath::Box2i window = file.dataWindow();
  std::vector<Imf::Rgba> row(static_cast<std::size_t>(pixels.width()));
  for (int y = 0; y < pixels.height(); ++y) {
    file.setFrameBuffer(row.data() - window.min.x, 1, 0);
    file.readPixels(window.min.y + y);
    for (int x = 0; x < pixels.width(); ++x) {
      const Imf::Rgba& p = row[static_cast<std::size_t>(x)];
      pixels(x, y) = Rgb(p.r, p.g, p.b);
    }
  }
}

Picture read_file(const ByteReader& reader, const Run& run) {
  ExrFile file(reader);
  const ExrChoice choice = choose_exr_channels(reader, parts_of(*file));
  const bool complete = file->partComplete(choice.part);
  if (!complete) reader.fail("this OpenEXR was never finished: rows are missing", "write it again");
  const Imf::Header& header = file->header(choice.part);
  for (const std::string& name : choice.channels) {
    const Imf::Channel& channel = header.channels()[name];
    if (channel.xSampling != 1 || channel.ySampling != 1) reader.fail("this OpenEXR has subsampled colour channels");
  }
  const Imath::Box2i window = header.dataWindow();
  Picture picture = exr_picture(choice, window.max.x - window.min.x + 1, window.max.y - window.min.y + 1);
  if (choice.kind == ExrChoice::kLuminanceChroma) {
    read_luminance_chroma(reader, choice, picture.pixels);
  } else {
    for_each_block(run, "read", picture.pixels.height(), block_rows(header),
                   [&](Block rows) { read_rows(reader, choice, rows, picture.pixels); });
  }
  return picture;
}

}  // namespace

std::optional<Picture> load_exr(ByteReader& reader, const LoadOptions& options, const Run& run) {
  if (!is_exr(reader)) return std::nullopt;
  check_exr_headers(reader, options);
  try {
    return read_file(reader, run);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {  // Iex::BaseExc, and std::bad_alloc for sizes that the headers hid
    reader.fail(std::string("broken OpenEXR: ") + error.what());
  }
}

}  // namespace zonal
