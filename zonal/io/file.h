#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace zonal {

/// Every byte of a regular file. Throws Error{kInput} when it is missing, not a regular file, unreadable, or longer
/// than `max_bytes` (the hint names the limit).
std::vector<std::byte> read_file(const std::filesystem::path&, std::uint64_t max_bytes = std::uint64_t{1} << 32);

/// A file that appears whole or not at all. The bytes go to a temporary name in the target's folder; commit() gives
/// them the target's name in one step; without a commit the temporary file is removed and an existing target stays as
/// it was. A symbolic link is followed: the file it points to is replaced, not the link. Every failure (no folder, no
/// permission, a full disk) throws Error{kOutput}; after one, commit() throws too.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& target);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::filesystem::path& path() const { return target_; }
  const std::filesystem::path& temporary_path() const { return temporary_; }

  void write(std::span<const std::byte> bytes);
  /// For formats whose tables come first and are known last. From the start of the file, in bytes.
  void seek(std::uint64_t position);
  std::uint64_t position() const { return position_; }
  /// Everything written so far is in the temporary file: a full disk is noticed here at the latest.
  void flush();
  void commit();

 private:
  [[noreturn]] void fail(int error_number);

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  std::unique_ptr<std::FILE, Close> file_;
  std::uint64_t position_ = 0;
  bool failed_ = false;
};

/// Writes one file whole, through OutputFile.
void write_file(const std::filesystem::path&, std::span<const std::byte> bytes);
void write_file(const std::filesystem::path&, std::string_view text);

}  // namespace zonal
