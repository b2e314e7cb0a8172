#pragma once

#include "apps/zonal/session.h"

namespace CLI {
class App;
}

namespace zonal {

// Each adds one verb to the command, with its options, examples and what it does.

void add_bake(CLI::App&, Session&);
void add_info(CLI::App&, Session&);
void add_convert(CLI::App&, Session&);
void add_irradiance(CLI::App&, Session&);
void add_prefilter(CLI::App&, Session&);
void add_sh(CLI::App&, Session&);
void add_dfg(CLI::App&, Session&);
void add_sky(CLI::App&, Session&);
void add_testcard(CLI::App&, Session&);
void add_compare(CLI::App&, Session&);

}  // namespace zonal
