#include "zonal/io/json_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

namespace zonal {
namespace {

TEST(JsonText, LooksAsPromised) {
  const JsonValue value =
      JsonValue::Object{{"name", "a\"b\\c\n\x01\xc3\xbc"},
                        {"zeta", 1},
                        {"alpha", JsonValue::Array{1.5, true, nullptr}},
                        {"rows", JsonValue::Array{JsonValue::Array{1, 2}, JsonValue::Array{3.25f, 0.1f}}},
                        {"none", JsonValue::Object{}},
                        {"empty", JsonValue::Array{}}};
  EXPECT_EQ(json_text(value), R"({
  "name": "a\"b\\c\u000a\u0001ü",
  "zeta": 1,
  "alpha": [1.5, true, null],
  "rows": [
    [1, 2],
    [3.25, 0.1]
  ],
  "none": {},
  "empty": []
}
)");
}

TEST(JsonText, EveryByteStringBecomesValidJson) {
  int parsed = 0, exact = 0;
  for (int a = 0; a < 256; ++a) {
    for (const char* around : {"", "x", "\xc3"}) {
      const std::string text = around + std::string(1, static_cast<char>(a)) + "end";
      const nlohmann::json read = nlohmann::json::parse(json_text(text));
      parsed += read.is_string();
      exact += read.get<std::string>() == text;
    }
  }
  EXPECT_EQ(parsed, 3 * 256);
  EXPECT_EQ(exact, 128 + 128 + 64);  // ASCII alone and after x; a continuation byte after the lead byte C3
}

TEST(JsonText, NumbersReadBackBitForBit) {
  std::mt19937_64 random(7);
  int doubles = 0, floats = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto d = std::bit_cast<double>(random());
    if (std::isfinite(d)) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(nlohmann::json::parse(json_text(d)).get<double>()),
                std::bit_cast<std::uint64_t>(d));
      ++doubles;
    }
    const auto f = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (std::isfinite(f)) {
      const std::string text = shortest(f);
      float read = 0;
      std::from_chars(text.data(), text.data() + text.size(), read);
      EXPECT_EQ(std::bit_cast<std::uint32_t>(read), std::bit_cast<std::uint32_t>(f));
      ++floats;
    }
  }
  EXPECT_GT(doubles, 19000);
  EXPECT_GT(floats, 19000);
  EXPECT_EQ(json_text(std::numeric_limits<double>::infinity()), "null\n");
  EXPECT_EQ(json_text(std::nan("")), "null\n");
  EXPECT_EQ(shortest(0.1f), "0.1");
  EXPECT_EQ(json_text(std::numeric_limits<std::uint64_t>::max()), "18446744073709551615\n");
}

}  // namespace
}  // namespace zonal
