#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "zonal/image/response.h"

namespace zonal {

/// A response curve as text: 256 lines of three numbers, the exposure (radiance times seconds) that gives code 0, 1,
/// ... 255 in red, green and blue; '#' starts a comment. Written with all digits, so that a curve measured once serves
/// every bracket of that camera with the same bits.
std::string response_text(const Response&);

/// Reads such a text; one number a line serves all channels. Throws Error{kInput} with the line: a count other than
/// 256, what is no number, negative, falling, or all zero.
Response parse_response(const std::string& name, std::string_view text);
Response load_response(const std::filesystem::path&);

}  // namespace zonal
