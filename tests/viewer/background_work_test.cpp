#include "apps/viewer/background_work.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <latch>
#include <stdexcept>
#include <vector>

#include "zonal/base/error.h"

namespace zonal {
namespace {

using namespace std::chrono_literals;

/// What the window's thread does: waits until it is woken, and collects.
class BackgroundWorkTest : public testing::Test {
 protected:
  WorkResult next_result() {
    const auto patience = std::chrono::steady_clock::now() + 20s;
    while (std::chrono::steady_clock::now() < patience) {
      if (std::optional<WorkResult> result = work.collect()) return std::move(*result);
      std::unique_lock lock(mutex_);
      woken_.wait_for(lock, 5ms);
    }
    ADD_FAILURE() << "nothing came";
    return {};
  }
  void wait_until_idle() {
    const auto patience = std::chrono::steady_clock::now() + 20s;
    while (work.busy() && std::chrono::steady_clock::now() < patience) std::this_thread::sleep_for(1ms);
    EXPECT_FALSE(work.busy());
  }
  /// Runs until it is stopped; tells when it began.
  static BackgroundWork::Task endless(std::latch& begun, std::atomic<int>& stopped) {
    return [&](const zonal::Run& run) -> std::function<void()> {
      begun.count_down();
      while (!run.stop.stop_requested()) std::this_thread::sleep_for(1ms);
      ++stopped;
      throw Error(ErrorKind::kCancelled, "cancelled");
    };
  }

 private:
  std::mutex mutex_;
  std::condition_variable woken_;

 protected:
  std::atomic<int> wakes = 0;
  BackgroundWork work{[this] {
    ++wakes;
    woken_.notify_all();
  }};
};

TEST_F(BackgroundWorkTest, DeliversOnTheThreadThatCollects) {
  const std::thread::id here = std::this_thread::get_id();
  std::thread::id worked, delivered;
  work.replace("count", [&](const zonal::Run&) {
    worked = std::this_thread::get_id();
    return [&] { delivered = std::this_thread::get_id(); };
  });
  const WorkResult result = next_result();
  EXPECT_EQ(result.title, "count");
  ASSERT_TRUE(result.deliver);
  result.deliver();
  EXPECT_EQ(delivered, here);
  EXPECT_NE(worked, here);
  EXPECT_FALSE(work.busy());
  EXPECT_FALSE(work.collect()) << "a result is given once";
}

TEST_F(BackgroundWorkTest, RunsAsItsCallerDoes) {
  int tasks = 0;
  const Executor executor = [&](int count, const std::function<void(int)>& task) {
    ++tasks;
    for (int i = 0; i < count; ++i) task(i);
  };
  BackgroundWork other([] {}, {.threads = 3, .executor = executor, .isa = Isa::kBaseline});
  zonal::Run seen;
  std::latch done(1);
  other.replace("look", [&](const zonal::Run& run) {
    seen = run;
    run.executor(1, [](int) {});
    done.count_down();
    return [] {};
  });
  done.wait();
  EXPECT_EQ(seen.threads, 3);
  EXPECT_EQ(seen.isa, Isa::kBaseline);
  EXPECT_EQ(tasks, 1);
  EXPECT_TRUE(seen.progress) << "progress is the window's";
}

TEST_F(BackgroundWorkTest, ShowsHowFarItIs) {
  std::latch shown(1), begun(1);
  work.replace("long", [&](const zonal::Run& run) {
    run.progress("half of it", 0.5);
    begun.count_down();
    shown.wait();
    return [] {};
  });
  begun.wait();
  const std::optional<WorkProgress> progress = work.progress();
  ASSERT_TRUE(progress);
  EXPECT_EQ(progress->title, "long");
  EXPECT_EQ(progress->stage, "half of it");
  EXPECT_EQ(progress->fraction, 0.5);
  EXPECT_GE(wakes, 1);
  shown.count_down();
  EXPECT_TRUE(next_result().deliver);
  EXPECT_FALSE(work.progress());
}

TEST_F(BackgroundWorkTest, ErrorsAreMessages) {
  work.replace("fails",
               [](const zonal::Run&) -> std::function<void()> { throw Error(ErrorKind::kInput, "broken", "mend it"); });
  WorkResult result = next_result();
  EXPECT_FALSE(result.deliver);
  EXPECT_FALSE(result.cancelled);
  EXPECT_EQ(result.message, "broken");
  EXPECT_EQ(result.hint, "mend it");
  work.replace("fails", [](const zonal::Run&) -> std::function<void()> { throw std::logic_error("impossible"); });
  result = next_result();
  EXPECT_NE(result.message.find("impossible"), std::string::npos);
  work.replace("fails", [](const zonal::Run&) -> std::function<void()> { throw std::bad_alloc(); });
  EXPECT_NE(next_result().message.find("memory"), std::string::npos);
  // And the thread is still there.
  work.replace("works", [](const zonal::Run&) { return [] {}; });
  EXPECT_TRUE(next_result().deliver);
}

TEST_F(BackgroundWorkTest, CancelStopsAndSaysSo) {
  std::latch begun(1);
  std::atomic<int> stopped = 0;
  work.replace("endless", endless(begun, stopped));
  begun.wait();
  work.cancel();
  const WorkResult result = next_result();
  EXPECT_TRUE(result.cancelled);
  EXPECT_FALSE(result.deliver);
  EXPECT_EQ(stopped, 1);
}

TEST_F(BackgroundWorkTest, WhatWasCancelledIsNotDeliveredEvenIfItEnds) {
  std::latch begun(1), go_on(1);
  work.replace("deaf", [&](const zonal::Run&) {
    begun.count_down();
    go_on.wait();
    return [] { FAIL() << "delivered"; };
  });
  begun.wait();
  work.cancel();
  go_on.count_down();
  const WorkResult result = next_result();
  EXPECT_TRUE(result.cancelled);
  EXPECT_FALSE(result.deliver);
}

TEST_F(BackgroundWorkTest, NewerWorkReplacesOlder) {
  std::latch begun(1);
  std::atomic<int> stopped = 0, middle = 0;
  work.replace("first", endless(begun, stopped));
  begun.wait();
  work.replace("second", [&](const zonal::Run&) {
    ++middle;
    return [] {};
  });
  work.replace("third", [](const zonal::Run&) { return [] {}; });
  const WorkResult result = next_result();
  EXPECT_EQ(stopped, 1);
  if (result.title == "second") {  // it may have begun before the third came; then it must not have been kept
    EXPECT_EQ(next_result().title, "third");
  } else {
    EXPECT_EQ(result.title, "third");
  }
  wait_until_idle();
  EXPECT_FALSE(work.collect());
}

TEST_F(BackgroundWorkTest, FollowingLetsTheFirstEndAndForgetsTheOnesBetween) {
  std::latch begun(1), go_on(1);
  std::vector<int> ran;
  const auto task = [&](int number) {
    return [&, number](const zonal::Run&) {
      if (number == 0) {
        begun.count_down();
        go_on.wait();
      }
      ran.push_back(number);
      return [] {};
    };
  };
  work.follow("0", task(0));
  begun.wait();
  for (int number = 1; number <= 5; ++number) work.follow(std::to_string(number), task(number));
  go_on.count_down();
  std::string last;
  while (last != "5") {
    const WorkResult result = next_result();
    ASSERT_TRUE(result.deliver);
    last = result.title;
  }
  wait_until_idle();
  EXPECT_EQ(ran, (std::vector<int>{0, 5}));
}

TEST_F(BackgroundWorkTest, EndsWithWorkThatRuns) {
  std::latch begun(1);
  std::atomic<int> stopped = 0;
  {
    BackgroundWork other([] {});
    other.replace("endless", endless(begun, stopped));
    begun.wait();
  }
  EXPECT_EQ(stopped, 1);
}

}  // namespace
}  // namespace zonal
