#include "apps/zonal/run_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "apps/zonal/choices.h"
#include "zonal/base/cpu.h"

namespace zonal {

void add_run_options(CLI::App& verb, Call& call) {
  constexpr const char* kGroup = "Running";
  verb.add_option("--threads", call.run.threads, "threads to use; 0: all. Results do not depend on it")
      ->check(CLI::Range(0, 1024))
      ->group(kGroup);
  const std::vector<Isa> isas = available_isas();
  add_choice(
      verb, "--isa", call.run.isa,
      [isas](std::string_view name) {
        const std::optional<Isa> isa = isa_named(name);
        return isa && std::find(isas.begin(), isas.end(), *isa) != isas.end() ? isa : std::nullopt;
      },
      names_of(isas, [](Isa isa) { return std::string(name_of(isa)); }),
      "instruction set, a weaker one repeats the bits of a weaker machine")
      ->group(kGroup);
  verb.add_flag("-q,--quiet", call.console.quiet, "no notes, no progress, no list of files; warnings and errors stay")
      ->group(kGroup);
  verb.add_flag("--json", call.console.json, "one JSON object on standard output and nothing else there")
      ->group(kGroup);
}

}  // namespace zonal
