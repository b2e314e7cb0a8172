// What the module reads by itself. PNG, JPEG and WebP are decoded by the browser (show_pixels in light.cpp).
#include "zonal/io/picture_loaders.h"

#include <array>

#include "zonal/io/exr.h"
#include "zonal/io/hdr.h"
#include "zonal/io/pfm.h"
#include "zonal/io/tga.h"

namespace zonal {
namespace {

/// TGA has no magic number, so it comes last.
constexpr std::array<PictureLoader, 4> kLoaders = {load_exr, load_hdr, load_pfm, load_tga};

}  // namespace

std::span<const PictureLoader> picture_loaders() { return kLoaders; }

std::string_view picture_format_names() { return "OpenEXR, Radiance HDR, PFM, PNG, JPEG, WebP or TGA"; }

}  // namespace zonal
