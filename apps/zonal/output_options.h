#pragma once

#include "apps/zonal/output.h"

namespace CLI {
class App;
}

namespace zonal {

/// -o and how the map is laid out and stored. `size_help` says what --size is when it is not given.
void add_output_options(CLI::App&, OutputOptions&, const char* size_help);

}  // namespace zonal
