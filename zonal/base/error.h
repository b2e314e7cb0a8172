#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace zonal {

/// What kind of thing in the world was wrong. The command line turns it into its exit code.
enum class ErrorKind { kUsage, kInput, kOutput, kCancelled };

/// The world is wrong: a file, an argument, a cancelled run. `message` says what, `hint` what to do about it.
/// (The code being wrong is std::logic_error: see check.h.)
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message, std::string hint = {})
      : std::runtime_error(message), kind_(kind), hint_(std::move(hint)) {}

  ErrorKind kind() const { return kind_; }
  const std::string& hint() const { return hint_; }

 private:
  ErrorKind kind_;
  std::string hint_;
};

}  // namespace zonal
