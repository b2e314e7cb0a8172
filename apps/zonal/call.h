#pragma once

#include <string>
#include <vector>

#include "apps/zonal/console.h"
#include "zonal/base/run.h"
#include "zonal/base/version.h"

namespace zonal {

/// One call of the command.
struct Call {
  Console console;
  Run run;                           ///< how long verbs run: threads, stop on interrupt, progress
  std::vector<std::string> command;  ///< the words that were typed, without the program
  int exit_code = 0;                 ///< of a verb that succeeded
};

}  // namespace zonal
