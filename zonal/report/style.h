#pragma once

#include <string_view>

namespace zonal {

/// The style sheet of every page we write. Colours keep a contrast of at least 4.5 : 1 for text (WCAG 2.1, AA) in both
/// schemes.
std::string_view page_style();

}  // namespace zonal
