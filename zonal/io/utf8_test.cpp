#include "zonal/io/utf8.h"

#include <gtest/gtest.h>

#include <string>

namespace zonal {
namespace {

/// Encodes without asking whether the code point may be encoded.
std::string encoded(unsigned code, int length) {
  if (length == 1) return {static_cast<char>(code)};
  std::string text;
  for (int i = length - 1; i >= 0; --i) {
    const unsigned part = code >> (6 * i);
    const unsigned lead_mark = (0xff00u >> length) & 0xff;
    text += static_cast<char>(i == length - 1 ? lead_mark | part : 0x80 | (part & 0x3f));
  }
  return text;
}

TEST(Utf8, AcceptsEveryCodePointInItsShortestFormOnly) {
  int accepted = 0, overlong = 0;
  for (unsigned code = 0; code <= 0x10ffff; ++code) {
    const int shortest = code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
    const bool surrogate = code >= 0xd800 && code <= 0xdfff;
    ASSERT_EQ(utf8_character_length(encoded(code, shortest)), surrogate ? 0u : static_cast<unsigned>(shortest)) << code;
    accepted += !surrogate;
    for (int length = shortest + 1; length <= 4; ++length, ++overlong) {
      ASSERT_EQ(utf8_character_length(encoded(code, length)), 0u) << code;
    }
  }
  EXPECT_EQ(accepted, 0x110000 - 0x800);
  EXPECT_EQ(overlong, 3 * 0x80 + 2 * (0x800 - 0x80) + (0x10000 - 0x800));
}

TEST(Utf8, RefusesWhatIsCutOffStrayOrTooLarge) {
  for (const std::string bad :
       {"", "\x80", "\xc3", "\xe2\x82", "\xf0\x9f\x98", "\xf4\x90\x80\x80", "\xff", "\xc3(", "\xf8\x88\x80\x80\x80"}) {
    EXPECT_EQ(utf8_character_length(bad), 0u) << bad;
  }
  EXPECT_TRUE(is_utf8("\xc3\xbc\xe2\x82\xac\xf0\x9f\x98\x80 plain"));
  EXPECT_FALSE(is_utf8("plain \xfc"));
}

}  // namespace
}  // namespace zonal
