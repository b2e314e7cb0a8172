#include "zonal/sh/convention.h"

#include <gtest/gtest.h>

namespace zonal {
namespace {

TEST(Convention, CondonShortleyNegatesOddM) {
  Sh<double> plain(8);
  for (std::size_t i = 0; i < plain.size(); ++i) plain[i] = 1 + static_cast<double>(i);
  const Sh<double> with_sign = to_condon_shortley(plain);
  int negated = 0;
  for (int l = 0; l < 8; ++l) {
    for (int m = -l; m <= l; ++m) {
      EXPECT_EQ(with_sign(l, m), (m % 2 == 0 ? 1 : -1) * plain(l, m));
      negated += with_sign(l, m) < 0;
    }
  }
  EXPECT_EQ(negated, 0 + 2 + 2 + 4 + 4 + 6 + 6 + 8);
  EXPECT_EQ(from_condon_shortley(with_sign), plain);
}

}  // namespace
}  // namespace zonal
