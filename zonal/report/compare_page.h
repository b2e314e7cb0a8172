#pragma once

#include <string>
#include <vector>

#include "zonal/image/image.h"
#include "zonal/math/vec.h"
#include "zonal/report/html.h"

namespace zonal {

/// Two pictures that should be the same.
struct ComparePage {
  std::string title;
  Image<Rgb> expected, got;  ///< linear; of any sizes, different ones too
  std::vector<Fact> facts;   ///< what else helps: tolerances, commands
};

/// A self-contained page with both pictures at one exposure, their difference in false colours, and the figures of
/// compare().
std::string compare_page_html(const ComparePage&);

}  // namespace zonal
