#include "zonal/io/roughness_map.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace zonal {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

TEST(RoughnessMap, LevelsAndRoughnessAreInversePairs) {
  int from_level = 0, from_roughness = 0;
  for (const RoughnessMap map : all_roughness_maps()) {
    for (const int levels : {2, 5, 6, 7, 9}) {
      const int last = levels - 1;
      for (int i = 0; i <= 64; ++i) {
        const double level = last * i / 64.0;
        if (const double r = roughness_of_level(map, level, levels); r < 1) {
          EXPECT_NEAR(level_of_roughness(map, r, levels), level, 16 * kEps * last)  // a few roundings
              << name_of(map) << ' ' << levels;
          ++from_level;
        }
        const double roughness = i / 64.0;
        if (const double l = level_of_roughness(map, roughness, levels); l > 0 && l < last) {
          EXPECT_NEAR(roughness_of_level(map, l, levels), roughness,
                      64 * kEps)  // 1 - t next to 1, then its root: magnified by 32
              << name_of(map) << ' ' << levels;
          ++from_roughness;
        }
      }
    }
  }
  EXPECT_GT(from_level, 5 * 5 * 40);
  EXPECT_GT(from_roughness, 5 * 5 * 40);
}

TEST(RoughnessMap, GoesTheSameWayEverywhere) {
  int compared = 0;
  for (const RoughnessMap map : all_roughness_maps()) {
    double before = -1;
    for (int i = 0; i <= 1000; ++i, ++compared) {
      const double level = level_of_roughness(map, i / 1000.0, 6);
      EXPECT_GE(level, before);
      EXPECT_LE(level, 5);
      before = level;
    }
  }
  EXPECT_EQ(compared, 5 * 1001);
}

TEST(RoughnessMap, HasThePublishedValues) {
  EXPECT_DOUBLE_EQ(level_of_roughness(RoughnessMap::kLinear, 0.25, 5), 1);
  EXPECT_DOUBLE_EQ(level_of_roughness(RoughnessMap::kFilament, 0.5, 5), 3);
  EXPECT_DOUBLE_EQ(level_of_roughness(RoughnessMap::kUnity, 0.5, 7), 6 * 0.5 * 1.35);
  EXPECT_DOUBLE_EQ(level_of_roughness(RoughnessMap::kUnity, 1, 7), 6);
  // N - 1 - (1 - 1.2 log2 r) with N = 8 levels.
  EXPECT_DOUBLE_EQ(level_of_roughness(RoughnessMap::kUnreal, 1, 8), 6);
  EXPECT_DOUBLE_EQ(level_of_roughness(RoughnessMap::kUnreal, 0.25, 8), 6 - 2.4);
  EXPECT_DOUBLE_EQ(level_of_roughness(RoughnessMap::kUnreal, 0, 8), 0);
  // 0.8 log2(size r^2) with size 256.
  EXPECT_DOUBLE_EQ(level_of_roughness(RoughnessMap::kBabylon, 0.5, 9), 0.8 * 6);
  for (const RoughnessMap map : {RoughnessMap::kLinear, RoughnessMap::kFilament, RoughnessMap::kUnity}) {
    EXPECT_EQ(roughness_of_level(map, 0, 5), 0);
    EXPECT_NEAR(roughness_of_level(map, 4, 5), 1, 2 * kEps);
  }
  EXPECT_EQ(roughness_of_level(RoughnessMap::kUnreal, 7, 8), 1);
  EXPECT_EQ(roughness_of_level(RoughnessMap::kFilament, 0, 1), 0);
}

TEST(RoughnessMap, NamesAreUnique) {
  for (const RoughnessMap map : all_roughness_maps()) EXPECT_EQ(roughness_map_named(name_of(map)), map);
  EXPECT_EQ(all_roughness_maps().size(), 5u);
  EXPECT_EQ(roughness_map_named("cubic"), std::nullopt);
}

TEST(RoughnessMap, OutsideItsDomainIsAMistakeOfTheCaller) {
  EXPECT_THROW((void)level_of_roughness(RoughnessMap::kLinear, 1.5, 5), std::logic_error);
  EXPECT_THROW((void)level_of_roughness(RoughnessMap::kLinear, 0.5, 0), std::logic_error);
  EXPECT_THROW((void)roughness_of_level(RoughnessMap::kLinear, 5, 5), std::logic_error);
}

}  // namespace
}  // namespace zonal
