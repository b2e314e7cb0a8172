#include "zonal/io/jpeg.h"

#include <cstdio>
// libjpeg's headers need <cstdio> before them.
#include <jerror.h>
#include <jpeglib.h>

#include <array>
#include <csetjmp>
#include <cstring>

#include "zonal/io/integer_samples.h"

namespace zonal {
namespace {

/// A progressive file may state any number of scans, each a pass over the whole picture; real ones have about ten.
constexpr int kMaxScans = 500;

/// What libjpeg calls back into. Plain memory: its errors jump over everything.
struct Decoding {
  jpeg_decompress_struct jpeg = {};
  jpeg_error_mgr errors = {};
  jpeg_source_mgr source = {};
  jpeg_progress_mgr progress = {};
  std::jmp_buf jump = {};
  ByteReader* reader = nullptr;
  std::array<JOCTET, 1 << 14> buffer = {};
  std::array<char, JMSG_LENGTH_MAX> message = {};
  bool ended_early = false;
  int warnings = 0;
};

Decoding& decoding_of(j_common_ptr jpeg) { return *static_cast<Decoding*>(jpeg->client_data); }
Decoding& decoding_of(j_decompress_ptr jpeg) { return *static_cast<Decoding*>(jpeg->client_data); }

[[noreturn]] void jump_out(j_common_ptr jpeg) {
  Decoding& decoding = decoding_of(jpeg);
  jpeg->err->format_message(jpeg, decoding.message.data());
  std::longjmp(decoding.jump, 1);
}

[[noreturn]] void on_error(j_common_ptr jpeg) { jump_out(jpeg); }

void on_message(j_common_ptr jpeg, int level) {
  if (level >= 0) return;  // tracing
  // The entropy decoder ran into a marker and would invent the rest of the picture.
  if (jpeg->err->msg_code == JWRN_HIT_MARKER) jump_out(jpeg);
  Decoding& decoding = decoding_of(jpeg);
  if (decoding.warnings++ == 0) jpeg->err->format_message(jpeg, decoding.message.data());
}

void on_output(j_common_ptr) {}

void on_progress(j_common_ptr jpeg) {
  if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number <= kMaxScans) return;
  Decoding& decoding = decoding_of(jpeg);
  std::snprintf(decoding.message.data(), decoding.message.size(), "it has more than %d scans", kMaxScans);
  std::longjmp(decoding.jump, 1);
}

void on_start(j_decompress_ptr) {}
void on_end(j_decompress_ptr) {}

boolean on_more(j_decompress_ptr jpeg) {
  Decoding& decoding = decoding_of(jpeg);
  const std::size_t count = decoding.reader->read_some(std::as_writable_bytes(std::span(decoding.buffer)));
  if (count == 0) {
    decoding.ended_early = true;
    std::longjmp(decoding.jump, 1);
  }
  decoding.source.next_input_byte = decoding.buffer.data();
  decoding.source.bytes_in_buffer = count;
  return TRUE;
}

void on_skip(j_decompress_ptr jpeg, long count) {
  jpeg_source_mgr& source = decoding_of(jpeg).source;
  while (count > static_cast<long>(source.bytes_in_buffer)) {
    count -= static_cast<long>(source.bytes_in_buffer);
    on_more(jpeg);
  }
  if (count <= 0) return;
  source.next_input_byte += count;
  source.bytes_in_buffer -= static_cast<std::size_t>(count);
}

class JpegReader {
 public:
  explicit JpegReader(ByteReader& reader) {
    session_.reader = &reader;
    session_.jpeg.client_data = &session_;
    session_.jpeg.err = jpeg_std_error(&session_.errors);
    session_.errors.error_exit = on_error;
    session_.errors.emit_message = on_message;
    session_.errors.output_message = on_output;
    session_.source.init_source = on_start;
    session_.source.fill_input_buffer = on_more;
    session_.source.skip_input_data = on_skip;
    session_.source.resync_to_restart = jpeg_resync_to_restart;
    session_.source.term_source = on_end;
    session_.progress.progress_monitor = on_progress;
    run([&] {
      jpeg_create_decompress(&session_.jpeg);
      session_.jpeg.src = &session_.source;
      session_.jpeg.progress = &session_.progress;
    });
  }
  ~JpegReader() { jpeg_destroy_decompress(&session_.jpeg); }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;

  jpeg_decompress_struct& jpeg() { return session_.jpeg; }
  int warnings() const { return session_.warnings; }
  const char* message() const { return session_.message.data(); }

  /// Runs calls into libjpeg. Its errors jump back here over `work`, which must own nothing.
  template <class Work>
  void run(const Work& work) {
    if (setjmp(session_.jump) == 0) {
      work();
      return;
    }
    if (session_.ended_early) session_.reader->fail_early_end();
    session_.reader->fail("broken JPEG: " + std::string(session_.message.data()));
  }

 private:
  Decoding session_;
};

}  // namespace

std::optional<Picture> load_jpeg(ByteReader& reader, const LoadOptions& options, const Run&) {
  const std::vector<std::uint8_t> magic = reader.head(3);
  if (magic != std::vector<std::uint8_t>{0xff, 0xd8, 0xff}) return std::nullopt;
  JpegReader file(reader);
  jpeg_decompress_struct& jpeg = file.jpeg();
  file.run([&] { jpeg_read_header(&jpeg, TRUE); });
  check_picture_size(reader, jpeg.image_width, jpeg.image_height, options);
  if (jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK) {
    reader.fail("this JPEG holds CMYK (ink), not light", "convert it to RGB");
  }
  Picture picture;
  picture.format = "JPEG";
  picture.channels = jpeg.num_components;
  const std::vector<float> linear = linear_of_samples(8, decide_srgb(options, false, picture));

  const bool grey = jpeg.jpeg_color_space == JCS_GRAYSCALE;
  jpeg.out_color_space = grey ? JCS_GRAYSCALE : JCS_RGB;
  file.run([&] { jpeg_start_decompress(&jpeg); });
  picture.pixels = Image<Rgb>(static_cast<int>(jpeg.output_width), static_cast<int>(jpeg.output_height));
  std::vector<JSAMPLE> samples(static_cast<std::size_t>(jpeg.output_width) * (grey ? 1 : 3));
  file.run([&] {
    while (jpeg.output_scanline < jpeg.output_height) {
      const int y = static_cast<int>(jpeg.output_scanline);
      JSAMPROW row = samples.data();
      jpeg_read_scanlines(&jpeg, &row, 1);
      for (Rgb& pixel : picture.pixels.row(y)) {
        pixel = grey ? Rgb(linear[row[0]], linear[row[0]], linear[row[0]])
                     : Rgb(linear[row[0]], linear[row[1]], linear[row[2]]);
        row += grey ? 1 : 3;
      }
    }
    jpeg_finish_decompress(&jpeg);
  });
  if (file.warnings() > 0) picture.notes.push_back(std::string("the JPEG is damaged: ") + file.message());
  return picture;
}

}  // namespace zonal
