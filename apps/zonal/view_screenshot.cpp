#include "apps/zonal/view_screenshot.h"

#include <fmt/format.h>

#include "zonal/base/error.h"
#ifdef ZONAL_HAS_GL
#include "zonal/gl/context.h"
#include "zonal/gl/scene.h"
#include "zonal/gl/target.h"
#include "zonal/io/file.h"
#include "zonal/io/png.h"
#endif

namespace zonal {

#ifdef ZONAL_HAS_GL
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

Image<Rgb8> as_bytes(const Image<Rgb>& display) {
  Image<Rgb8> picture(display.width(), display.height());
  const auto byte = [](float x) { return static_cast<std::uint8_t>(std::clamp(x, 0.0f, 1.0f) * 255 + 0.5f); };
  std::transform(display.values().begin(), display.values().end(), picture.values().begin(), [&](const Rgb& c) {
    return Rgb8{byte(c.r), byte(c.g), byte(c.b)};
  });
  return picture;
}

}  // namespace

void write_screenshot(const ViewData& data, const ViewState& state, const std::filesystem::path& path,
                      const std::string& size_text, const MeshLoadOptions& mesh, Call& call) {
  const ImageSize size = size_in(size_text);
  const LoadedMesh object = mesh_of(state.mesh, mesh, call.run);
  for (const std::string& note : object.notes) call.console.note(note);
  const OffscreenContext context;
  Scene scene;
  scene.set_light(data);
  scene.set_mesh(object.mesh);
  const DrawTarget target(size.width, size.height);
  target.bind();
  scene.draw(state, size.width, size.height);
  const std::vector<std::byte> png = encode_png(as_bytes(target.read()));
  const Difference difference = scene.difference(state);
  write_file(path, png);
  call.console.wrote(path, png.size(), state.technique->title);
  call.console.answer(
      fmt::format("difference to the exact answer: {:.2g} of it (RMS over the object)", difference.rms));
  call.console.field("technique", std::string(state.technique->id));
  call.console.field("difference_rms", difference.rms);
}
#else
void write_screenshot(const ViewData&, const ViewState&, const std::filesystem::path&, const std::string&,
                      const MeshLoadOptions&, Call&) {
  throw Error(ErrorKind::kUsage, "this build has no viewer",
              "install libepoxy-dev and libegl-dev and build again, or write a page: zonal view --html FILE");
}
#endif

}  // namespace zonal
