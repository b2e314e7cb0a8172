#include "zonal/io/sh_json.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "zonal/base/error.h"

namespace zonal {
namespace {

ShFile numbered(int bands, ShQuantity quantity = ShQuantity::kRadiance) {
  ShFile file{quantity, Sh<RgbD>(bands)};
  for (std::size_t i = 0; i < file.coefficients.size(); ++i) {
    const auto n = static_cast<double>(i + 1);
    file.coefficients[i] = {n, -n / 3, 1 / n};
  }
  return file;
}

constexpr std::string_view kOneBand =
    R"({"format":"zonal-sh","version":1,"bands":1,"quantity":"irradiance/pi","basis":"real",)"
    R"("condon_shortley":false,"frame":"z-up-right-handed","coefficients":[[1,2.5,-3e-2]]})";

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

TEST(ShJson, WritesTheSchema) {
  EXPECT_EQ(sh_json_text(numbered(2, ShQuantity::kIrradiance)), R"({
  "format": "zonal-sh",
  "version": 1,
  "bands": 2,
  "quantity": "irradiance",
  "basis": "real",
  "condon_shortley": false,
  "frame": "z-up-right-handed",
  "coefficients": [
    [1, -0.3333333333333333, 1],
    [2, -0.6666666666666666, 0.5],
    [3, -1, 0.3333333333333333],
    [4, -1.3333333333333333, 0.25]
  ]
}
)");
}

TEST(ShJson, ReadsTheSchema) {
  const ShFile file = parse_sh_json(kOneBand);
  EXPECT_EQ(file.quantity, ShQuantity::kIrradianceOverPi);
  ASSERT_EQ(file.coefficients.bands(), 1);
  EXPECT_EQ(file.coefficients[0], (RgbD{1, 2.5, -0.03}));
}

TEST(ShJson, RoundTripsEveryBit) {
  std::mt19937_64 random(3);
  int compared = 0;
  for (const int bands : {1, 3, 6, 40}) {
    ShFile file{ShQuantity::kRadiance, Sh<RgbD>(bands)};
    const auto finite = [&] {
      for (;;) {
        if (const auto d = std::bit_cast<double>(random()); std::isfinite(d)) return d;
      }
    };
    for (RgbD& c : file.coefficients.values()) c = {finite(), finite(), -0.0};
    const ShFile read = parse_sh_json(sh_json_text(file));
    ASSERT_EQ(read.coefficients.size(), file.coefficients.size());
    for (std::size_t i = 0; i < file.coefficients.size(); ++i, ++compared) {
      const RgbD a = file.coefficients[i], b = read.coefficients[i];
      EXPECT_EQ(std::bit_cast<std::uint64_t>(a.r), std::bit_cast<std::uint64_t>(b.r));
      EXPECT_EQ(std::bit_cast<std::uint64_t>(a.g), std::bit_cast<std::uint64_t>(b.g));
      ASSERT_TRUE(std::signbit(b.b) && b.b == 0);
    }
  }
  EXPECT_EQ(compared, 1 + 9 + 36 + 1600);
}

TEST(ShJson, CoefficientsOfTheCondonShortleyBasisAreConverted) {
  const ShFile plain = numbered(4);
  const ShFile read =
      parse_sh_json(replaced(sh_json_text(plain), "\"condon_shortley\": false", "\"condon_shortley\": true"));
  int flipped = 0;
  for (int l = 0; l < 4; ++l) {
    for (int m = -l; m <= l; ++m) {
      const double sign = m % 2 == 0 ? 1 : -1;
      EXPECT_EQ(read.coefficients(l, m), sign * plain.coefficients(l, m));
      flipped += sign < 0;
    }
  }
  EXPECT_EQ(flipped, 8);  // m = +-1 of l = 1, 2, 3 and m = +-3 of l = 3
}

TEST(ShJson, NamesTheFieldThatIsWrong) {
  const struct {
    std::string_view what, with, named;
  } cases[] = {
      {"zonal-sh", "zonal-hs", "\"format\""},
      {"\"format\":\"zonal-sh\"", "\"format\":7", "\"format\""},
      {"\"version\":1", "\"version\":2", "\"version\""},
      {"\"version\":1,", "", "\"version\""},
      {"\"bands\":1", "\"bands\":0", "\"bands\""},
      {"\"bands\":1", "\"bands\":2", "4 coefficients"},
      {"\"bands\":1", "\"bands\":1.0", "\"bands\""},
      {"\"bands\":1", "\"bands\":\"1\"", "\"bands\""},
      {"\"bands\":1", "\"bands\":99999999999999999999999", "\"bands\""},
      {"\"bands\":1", "\"bands\":4294967297", "\"bands\""},
      {"\"bands\":1", "\"bands\":-1", "\"bands\""},
      {"\"bands\":1", "\"bands\":1025", "\"bands\""},
      {"irradiance/pi", "luminance", "\"quantity\""},
      {"\"basis\":\"real\"", "\"basis\":\"complex\"", "\"basis\""},
      {"false", "0", "\"condon_shortley\""},
      {"z-up", "y-up", "\"frame\""},
      {"[[1,2.5,-3e-2]]", "{}", "\"coefficients\""},
      {"[[1,2.5,-3e-2]]", "[]", "this has 0"},
      {"[1,2.5,-3e-2]", "[1,2.5]", "coefficient 0"},
      {"[1,2.5,-3e-2]", "[1,2.5,3,4]", "coefficient 0"},
      {"[1,2.5,-3e-2]", "[1,null,3]", "coefficient 0"},
      {"[1,2.5,-3e-2]", "7", "coefficient 0"},
      {"{\"format\"", "{\"gain\":2,\"format\"", "fields"},
      {"{\"format\"", "{\"bands\":1,\"format\"", "\"bands\" appears twice"},
      {"1,2.5", "1e999,2.5", "not JSON"},
      {"]}", "]", "not JSON"},
  };
  int named = 0;
  for (const auto& [what, with, name] : cases) {
    try {
      (void)parse_sh_json(replaced(std::string(kOneBand), what, with));
      ADD_FAILURE() << "accepted " << with;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kInput);
      EXPECT_NE(std::string_view(error.what()).find(name), std::string_view::npos) << error.what();
      ++named;
    }
  }
  EXPECT_EQ(named, static_cast<int>(std::size(cases)));
}

TEST(ShJson, HostileTextIsRefusedWithoutACrash) {
  std::vector<std::string> texts = {"", "null", "[]", "\"zonal-sh\"", "{", "\xff\xfe", std::string(3, '\0')};
  texts.push_back(std::string(200000, '['));
  texts.push_back(std::string(100000, '[') + std::string(100000, ']'));
  texts.push_back("{\"format\":" + std::string(100000, '{'));
  for (std::size_t size = 0; size < kOneBand.size(); ++size) texts.emplace_back(kOneBand.substr(0, size));
  std::size_t refused = 0;
  for (const std::string& text : texts) {
    try {
      (void)parse_sh_json(text);
    } catch (const Error& error) {
      refused += error.kind() == ErrorKind::kInput;
    }
  }
  EXPECT_EQ(refused, texts.size());
}

TEST(ShJson, RandomDamageIsRefusedOrReadNeverMore) {
  std::mt19937 random(5);
  int refused = 0, read = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text(kOneBand);
    text[random() % text.size()] = static_cast<char>(random() % 256);
    try {
      read += parse_sh_json(text).coefficients.size() == 1;
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_EQ(refused + read, 20000);
  EXPECT_GT(refused, 15000);
  EXPECT_GT(read, 0);  // one digit for another
}

TEST(ShJson, WhatIsNotFiniteIsNotWritten) {
  ShFile file = numbered(2);
  file.coefficients[3].g = std::nan("");
  EXPECT_THROW((void)sh_json_text(file), Error);
  EXPECT_THROW((void)sh_json_text({}), Error);
}

TEST(ShJson, QuantitiesConvertBothWays) {
  const ShFile radiance = numbered(3);
  const ShFile irradiance = to_quantity(radiance, ShQuantity::kIrradiance);
  const double factors[] = {kPi, 2 * kPi / 3, kPi / 4};  // Ramamoorthi & Hanrahan 2001, eq. 8
  int compared = 0;
  for (int l = 0; l < 3; ++l) {
    for (int m = -l; m <= l; ++m, ++compared) {
      EXPECT_DOUBLE_EQ(irradiance.coefficients(l, m).r, factors[l] * radiance.coefficients(l, m).r);
      EXPECT_DOUBLE_EQ(to_quantity(irradiance, ShQuantity::kIrradianceOverPi).coefficients(l, m).g,
                       factors[l] / kPi * radiance.coefficients(l, m).g);
      EXPECT_DOUBLE_EQ(to_quantity(irradiance, ShQuantity::kRadiance).coefficients(l, m).b,
                       radiance.coefficients(l, m).b);
    }
  }
  EXPECT_EQ(compared, 9);
  const ShFile four = to_quantity(numbered(4), ShQuantity::kIrradiance);
  EXPECT_THROW((void)to_quantity(four, ShQuantity::kRadiance), Error);
  EXPECT_EQ(to_quantity(four, ShQuantity::kIrradianceOverPi).coefficients(3, 1), RgbD());
  for (const ShQuantity q : {ShQuantity::kRadiance, ShQuantity::kIrradiance, ShQuantity::kIrradianceOverPi}) {
    EXPECT_EQ(sh_quantity_named(name_of(q)), q);
  }
  EXPECT_EQ(sh_quantity_named("flux"), std::nullopt);
}

}  // namespace
}  // namespace zonal
