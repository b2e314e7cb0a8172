#pragma once

#include <span>
#include <string_view>

namespace zonal {

/// A file of zonal/view/page, put into the library when it is built (cmake/embed.cmake).
struct PagePart {
  std::string_view stem, text;
};
std::span<const PagePart> page_parts();

/// std::logic_error when there is none of this stem.
std::string_view page_part(std::string_view stem);

}  // namespace zonal
