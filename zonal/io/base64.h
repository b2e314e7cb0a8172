#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace zonal {

/// Base64 of RFC 4648, section 4.
std::string base64_text(std::span<const std::byte>);

}  // namespace zonal
