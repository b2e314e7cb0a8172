#include "zonal/base/check.h"
#include "zonal/view/page_parts.h"

namespace zonal {

std::string_view page_part(std::string_view stem) {
  for (const PagePart& each : page_parts()) {
    if (each.stem == stem) return each.text;
  }
  check(false, "there is no part of the page of this name");
  return {};
}

}  // namespace zonal
