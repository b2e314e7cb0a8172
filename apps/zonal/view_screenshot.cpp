#include "apps/zonal/view_screenshot.h"

#include <fmt/format.h>

#include <cstdio>

#include "apps/zonal/view_picture.h"
#include "zonal/base/error.h"
#include "zonal/io/file.h"
#include "zonal/io/png.h"

namespace zonal {
namespace {

ImageSize size_in(const std::string& text) {
  ImageSize size;
  char end = 0;
  if (std::sscanf(text.c_str(), "%5dx%5d%c", &size.width, &size.height, &end) != 2 || size.width < 1 ||
      size.height < 1) {
    throw Error(ErrorKind::kUsage, "'" + text + "' is not a size", "write it as 1280x720");
  }
  return size;
}

}  // namespace

void write_screenshot(const ViewData& data, const ViewState& state, const std::filesystem::path& path,
                      const std::string& size_text, const MeshLoadOptions& mesh, Call& call) {
  const ImageSize size = size_in(size_text);
  ViewPainter painter(data, state.mesh, mesh, call);
  const std::vector<std::byte> png = encode_png(painter.picture(state, size));
  const double difference = painter.difference(state);
  write_file(path, png);
  call.console.wrote(path, png.size(), state.technique->title);
  call.console.answer(fmt::format("difference to the exact answer: {:.2g} of it (RMS over the object)", difference));
  call.console.field("technique", std::string(state.technique->id));
  call.console.field("difference_rms", difference);
}

}  // namespace zonal
