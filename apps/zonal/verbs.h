#pragma once

#include "apps/zonal/call.h"

namespace CLI {
class App;
}

namespace zonal {

// Each adds one verb to the command, with its options, examples and what it does.

void add_bake(CLI::App&, Call&);
void add_info(CLI::App&, Call&);
void add_convert(CLI::App&, Call&);
void add_irradiance(CLI::App&, Call&);
void add_prefilter(CLI::App&, Call&);
void add_sh(CLI::App&, Call&);
void add_light(CLI::App&, Call&);
void add_lights(CLI::App&, Call&);
void add_multiply(CLI::App&, Call&);
void add_ambient_cube(CLI::App&, Call&);
void add_shader(CLI::App&, Call&);
void add_dfg(CLI::App&, Call&);
void add_sky(CLI::App&, Call&);
void add_testcard(CLI::App&, Call&);
void add_compare(CLI::App&, Call&);
void add_merge(CLI::App&, Call&);
void add_gallery(CLI::App&, Call&);
void add_split(CLI::App&, Call&);
void add_fisheye(CLI::App&, Call&);
void add_view(CLI::App&, Call&);

}  // namespace zonal
