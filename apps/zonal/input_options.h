#pragma once

#include "apps/zonal/input.h"

namespace CLI {
class App;
}

namespace zonal {

/// The input itself and everything that can be said about it.
void add_input_options(CLI::App&, InputOptions&);

}  // namespace zonal
