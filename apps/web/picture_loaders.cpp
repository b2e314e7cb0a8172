// What the module reads by itself. PNG, JPEG and WebP are decoded by the browser (show_pixels in light.cpp).
#include "zonal/io/picture_loaders.h"

#include <array>

#include "zonal/io/hdr.h"
#include "zonal/io/pfm.h"
#include "zonal/io/tga.h"

namespace zonal {
namespace {

std::optional<Picture> refuse_exr(ByteReader& reader, const LoadOptions&, const Run&) {
  const std::vector<std::uint8_t> magic = reader.head(4);
  if (magic != std::vector<std::uint8_t>{0x76, 0x2f, 0x31, 0x01}) return std::nullopt;
  reader.fail(
      "OpenEXR is not read in a page",
      "convert it: zonal convert IN.exr -o OUT.hdr (or OUT.pfm, which keeps every bit), or write a page for it: "
      "zonal view IN.exr --html PAGE.html");
}

/// TGA has no magic number, so it comes last.
constexpr std::array<PictureLoader, 4> kLoaders = {refuse_exr, load_hdr, load_pfm, load_tga};

}  // namespace

std::span<const PictureLoader> picture_loaders() { return kLoaders; }

std::string_view picture_format_names() { return "Radiance HDR, PFM, PNG, JPEG, WebP or TGA"; }

}  // namespace zonal
