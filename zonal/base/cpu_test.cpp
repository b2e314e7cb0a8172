#include "zonal/base/cpu.h"

#include <gtest/gtest.h>

namespace zonal {
namespace {

TEST(Isa, NamesAndLevelsAgree) {
  const auto isas = available_isas();
  ASSERT_FALSE(isas.empty());
  EXPECT_EQ(isas.front(), Isa::kBaseline);
  EXPECT_EQ(isas.back(), best_isa());
  for (const Isa isa : isas) EXPECT_EQ(isa_named(name_of(isa)), isa);
  EXPECT_EQ(isa_named("sse9"), std::nullopt);
}

}  // namespace
}  // namespace zonal
