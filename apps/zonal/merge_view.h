#pragma once

#include <string>

#include "apps/zonal/input.h"
#include "apps/zonal/output.h"

namespace CLI {
class App;
}

namespace zonal {

/// How the photographs of a bracket show the sphere, if they do, and how their merge is written.
struct MergeView {
  InputOptions photographs;  ///< what describes a projection, turns and fills in; nothing else is used
  OutputOptions output;
};

void add_merge_view_options(CLI::App&, MergeView&);

/// Throws Error{kUsage} for what cannot be written, before any work is done; once the size of the photographs is known,
/// also Error{kInput} or {kUsage} where they cannot be what they are said to be.
void check_merge_view(const MergeView&);
void check_merge_view(const MergeView&, ImageSize);

/// Writes a merge: as the picture it is; or, where --from says how it shows the sphere, in the projection that is asked
/// for, or cut to its circle.
void write_merge_view(Image<Rgb> radiance, const MergeView&, Call&);

}  // namespace zonal
