#include "zonal/base/parallel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "zonal/base/error.h"

namespace zonal {
namespace {

Run with_threads(int threads) {
  zonal::Run run;
  run.threads = threads;
  return run;
}

TEST(ForEachBlock, VisitsEveryIndexOnce) {
  for (const int threads : {1, 2, 7}) {
    std::vector<int> visits(1003, 0);
    for_each_block(with_threads(threads), {}, 1003, 10, [&](Block b) {
      EXPECT_EQ(b.begin, b.index * 10);
      for (int i = b.begin; i < b.end; ++i) ++visits[i];
    });
    int once = 0;
    for (const int v : visits) once += v == 1;
    EXPECT_EQ(once, 1003);
  }
}

TEST(ForEachBlock, NothingToDoCallsNothing) {
  int calls = 0;
  for_each_block({}, "stage", 0, 4, [&](Block) { ++calls; });
  EXPECT_EQ(calls, 0);
}

TEST(ForEachBlock, UsesTheExecutorItIsGiven) {
  zonal::Run run;
  std::set<int> tasks;
  run.executor = [&](int count, const std::function<void(int)>& task) {
    for (int i = count - 1; i >= 0; --i) {
      tasks.insert(i);
      task(i);
    }
  };
  int sum = 0;
  for_each_block(run, {}, 10, 3, [&](Block b) { sum += b.end - b.begin; });
  EXPECT_EQ(tasks.size(), 4U);
  EXPECT_EQ(sum, 10);
}

TEST(ForEachBlock, ThrowsTheFailureOfTheFirstBlockThatFailed) {
  for (const int threads : {1, 4}) {
    try {
      // Every block fails, so whichever run, the lowest of them did: block 0 is always taken.
      for_each_block(with_threads(threads), {}, 100, 1,
                     [&](Block b) { throw std::runtime_error(std::to_string(b.index)); });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& e) {
      EXPECT_STREQ(e.what(), "0");
    }
  }
}

TEST(ForEachBlock, StopsWhenAsked) {
  std::stop_source source;
  zonal::Run run = with_threads(2);
  run.stop = source.get_token();
  std::atomic<int> done = 0;
  try {
    for_each_block(run, {}, 1000000, 1, [&](Block) {
      if (++done == 10) source.request_stop();
    });
    FAIL() << "was not cancelled";
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::kCancelled);
  }
  EXPECT_LT(done.load(), 1000);
}

TEST(ForEachBlock, ReportsProgressFromZeroToOne) {
  zonal::Run run = with_threads(3);
  std::vector<double> fractions;
  run.progress = [&](std::string_view stage, double fraction) {
    EXPECT_EQ(stage, "work");
    fractions.push_back(fraction);
  };
  for_each_block(run, "work", 20, 1, [](Block) {});
  ASSERT_EQ(fractions.size(), 20U);
  for (std::size_t i = 0; i < fractions.size(); ++i) EXPECT_DOUBLE_EQ(fractions[i], static_cast<double>(i + 1) / 20);
}

TEST(ReduceBlocks, HasTheSameBitsForAnyNumberOfThreads) {
  // A sum whose value depends on its order in the last bits.
  const auto sum = [](int threads) {
    return reduce_blocks(
        with_threads(threads), {}, 100000, 37, 0.0,
        [](Block b) {
          double part = 0;
          for (int i = b.begin; i < b.end; ++i) part += std::sin(i) * 1e3;
          return part;
        },
        [](double& total, double part) { total += part; });
  };
  const double one = sum(1);
  EXPECT_NE(one, 0);
  EXPECT_EQ(one, sum(2));
  EXPECT_EQ(one, sum(7));
}

}  // namespace
}  // namespace zonal
