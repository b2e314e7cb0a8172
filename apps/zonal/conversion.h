#pragma once

#include "apps/zonal/input.h"
#include "apps/zonal/output.h"

namespace zonal {

/// The same light laid out as the output options say, turned and filled in as those of the input do. Of the size that
/// was asked for, or about as fine as the source; the source's own projection and size where no other is named.
/// `supersample` 0: as each texel needs. Throws Error{kUsage} when the output's name cannot hold it.
Environment converted(const Environment& source, const InputOptions&, const OutputOptions&, int supersample,
                      const Run&);

}  // namespace zonal
