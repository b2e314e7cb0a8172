#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "zonal/io/picture.h"

namespace zonal {

/// nullopt: not this format. Throws Error{kInput} where it is this format, but broken.
using PictureLoader = std::optional<Picture> (*)(ByteReader&, const LoadOptions&, const Run&);

/// The formats that this program reads, in the order in which they are asked; a program without the libraries of some
/// (the web page) has its own list.
std::span<const PictureLoader> picture_loaders();
/// Their names, for hints.
std::string_view picture_format_names();

}  // namespace zonal
