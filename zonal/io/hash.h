#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace zonal {

/// FNV-1a, 64 bits (Fowler, Noll & Vo 1991): names the input of a recipe. It tells files apart; it does not stop a
/// forger.
class Fnv1a {
 public:
  void add(std::span<const std::byte> bytes);
  std::uint64_t value() const { return value_; }
  /// "fnv1a64:" and 16 hexadecimal digits.
  std::string text() const;

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;  // the published offset basis
};

/// Adds every byte of a file. Throws Error{kInput} when it cannot be read.
void add_file(Fnv1a&, const std::filesystem::path&);

}  // namespace zonal
