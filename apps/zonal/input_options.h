#pragma once

#include "apps/zonal/input.h"

namespace CLI {
class App;
}

namespace zonal {

/// The input itself and everything that can be said about it.
void add_input_options(CLI::App&, InputOptions&);

/// Its parts, for verbs that read their input in another way: how the picture shows the sphere, and how it is turned
/// and filled in.
void add_projection_options(CLI::App&, InputOptions&);
void add_filling_options(CLI::App&, InputOptions&);

}  // namespace zonal
