#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "apps/zonal/interrupt.h"
#include "apps/zonal/nearest_word.h"
#include "apps/zonal/verbs.h"
#include "zonal/base/error.h"

namespace {

using zonal::Error, zonal::ErrorKind, zonal::Call;

constexpr int kUsageCode = 2, kInputCode = 3, kInternalCode = 70;

struct Kind {
  const char* name;
  int exit_code;
};

Kind describe(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::kUsage:
      return {"usage", kUsageCode};
    case ErrorKind::kInput:
      return {"input", kInputCode};
    case ErrorKind::kOutput:
      return {"output", 4};
    case ErrorKind::kCancelled:
      break;
  }
  return {"cancelled", 5};
}

/// For errors whose place did not know what to do about them.
const char* default_hint(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::kUsage:
      return "zonal --help lists what can be said";
    case ErrorKind::kInput:
      return "the file may be damaged: copy, download or export it again";
    case ErrorKind::kOutput:
      return "write to another folder or disk";
    case ErrorKind::kCancelled:
      break;
  }
  return "nothing was written";
}

void add_verbs(CLI::App& app, Call& call) {
  zonal::add_bake(app, call);
  zonal::add_info(app, call);
  zonal::add_convert(app, call);
  zonal::add_irradiance(app, call);
  zonal::add_prefilter(app, call);
  zonal::add_sh(app, call);
  zonal::add_light(app, call);
  zonal::add_lights(app, call);
  zonal::add_multiply(app, call);
  zonal::add_ambient_cube(app, call);
  zonal::add_shader(app, call);
  zonal::add_dfg(app, call);
  zonal::add_sky(app, call);
  zonal::add_testcard(app, call);
  zonal::add_compare(app, call);
  zonal::add_merge(app, call);
  zonal::add_gallery(app, call);
  zonal::add_split(app, call);
  zonal::add_fisheye(app, call);
  zonal::add_view(app, call);
}

/// A first word that is no verb deserves a better answer than a parser's.
void check_verb(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.empty() || words[0].empty() || words[0][0] == '-') return;
  std::vector<std::string> verbs;
  for (const CLI::App* verb : app.get_subcommands({})) verbs.push_back(verb->get_name());
  for (const std::string& verb : verbs) {
    if (verb == words[0]) return;
  }
  throw Error(ErrorKind::kUsage, "there is no verb '" + words[0] + "'",
              "did you mean '" + zonal::nearest_word(words[0], verbs) + "'? zonal --help lists all");
}

int run_command(int argc, char** argv, Call& call) {
  CLI::App app("Image-based lighting done exactly: any panorama in, light out.", "zonal");
  app.set_version_flag("--version", std::string(zonal::kProgram));
  app.require_subcommand(1);
  app.footer(
      "zonal VERB --help shows the options of a verb and examples.\n\n"
      "Exit codes: 0 success, 1 pictures differ (compare --max-error), 2 usage, 3 input, 4 output, 5 cancelled.");
  add_verbs(app, call);
  call.command.assign(argv + 1, argv + argc);
  try {
    check_verb(app, call.command);
    app.parse(argc, argv);
    call.console.finish();
    return call.exit_code;
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // --help, --version
    const bool verb_known = !app.get_subcommands().empty();
    const std::string verb = verb_known ? " " + app.get_subcommands()[0]->get_name() : "";
    throw Error(ErrorKind::kUsage, e.what(), "zonal" + verb + " --help shows what can be said");
  }
}

}  // namespace

int main(int argc, char** argv) {
  Call call;
  call.run.stop = zonal::stop_on_interrupt();
  if (zonal::ProgressBar::possible()) {
    call.run.progress = [&](std::string_view stage, double fraction) { call.console.progress(stage, fraction); };
  }
  try {
    return run_command(argc, argv, call);
  } catch (const Error& e) {
    const auto [kind, exit_code] = describe(e.kind());
    call.console.fail(kind, e.what(), e.hint().empty() ? default_hint(e.kind()) : e.hint(), exit_code);
    return exit_code;
  } catch (const std::bad_alloc&) {
    call.console.fail("input", "there is not enough memory for this", "use a smaller picture or a smaller size",
                      kInputCode);
    return kInputCode;
  } catch (const std::exception& e) {
    call.console.fail("internal", fmt::format("this is an error of the program: {}", e.what()),
                      "please report it with the command that caused it", kInternalCode);
    return kInternalCode;
  }
}
