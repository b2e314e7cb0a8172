#pragma once

#include "apps/zonal/call.h"

namespace CLI {
class App;
}

namespace zonal {

/// --threads, --isa, --quiet, --json: every verb has them.
void add_run_options(CLI::App&, Call&);

}  // namespace zonal
