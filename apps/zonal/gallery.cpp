#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <utility>

#include "apps/zonal/input_options.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/verbs.h"
#include "zonal/io/environment_file.h"
#include "zonal/report/gallery_page.h"
#include "zonal/report/gallery_probe.h"

namespace zonal {
namespace {

struct GalleryCommand {
  InputOptions probe;
  std::filesystem::path folder;
};

struct Probe {
  Environment environment;
  std::string name;
};

Probe probe_of(const InputOptions& options, Call& call) {
  if (options.paths.empty()) return {gallery_probe(call.run), "a built-in room with three lights"};
  Input input = read_input(options, call);
  return {whole_light(input, options, call).environment, environment_name(options.paths)};
}

JsonValue json_of(const GalleryFigure& figure) {
  JsonValue::Array numbers;
  for (const PublishedNumber& n : figure.numbers) {
    numbers.push_back(JsonValue::Object{{"what", n.what},
                                        {"printed", n.printed},
                                        {"ours", n.ours},
                                        {"expected", n.expected},
                                        {"tolerance", n.tolerance},
                                        {"holds", holds(n)}});
  }
  return JsonValue::Object{{"id", figure.id}, {"source", figure.source}, {"numbers", std::move(numbers)}};
}

void say_numbers(const std::vector<GalleryFigure>& figures, Console& console) {
  std::size_t numbers = 0, held = 0;
  JsonValue::Array list;
  for (const GalleryFigure& figure : figures) {
    for (const PublishedNumber& n : figure.numbers) {
      ++numbers;
      if (holds(n)) {
        ++held;
      } else {
        console.warn(fmt::format("{}: {} is {:.7g}, not {:.7g} to {:.2g}", figure.title, n.what, n.ours, n.expected,
                                 n.tolerance));
      }
    }
    list.push_back(json_of(figure));
  }
  console.answer(
      fmt::format("{} figures; {} of {} numbers agree with the paper or with theory", figures.size(), held, numbers));
  console.field("figures", std::move(list));
}

void run_gallery(const GalleryCommand& command, Call& call) {
  OutputFolder folder(command.folder);  // before the work, so that a folder that cannot be is noticed at once
  const Probe probe = probe_of(command.probe, call);
  const std::vector<GalleryFigure> figures = gallery_figures(probe.environment, call.run);
  const std::vector<GalleryFile> files = write_gallery(figures, {probe.name, std::string(kProgram)}, folder);
  if (call.run.stop.stop_requested()) throw Error(ErrorKind::kCancelled, "cancelled");
  folder.commit();
  for (const GalleryFile& file : files) call.console.wrote(command.folder / file.name, file.bytes, file.what);
  say_numbers(figures, call.console);
}

}  // namespace

void add_gallery(CLI::App& app, Call& call) {
  auto command = std::make_shared<GalleryCommand>();
  CLI::App& verb =
      *app.add_subcommand("gallery", "Every figure of the paper on SH tricks, drawn again, with its numbers and ours.");
  add_input_options(verb, command->probe);
  verb.remove_option(verb.get_option("IN"));
  CLI::Option* probe = verb.add_option("--probe", command->probe.paths,
                                       "the light to show, as IN of the other verbs; a built-in room if not said")
                           ->group("Input");
  for (CLI::Option* option : verb.get_options([](const CLI::Option* o) { return o->get_group() == "Input"; })) {
    if (option != probe) option->needs(probe);  // they describe it
  }
  verb.add_option("-o,--output", command->folder, "folder for the page and its pictures; made if it is not there")
      ->required()
      ->group("Output");
  add_run_options(verb, call);
  verb.footer(
      "Examples:\n"
      "  zonal gallery -o gallery\n"
      "  zonal gallery -o gallery --probe sunset.exr\n"
      "  zonal gallery -o gallery --probe faces/ --rotate 90 --json");
  verb.callback([command, &call] { run_gallery(*command, call); });
}

}  // namespace zonal
