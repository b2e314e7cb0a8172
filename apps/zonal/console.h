#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "apps/zonal/progress.h"
#include "zonal/base/error.h"
#include "zonal/io/json_text.h"

namespace zonal {

/// How a command talks. Results go to standard output: lines for people, or with --json one object and nothing else.
/// Warnings, notes, errors and progress go to standard error.
class Console {
 public:
  bool quiet = false;  ///< no notes, no progress, no list of files; answers, warnings and errors stay
  bool json = false;

  /// A line of the answer.
  void answer(std::string_view line);
  /// A field of the answer as JSON.
  void field(std::string name, JsonValue value);
  /// A file that was written.
  void wrote(const std::filesystem::path&, std::uint64_t bytes, std::string_view what);
  /// A choice that was made for the user.
  void note(const std::string&);
  /// Something doubtful.
  void warn(const std::string&);
  void progress(std::string_view stage, double fraction);
  /// What went wrong, at last.
  void fail(std::string_view kind, std::string_view message, std::string_view hint, int exit_code);

  /// Ends the output. Throws Error{kOutput} when standard output did not take it.
  void finish();

 private:
  void to_stderr(std::string_view label, std::string_view text);

  ProgressBar bar_;
  JsonValue::Object fields_;
  JsonValue::Array files_, notes_, warnings_;
};

}  // namespace zonal
