#include "zonal/io/shader_number.h"

#include <cmath>
#include <limits>

#include "zonal/base/error.h"
#include "zonal/io/json_text.h"

namespace zonal {

std::string shader_number(double value, std::string_view suffix) {
  if (!(std::abs(value) <= std::numeric_limits<float>::max())) {
    throw Error(ErrorKind::kInput, "SH coefficients: " + shortest(value) + " does not fit a 32-bit float");
  }
  std::string digits = shortest(static_cast<float>(value));
  if (digits.find_first_of(".e") == digits.npos) digits += ".0";  // an integer otherwise
  return digits.append(suffix);
}

}  // namespace zonal
