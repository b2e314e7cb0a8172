#pragma once

#include <optional>
#include <string>

#include "apps/zonal/call.h"
#include "zonal/math/vec.h"
#include "zonal/sh/sh.h"
#include "zonal/sh/window.h"

namespace CLI {
class App;
}

namespace zonal {

/// What a user says about a window.
struct WindowOptions {
  std::string window;                      ///< "NAME[:NUMBER...]", empty for none
  std::optional<WindowChannels> channels;  ///< for windows that look at the function
};

void add_window_options(CLI::App&, WindowOptions&);

/// Throws Error{kUsage} when the words make no window, before any work is done.
void check_window(const WindowOptions&);

/// The function under the window. Says what the window did, and to the least value of up to 10 bands.
Sh<RgbD> windowed(const Sh<RgbD>&, const WindowOptions&, Call&);

}  // namespace zonal
