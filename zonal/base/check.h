#pragma once

#include <stdexcept>

namespace zonal {

/// The code is wrong: a promise of a public verb was broken by its caller. Always on, costs one branch. `message` names
/// the verb and what it was promised.
inline void check(bool ok, const char* message) {
  if (!ok) [[unlikely]]
    throw std::logic_error(message);
}

}  // namespace zonal
