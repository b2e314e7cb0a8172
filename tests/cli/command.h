#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "zonal/image/image.h"
#include "zonal/math/vec.h"

namespace zonal {

/// What a call of the command left behind.
struct Result {
  int code = -1;  ///< exit code; -1: killed by a signal
  std::string out, err;
};

/// Each test has a folder of its own, in which the command runs and which is gone afterwards.
class Cli : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  /// Calls the command and waits. With `stdout_path`, standard output goes there.
  Result run(const std::vector<std::string>& words, const std::string& stdout_path = {}) const;
  /// The same, interrupted after a while.
  Result run_interrupted(const std::vector<std::string>& words, int milliseconds) const;
  /// Calls the command, which must succeed.
  Result good(const std::vector<std::string>& words) const;
  /// Calls the command, which must fail with this code, a line of what is wrong and a hint, and leave no file behind.
  Result bad(int code, const std::vector<std::string>& words, std::string_view says) const;

  std::filesystem::path path(std::string_view name) const { return folder_ / name; }
  /// Every file in the folder, below it too, with its bytes.
  std::map<std::string, std::string> files(const std::filesystem::path& below = {}) const;

  void write(std::string_view name, std::string_view bytes) const;
  /// A float picture; 1 or 3 channels, bottom row first.
  void write_pfm(std::string_view name, int width, int height, const std::vector<float>& values) const;

 private:
  std::filesystem::path folder_;
};

/// A file's bytes.
std::string bytes_of(const std::filesystem::path&);
/// The pixels of a picture that must be readable.
Image<Rgb> pixels_of(const std::filesystem::path&);
/// The largest difference of any channel from a value.
double worst_from(const Image<Rgb>&, double value);

}  // namespace zonal
