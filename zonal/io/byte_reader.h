#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace zonal {

/// The bytes of a file (or of a block of memory that plays one) in order, through a small window, with the name to
/// blame. Little words for decoders that trust nothing: reading past the end throws Error{kInput} "ends early".
class ByteReader {
 public:
  /// Throws Error{kInput} when the file is missing, not a regular file, or unreadable.
  explicit ByteReader(const std::filesystem::path&);
  ByteReader(std::string name, std::vector<std::byte> bytes);

  /// A second reader of the same bytes, at the start: for threads.
  ByteReader another() const;

  const std::string& name() const { return name_; }
  std::uint64_t size() const { return size_; }
  std::uint64_t position() const { return window_start_ + next_; }
  std::uint64_t remaining() const { return size_ - position(); }
  /// Past the end is allowed; the next read then says so.
  void seek(std::uint64_t position);

  std::uint8_t byte() {
    if (next_ == window_.size()) refill();
    return static_cast<std::uint8_t>(window_[next_++]);
  }
  void read(std::span<std::byte> into);
  void read(std::span<std::uint8_t> into) { read(std::as_writable_bytes(into)); }
  /// As many bytes as there are, at most into.size(). Never throws: for callbacks under C libraries.
  std::size_t read_some(std::span<std::byte> into) noexcept;
  /// The first bytes of the file, at most `count`; leaves the position at the start.
  std::vector<std::uint8_t> head(std::size_t count);

  /// Throws Error{kInput} "name: what".
  [[noreturn]] void fail(const std::string& what, const std::string& hint = {}) const;
  [[noreturn]] void fail_early_end() const;

 private:
  void refill();
  bool try_refill() noexcept;

  std::string name_;
  std::filesystem::path path_;                            // empty: memory
  std::shared_ptr<const std::vector<std::byte>> memory_;  // null: a file
  std::unique_ptr<std::ifstream> stream_;
  std::vector<std::byte> buffer_;
  std::span<const std::byte> window_;  // of buffer_ or of all of memory_
  std::uint64_t window_start_ = 0;
  std::size_t next_ = 0;  // in the window
  std::uint64_t size_ = 0;
};

}  // namespace zonal
