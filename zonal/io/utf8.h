#pragma once

#include <cstddef>
#include <string_view>

namespace zonal {

/// Bytes of the well-formed UTF-8 character that `text` begins with; 0 when it is empty or begins with none (overlong
/// forms, surrogates and values above U+10FFFF are not well-formed: Unicode 15, table 3-7).
std::size_t utf8_character_length(std::string_view text);

bool is_utf8(std::string_view text);

}  // namespace zonal
