#include "zonal/report/ticks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <vector>

namespace zonal {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
const double kNan = std::nan("");

/// What every axis owes its reader, whatever the range.
void expect_good(const Ticks& ticks, AxisRange range, int at_most) {
  ASSERT_EQ(ticks.at.size(), ticks.labels.size());
  EXPECT_GE(ticks.at.size(), 2u);
  EXPECT_LE(ticks.at.size(), static_cast<std::size_t>(at_most));
  const double slack =
      1e-8 * std::max(std::abs(range.lo), std::abs(range.hi));  // ticks at the ends may miss by rounding
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    EXPECT_GE(ticks.at[i], range.lo - slack);
    EXPECT_LE(ticks.at[i], range.hi + slack);
    if (i > 0) {
      EXPECT_GT(ticks.at[i], ticks.at[i - 1]);
    }
  }
  EXPECT_EQ(std::set<std::string>(ticks.labels.begin(), ticks.labels.end()).size(), ticks.labels.size())
      << "labels repeat";
}

TEST(Ticks, LinearLabels) {
  EXPECT_EQ(linear_ticks({0, 1}, 7).labels, (std::vector<std::string>{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(linear_ticks({-30, 30}, 7).labels, (std::vector<std::string>{"−30", "−20", "−10", "0", "10", "20", "30"}));
  EXPECT_EQ(linear_ticks({1, 6}, 7, true).labels, (std::vector<std::string>{"1", "2", "3", "4", "5", "6"}));
  EXPECT_EQ(linear_ticks({0, 1}, 7, true).labels, (std::vector<std::string>{"0", "1"}));
}

TEST(Ticks, LogLabels) {
  EXPECT_EQ(log_ticks({0.01, 100}, 7).labels, (std::vector<std::string>{"0.01", "0.1", "1", "10", "100"}));
  EXPECT_EQ(log_ticks({1e-6, 1e-4}, 7).labels, (std::vector<std::string>{"10⁻⁶", "10⁻⁵", "10⁻⁴"}));
}

TEST(Ticks, OddRanges) {
  const std::vector<AxisRange> odd = {{0, 0},          {5, 5},           {-5, -5},      {0, 1e-300},
                                      {-1e308, 1e308}, {1e300, 1.1e300}, {-1e-9, 2e-9}, {1e9, 1e9 + 1},
                                      {1, 1 + 1e-15},  {0.999, 1.001},   {-7, 0},       {3, 1e7}};
  int compared = 0;
  for (const AxisRange given : odd) {
    SCOPED_TRACE(testing::Message() << given.lo << " to " << given.hi);
    const AxisRange range = axis_range(given.lo, given.hi, false);
    ASSERT_LT(range.lo, range.hi);
    expect_good(linear_ticks(range, 7), range, 7);
    if (given.lo > 0) {
      const AxisRange log_range = axis_range(given.lo, given.hi, true);
      expect_good(log_ticks(log_range, 7), log_range, 8);
    }
    ++compared;
  }
  EXPECT_EQ(compared, 12);
}

TEST(Ticks, RandomRanges) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> exponent(-30, 30), sign(-1, 1);
  int compared = 0;
  for (int i = 0; i < 3000; ++i) {
    const double a = sign(random) * std::pow(10, exponent(random)), b = sign(random) * std::pow(10, exponent(random));
    const AxisRange range = axis_range(std::min(a, b), std::max(a, b), false);
    expect_good(linear_ticks(range, 6), range, 6);
    const AxisRange log_range =
        axis_range(std::min(std::abs(a), std::abs(b)), std::max(std::abs(a), std::abs(b)), true);
    expect_good(log_ticks(log_range, 6), log_range, 7);
    if (HasFailure()) FAIL() << a << ' ' << b;
    ++compared;
  }
  EXPECT_EQ(compared, 3000);
}

TEST(Ticks, RefusesWhatHasNoPlace) {
  EXPECT_THROW(axis_range(kNan, 1, false), std::logic_error);
  EXPECT_THROW(axis_range(0, kInf, false), std::logic_error);
  EXPECT_THROW(axis_range(2, 1, false), std::logic_error);
  EXPECT_THROW(axis_range(0, 1, true), std::logic_error);
  EXPECT_THROW(linear_ticks({0, kNan}, 7), std::logic_error);
  EXPECT_THROW(log_ticks({-1, 1}, 7), std::logic_error);
}

}  // namespace
}  // namespace zonal
