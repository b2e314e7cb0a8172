#include "zonal/view/page_bytes.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <string_view>
#include <vector>

#include "zonal/view/packed_text.h"

namespace zonal {
namespace {

std::vector<std::byte> bytes_of(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

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

std::string unpacked(const PageBytes& page) {
  const std::string packed = decoded(packed_text(std::as_bytes(std::span(page.bytes()))));
  std::string plain(page.size(), '\0');
  uLongf length = static_cast<uLongf>(plain.size());
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(plain.data()), &length, reinterpret_cast<const Bytef*>(packed.data()),
                       static_cast<uLong>(packed.size())),
            Z_OK);
  EXPECT_EQ(length, plain.size());
  return plain;
}

TEST(PageBytes, Base64AsInTheStandard) {
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

TEST(PageBytes, PutsNumbersDownPlaneByPlane) {
  PageBytes page;
  EXPECT_EQ(page.add(std::vector<std::uint16_t>{0x0102, 0x0304, 0x0506}), 0u);
  EXPECT_EQ(page.add(std::vector<std::uint32_t>{0x0a0b0c0d, 0x1a1b1c1d}), 6u);
  EXPECT_EQ(unpacked(page), std::string("\x02\x04\x06\x01\x03\x05\x0d\x1d\x0c\x1c\x0b\x1b\x0a\x1a", 14));
}

TEST(PageBytes, HoldsTheSameArrayOnce) {
  PageBytes page;
  const std::vector<std::uint32_t> first = {1, 2, 3}, second = {1, 2, 4};
  EXPECT_EQ(page.add(first), 0u);
  EXPECT_EQ(page.add(second), 12u);
  EXPECT_EQ(page.add(first), 0u);
  EXPECT_EQ(page.size(), 24u);
}

}  // namespace
}  // namespace zonal
