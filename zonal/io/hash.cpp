#include "zonal/io/hash.h"

#include <array>

#include "zonal/io/byte_reader.h"

namespace zonal {

void Fnv1a::add(std::span<const std::byte> bytes) {
  constexpr std::uint64_t kPrime = 0x100000001b3;
  std::uint64_t value = value_;
  for (const std::byte byte : bytes) value = (value ^ static_cast<std::uint64_t>(byte)) * kPrime;
  value_ = value;
}

std::string Fnv1a::text() const {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "fnv1a64:";
  for (int shift = 60; shift >= 0; shift -= 4) text += kDigits[(value_ >> shift) & 15];
  return text;
}

void add_file(Fnv1a& hash, const std::filesystem::path& path) {
  ByteReader reader(path);
  std::array<std::byte, 1 << 15> block;
  while (const std::size_t count = reader.read_some(block)) hash.add(std::span(block).first(count));
}

}  // namespace zonal
