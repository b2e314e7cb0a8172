#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <string>
#include <vector>

namespace zonal {

/// The inverse of base91_text(), written another way: bit by bit.
inline std::string decoded91(const std::string& text) {
  static const std::string kDigits =
      "!#$%&'()*+,-./0123456789:;=>?ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]^_`abcdefghijklmnopqrstuvwxyz{|}~";
  std::vector<bool> bits;
  for (std::size_t i = 0; i < text.size(); i += 2) {
    const bool lone = i + 1 == text.size();
    const std::size_t pair = kDigits.find(text[i]) + (lone ? 0 : 91 * kDigits.find(text[i + 1]));
    for (std::size_t k = 0; k < (lone ? 6 : 13); ++k) bits.push_back((pair >> k & 1) != 0);
  }
  std::string bytes(bits.size() / 8, '\0');
  for (std::size_t i = 0; i < 8 * bytes.size(); ++i) {
    if (bits[i]) bytes[i / 8] = static_cast<char>(bytes[i / 8] | 1 << i % 8);
  }
  return bytes;
}

/// The inverse of packed_text().
inline std::string unpacked(const std::string& text) {
  const std::string packed = decoded91(text);
  std::string plain(1100 * packed.size() + 64, '\0');  // a stream is a thousandth of its numbers at least
  uLongf length = static_cast<uLongf>(plain.size());
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(plain.data()), &length, reinterpret_cast<const Bytef*>(packed.data()),
                       static_cast<uLong>(packed.size())),
            Z_OK);
  plain.resize(length);
  return plain;
}

}  // namespace zonal
