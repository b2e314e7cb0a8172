#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "zonal/io/file.h"

namespace zonal {

/// Files of one folder that belong together. All are written under temporary names first; commit() gives them their
/// names. Without it nothing of them stays, nor the folders that were made for them. Throws Error{kOutput} as
/// OutputFile does.
class OutputFolder {
 public:
  explicit OutputFolder(std::filesystem::path folder);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& path() const { return folder_; }

  /// A new file, to be written by the caller. Valid as long as the folder.
  OutputFile& add(std::string_view name);
  void add(std::string_view name, std::span<const std::byte> bytes) { add(name).write(bytes); }
  void add(std::string_view name, std::string_view text) { add(name, std::as_bytes(std::span(text))); }

  void commit();

 private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> made_;  // folders, the innermost first
  std::vector<std::unique_ptr<OutputFile>> files_;
};

}  // namespace zonal
