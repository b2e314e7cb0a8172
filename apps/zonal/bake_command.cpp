#include "apps/zonal/bake_command.h"

#include <fmt/format.h>

#include <chrono>
#include <utility>

#include "zonal/base/error.h"
#include "zonal/io/environment_file.h"
#include "zonal/report/bake_record.h"

namespace zonal {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::string words_of(const BakedFile& file) {
  if (file.error_bound < 0) return file.file.what;
  return fmt::format("{}, error bound {:.2g} of the mean", file.file.what, file.error_bound);
}

void say_verified(const std::string& map, const std::optional<Verification>& verified, Console& console) {
  if (!verified) return;
  console.answer(fmt::format("verified {:<20} RMS error {:.2e}, worst {:.2e} of the value, at {} texels", map,
                             verified->rms, verified->worst, verified->directions));
}

JsonValue json_of(const std::string& map, const Verification& verified) {
  return JsonValue::Object{{"map", map},
                           {"directions", verified.directions},
                           {"rms_relative_error", verified.rms},
                           {"worst_relative_error", verified.worst}};
}

void say_all_verified(const Bake& bake, Call& call) {
  JsonValue::Array list;
  const auto say = [&](const std::string& map, const std::optional<Verification>& verified) {
    say_verified(map, verified, call.console);
    if (verified) list.push_back(json_of(map, *verified));
  };
  say("irradiance", bake.irradiance_verified);
  for (std::size_t i = 0; i < bake.chain.size(); ++i) say(fmt::format("specular level {}", i), bake.chain[i].verified);
  if (!list.empty()) call.console.field("verified", std::move(list));
}

}  // namespace

void run_bake(BakeCommand& command, Call& call) {
  const Clock::time_point start = Clock::now();
  if (command.files.engine) command.bake.roughness_map = command.files.engine->roughness_map;
  if (command.roughness_map) command.bake.roughness_map = *command.roughness_map;
  command.files.writer = kProgram;

  Input input = read_input(command.input, call);
  const double reading = seconds_since(start);
  OutputFolder folder(command.folder);  // before the work, so that a folder that cannot be is noticed at once
  Bake baked;
  Survey survey;
  {
    const WholeLight light = whole_light(input, command.input, call);
    survey = light.survey;
    if (command.verify && light.shown)
      call.console.note("--verify has nothing to compare with when a part is left out");
    baked = bake(light.environment, light.shown ? &*light.shown : nullptr, command.bake, command.verify, call.run);
  }
  baked.timings.insert(baked.timings.begin(), {"read", reading});

  Clock::time_point stage = Clock::now();
  const std::vector<BakedFile> files = write_bake(baked, command.bake, command.files, folder);
  baked.timings.push_back({"write", seconds_since(stage)});

  BakeOrigin origin;
  origin.program = kProgram;
  origin.command = call.command;
  origin.command.insert(origin.command.begin(), "zonal");
  origin.name = environment_name(command.input.paths);
  origin.input = std::move(input.loaded);
  origin.input_size = input.file_size;
  origin.timings = !command.no_timings;
  for (const BakedFile& file : files) {
    if (file.warning.empty()) continue;
    origin.warnings.push_back(file.warning);
    call.console.warn(file.warning);
  }
  say_all_verified(baked, call);
  const std::string recipe = bake_recipe_json(baked, survey, command.bake, command.files, origin, files);
  BakePage shown = page_of(std::move(baked), survey, command.bake, command.files, origin, files);
  shown.viewer = bake_page_viewer(shown.panorama, call.run);
  const std::string page = bake_page_html(shown, call.run);
  folder.add("index.html", page);
  folder.add("recipe.json", recipe);
  if (call.run.stop.stop_requested()) throw Error(ErrorKind::kCancelled, "cancelled");
  folder.commit();

  for (const BakedFile& file : files)
    call.console.wrote(command.folder / file.file.name, file.file.bytes, words_of(file));
  call.console.wrote(command.folder / "index.html", page.size(), "a page to look at");
  call.console.wrote(command.folder / "recipe.json", recipe.size(), "settings, hashes, error bounds");
}

}  // namespace zonal
