#include "zonal/io/base64.h"

#include <gtest/gtest.h>

#include <string_view>

namespace zonal {
namespace {

std::span<const std::byte> bytes_of(std::string_view text) { return std::as_bytes(std::span(text)); }

/// The inverse of base64_text(), written another way: digit by digit into a register.
std::string decoded(const std::string& text) {
  std::string bytes;
  unsigned bits = 0, held = 0;
  for (const char c : text) {
    if (c == '=') break;
    const unsigned digit = c >= 'A' && c <= 'Z'   ? c - 'A'
                           : c >= 'a' && c <= 'z' ? c - 'a' + 26
                           : c >= '0' && c <= '9' ? c - '0' + 52
                           : c == '+'             ? 62
                                                  : 63;
    bits = bits << 6 | digit;
    held += 6;
    if (held >= 8) bytes += static_cast<char>(bits >> (held -= 8) & 255);
  }
  return bytes;
}

TEST(Base64, AsInTheStandard) {
  // RFC 4648, section 10.
  EXPECT_EQ(base64_text(bytes_of("")), "");
  EXPECT_EQ(base64_text(bytes_of("f")), "Zg==");
  EXPECT_EQ(base64_text(bytes_of("fo")), "Zm8=");
  EXPECT_EQ(base64_text(bytes_of("foo")), "Zm9v");
  EXPECT_EQ(base64_text(bytes_of("foobar")), "Zm9vYmFy");
  std::string all;
  for (int i = 0; i < 256; ++i) all += static_cast<char>(i);
  EXPECT_EQ(decoded(base64_text(bytes_of(all))), all);
  EXPECT_NE(base64_text(bytes_of(all)).find('+'), std::string::npos);
  EXPECT_NE(base64_text(bytes_of(all)).find('/'), std::string::npos);
}

}  // namespace
}  // namespace zonal
