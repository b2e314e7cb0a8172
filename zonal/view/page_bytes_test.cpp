#include "zonal/view/page_bytes.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <string_view>
#include <vector>

#include "zonal/view/packed_text.h"
#include "zonal/view/packed_text_test.h"

namespace zonal {
namespace {

std::vector<std::byte> bytes_of(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

std::string numbers_of(const PageBytes& page) { return unpacked(packed_text(std::as_bytes(std::span(page.bytes())))); }

TEST(PageBytes, Base91OfAnyBytesOfAnyLength) {
  EXPECT_EQ(base91_text(bytes_of("")), "");
  EXPECT_EQ(base91_text(bytes_of(std::string(1, '\0'))), "!!");
  std::mt19937 random(91);
  std::set<char> seen;
  for (std::size_t length = 0; length < 300; ++length) {
    std::string bytes(length, '\0');
    for (char& c : bytes) c = static_cast<char>(random());
    const std::string text = base91_text(bytes_of(bytes));
    EXPECT_EQ(decoded91(text), bytes) << length;
    EXPECT_LE(13 * text.size(), 16 * length + 13);
    seen.insert(text.begin(), text.end());
  }
  EXPECT_EQ(seen.size(), 91u);
  for (const char c : {' ', '"', '<', '@', '\x7f'}) EXPECT_FALSE(seen.contains(c)) << c;
}

TEST(PageBytes, PutsNumbersDownPlaneByPlane) {
  PageBytes page;
  EXPECT_EQ(page.add(std::vector<std::uint16_t>{0x0102, 0x0304, 0x0506}), 0u);
  EXPECT_EQ(page.add(std::vector<std::uint32_t>{0x0a0b0c0d, 0x1a1b1c1d}), 6u);
  EXPECT_EQ(numbers_of(page), std::string("\x02\x04\x06\x01\x03\x05\x0d\x1d\x0c\x1c\x0b\x1b\x0a\x1a", 14));
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
