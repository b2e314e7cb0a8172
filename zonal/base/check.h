#pragma once

#include <source_location>
#include <stdexcept>
#include <string>

namespace zonal {

/// The code is wrong: a promise of a public verb was broken by its caller. Always on, costs one branch.
inline void check(bool ok, const char* message, std::source_location where = std::source_location::current()) {
  if (!ok) [[unlikely]] {
    throw std::logic_error(std::string(where.file_name()) + ":" + std::to_string(where.line()) + ": " + message);
  }
}

}  // namespace zonal
