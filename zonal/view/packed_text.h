#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace zonal {

/// Two letters for each 13 bits, the lowest first, as digits of base 91, the lower first; six bits or less at the end
/// have one letter. A thirteenth shorter than base64. The digits are the printable letters of ASCII without space, '"',
/// '<' and
/// '@': nothing that ends a script, and no mark of a page's template.
std::string base91_text(std::span<const std::byte>);

/// Bytes for a page: compressed (zlib, as hard as it can), in base 91.
std::string packed_text(std::span<const std::byte>);

}  // namespace zonal
