#pragma once

#include <string>
#include <string_view>

namespace zonal {

/// Loads a font that has the signs of formulas, where the machine has one; the built-in one otherwise. Once, before the
/// first frame. `scale` is the screen's.
void load_font(float scale);

/// The text as the font can show it: signs that it lacks are written out ("pi", "^2").
std::string shown(std::string_view text);

}  // namespace zonal
