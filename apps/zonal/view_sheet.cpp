#include "apps/zonal/view_sheet.h"

#include <fmt/format.h>

#include "apps/zonal/view_picture.h"
#include "zonal/base/error.h"
#include "zonal/io/file.h"
#include "zonal/report/picture_sheet.h"
#include "zonal/report/svg.h"
#include "zonal/report/text.h"

namespace zonal {
namespace {

constexpr int kCellPx = 200;                // on paper a cell is 151 wide: sharp on fine screens
constexpr ImageSize kMeasured = {160, 90};  // some exact answers are long sums for every pixel
constexpr std::size_t kColumns = 4;         // of picture_sheet()'s largest cells
constexpr std::size_t kLetters = 24;        // that fit under one
constexpr double kLeftAndRight = 3;         // of the control `compare`

/// Lines of at most so many letters, broken between words.
std::string wrapped(std::string_view words, std::size_t letters) {
  std::string lines;
  std::size_t used = 0;
  while (!words.empty()) {
    const std::string_view word = words.substr(0, words.find(' '));
    words.remove_prefix(std::min(words.size(), word.size() + 1));
    if (used > 0) lines += used + 1 + word.size() > letters ? '\n' : ' ';
    used = used > 0 && used + 1 + word.size() <= letters ? used + 1 + word.size() : word.size();
    lines += word;
  }
  return lines;
}

}  // namespace

void write_view_sheet(const ViewData& data, ViewState state, const std::filesystem::path& path,
                      const MeshLoadOptions& mesh, const std::string& light_name, Call& call) {
  ViewPainter painter(data, state.mesh, mesh, call);
  state.set("compare", kLeftAndRight);
  PictureSheet sheet{.name = "techniques",
                     .description = fmt::format("Every technique beside its exact answer, lit by {}", light_name),
                     .columns = {},
                     .rows = {}};
  JsonValue::Array list;
  for (const Technique& technique : all_techniques()) {
    if (call.run.stop.stop_requested()) throw Error(ErrorKind::kCancelled, "cancelled");
    if (call.run.progress)
      call.run.progress("drawing", static_cast<double>(list.size()) / static_cast<double>(all_techniques().size()));
    state.technique = &technique;
    if (list.size() % kColumns == 0) sheet.rows.emplace_back();
    const double rms = painter.difference(state, kMeasured);
    sheet.rows.back().cells.push_back({.picture = painter.picture(state, {kCellPx, kCellPx}),
                                       .label = wrapped(technique.title, kLetters) + "\n" + percent(rms, 2),
                                       .round = false});
    list.push_back(JsonValue::Object{{"id", std::string(technique.id)}, {"difference_rms", rms}});
  }
  const std::string svg = standalone_svg(picture_sheet(sheet));
  write_file(path, svg);
  call.console.wrote(path, svg.size(), "every technique, left, and its exact answer, right");
  call.console.field("techniques", std::move(list));
}

}  // namespace zonal
