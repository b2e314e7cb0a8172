// The exports of the module: a picture goes in, and the tables of its light come out as page_give(), the same that
// view_page_html() writes into a page.
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "apps/web/host.h"
#include "zonal/base/error.h"
#include "zonal/io/integer_samples.h"
#include "zonal/io/picture.h"
#include "zonal/light/resample.h"
#include "zonal/light/survey_words.h"
#include "zonal/sphere/fineness.h"
#include "zonal/sphere/mapping.h"
#include "zonal/view/light_tables.h"

namespace zonal {
namespace {

/// What a person says about a picture, as the command's IN, --from and --fix.
struct LightRequest {
  std::string name;
  std::string from;  ///< the name of a layout; "" to be guessed
  bool fix = false;
};

Run page_run() {
  Run run;
  run.progress = [](std::string_view stage, double fraction) { page_progress(stage.data(), stage.size(), fraction); };
  return run;
}

Guess projection_of(const LightRequest& request, ImageSize size) {
  if (!request.from.empty()) {
    const std::optional<Layout> layout = layout_named(request.from);
    if (!layout) throw Error(ErrorKind::kUsage, "there is no projection '" + request.from + "'");
    return {{*layout}, "as chosen"};
  }
  if (std::optional<Guess> guess = guess_projection(size, request.name)) return *std::move(guess);
  throw Error(ErrorKind::kInput,
              request.name + ": neither its shape, " + std::to_string(size.width) + "x" + std::to_string(size.height) +
                  ", nor its name says how it shows the sphere",
              "choose how it does, and it is opened again");
}

/// Counts what is doubtful; throws for what is not finite, unless it is to be repaired.
void examine(Environment& light, const LightRequest& request, const Run& run, std::vector<std::string>& notes) {
  const Survey found = survey(light, run);
  if (request.fix) {
    const Repairs repairs = repair(light);
    notes.push_back(std::to_string(repairs.non_finite) +
                    " texels were not finite and have their neighbours' mean now; " + std::to_string(repairs.negative) +
                    " were negative and are 0 now");
    return;
  }
  const std::string words = non_finite_words(found);
  if (!words.empty()) {
    throw Error(ErrorKind::kInput, request.name + ": " + words,
                "choose to repair it: they get the mean of their neighbours");
  }
  if (found.negative_texels > 0) {
    notes.push_back(std::to_string(found.negative_texels) + " texels hold negative radiance; it is kept");
  }
  if (found.clipped_sun) notes.push_back("the brightest light looks clipped: its shadows will be too soft");
  if (!(found.max_luminance > 0)) notes.push_back("the picture is black");
}

void show(Picture picture, const LightRequest& request) {
  const Run run = page_run();
  const ImageSize size = {picture.pixels.width(), picture.pixels.height()};
  const Guess guess = projection_of(request, size);
  std::vector<std::string> notes = std::move(picture.notes);
  Environment light = {std::move(picture.pixels), guess.projection};
  const bool whole = Mapping(guess.projection, size).covers_sphere();
  examine(light, request, run, notes);
  if (!whole) light = resample(light, {Layout::kEquirect}, panorama_rows(guess.projection, size), {}, run);

  PageBytes bytes;
  JsonValue::Object tables = light_tables(view_data(light, view_page_data_options(), run), bytes);
  JsonValue::Array words(notes.begin(), notes.end());
  tables.emplace_back("name", request.name);
  tables.emplace_back("projection", name_of(guess.projection.layout));
  tables.emplace_back("projection_reason", guess.reason);
  tables.emplace_back("notes", std::move(words));
  const std::string json = json_text(tables);
  page_give(json.data(), json.size(), bytes.bytes().data(), bytes.bytes().size());
}

/// Eight bits of red, green, blue and alpha for each pixel, as a browser decodes them.
Picture browser_picture(const std::uint8_t* rgba, ImageSize size, bool file_says_linear) {
  Picture picture;
  picture.pixels = Image<Rgb>(size.width, size.height);
  const std::vector<float> linear = linear_of_samples(8, decide_srgb({}, file_says_linear, picture));
  for (Rgb& pixel : picture.pixels.values()) {
    pixel = {linear[rgba[0]], linear[rgba[1]], linear[rgba[2]]};
    picture.alpha = picture.alpha || rgba[3] < 255;
    rgba += 4;
  }
  if (picture.alpha) picture.notes.push_back("alpha is left out; what is wholly clear is black");
  return picture;
}

}  // namespace
}  // namespace zonal

extern "C" {

/// Memory for what the page hands over; it stays until the instance is thrown away.
__attribute__((export_name("allocate"))) void* allocate(std::size_t size) { return ::operator new(size); }

/// A file in one of the formats of picture_loaders(). Texts are UTF-8.
__attribute__((export_name("show_file"))) void show_file(const char* name, std::size_t name_length, const char* from,
                                                         std::size_t from_length, int fix, const std::byte* file,
                                                         std::size_t size) {
  zonal::LightRequest request = {{name, name_length}, {from, from_length}, fix != 0};
  // No limit of our own: memory is the limit, and running out of it is told.
  const zonal::LoadOptions options = {.max_pixels = std::numeric_limits<std::int64_t>::max()};
  zonal::show(zonal::decode_picture(request.name, {file, file + size}, options), request);
}

/// Pixels that the browser decoded: width * height * 4 bytes; sRGB unless the file says that they are linear.
__attribute__((export_name("show_pixels"))) void show_pixels(const char* name, std::size_t name_length,
                                                             const char* from, std::size_t from_length, int fix,
                                                             const std::uint8_t* rgba, int width, int height,
                                                             int linear) {
  zonal::show(zonal::browser_picture(rgba, {width, height}, linear != 0),
              {{name, name_length}, {from, from_length}, fix != 0});
}

}  // extern "C"
