#include "apps/zonal/console.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include "zonal/report/text.h"

namespace zonal {
namespace {

void print(std::FILE* to, std::string_view text) { std::fwrite(text.data(), 1, text.size(), to); }

}  // namespace

void Console::to_stderr(std::string_view label, std::string_view text) {
  bar_.clear();
  std::fflush(stdout);  // so that both streams read in order on a terminal
  print(stderr, fmt::format("{}: {}\n", label, text));
}

void Console::answer(std::string_view line) {
  if (json) return;
  bar_.clear();
  print(stdout, line);
  print(stdout, "\n");
}

void Console::field(std::string name, JsonValue value) { fields_.emplace_back(std::move(name), std::move(value)); }

void Console::wrote(const std::filesystem::path& path, std::uint64_t bytes, std::string_view what) {
  if (json) {
    files_.push_back(JsonValue::Object{{"path", path.string()}, {"bytes", bytes}, {"what", what}});
  } else if (!quiet) {
    answer(fmt::format("{:<36} {:>9}  {}", path.string(), byte_count(bytes), what));
  }
}

void Console::note(const std::string& text) {
  notes_.push_back(text);
  if (!quiet) to_stderr("note", text);
}

void Console::warn(const std::string& text) {
  warnings_.push_back(text);
  to_stderr("warning", text);
}

void Console::progress(std::string_view stage, double fraction) {
  if (!quiet) bar_.show(stage, fraction);
}

void Console::fail(std::string_view kind, std::string_view message, std::string_view hint, int exit_code) {
  to_stderr("zonal", message);
  if (!hint.empty()) to_stderr("hint", hint);
  if (!json) return;
  const JsonValue error =
      JsonValue::Object{{"kind", kind}, {"message", message}, {"hint", hint}, {"exit_code", exit_code}};
  print(stdout, json_text(JsonValue::Object{{"error", error}, {"warnings", warnings_}, {"notes", notes_}}));
  std::fflush(stdout);
}

void Console::finish() {
  bar_.clear();
  if (json) {
    if (!files_.empty()) field("files", std::move(files_));
    field("warnings", std::move(warnings_));
    field("notes", std::move(notes_));
    print(stdout, json_text(std::move(fields_)));
  }
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    const std::string why = errno == 0 ? "the write was cut short" : std::generic_category().message(errno);
    json = false;  // there is nobody to read it
    throw Error(ErrorKind::kOutput, "cannot write to standard output: " + why, "send it to a file on a disk with room");
  }
}

}  // namespace zonal
