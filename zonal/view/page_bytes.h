#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace zonal {

/// Numbers for a page, in one piece that is compressed as a whole (packed_text.h). Arrays are put in plane by plane:
/// the lowest bytes of all their numbers first, then the next, so that the slow bytes lie side by side. Little endian.
class PageBytes {
 public:
  /// Where the array begins, in bytes. The same array again costs nothing: it is where it was the first time.
  std::size_t add(std::span<const std::uint32_t> numbers) { return add_planes(std::as_bytes(numbers), 4); }
  std::size_t add(std::span<const std::uint16_t> numbers) { return add_planes(std::as_bytes(numbers), 2); }

  std::size_t size() const { return bytes_.size(); }
  std::string_view bytes() const { return bytes_; }

 private:
  std::size_t add_planes(std::span<const std::byte> numbers, std::size_t width);

  std::string bytes_;
  std::map<std::string, std::size_t> known_;
};

}  // namespace zonal
