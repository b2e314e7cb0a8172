#pragma once

#include <filesystem>

#include "zonal/io/picture.h"

namespace zonal {

/// Writes a picture into an open file, for callers that commit several files together.
using PictureWriter = SaveReport (*)(const Image<Rgb>&, OutputFile&, const SaveOptions&);

/// By extension. Throws Error{kUsage} for one that save_picture() does not know.
PictureWriter require_picture_writer(const std::filesystem::path&);

}  // namespace zonal
