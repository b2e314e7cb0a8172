#include "zonal/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "zonal/base/check.h"
#include "zonal/base/error.h"

namespace zonal {
namespace {

int thread_count(const Run& run, int tasks) {
  const int wanted = run.threads > 0 ? run.threads : static_cast<int>(std::thread::hardware_concurrency());
  return std::clamp(wanted, 1, std::max(1, tasks));
}

/// Our own executor: threads take the next task from a counter. The calling thread works too.
void run_on_threads(int threads, int count, const std::function<void(int)>& task) {
  std::atomic<int> next = 0;
  const auto drain = [&] {
    for (int i = next.fetch_add(1); i < count; i = next.fetch_add(1)) task(i);
  };
  std::vector<std::jthread> helpers;
  for (int t = 1; t < threads; ++t) helpers.emplace_back(drain);
  drain();
}

/// What the blocks of one call share: how many are done, and the failure with the lowest index.
class Ledger {
 public:
  Ledger(const Run& run, std::string_view stage, int blocks) : run_(run), stage_(stage), blocks_(blocks) {}

  bool stopped() const { return failed_.load(std::memory_order_relaxed) || run_.stop.stop_requested(); }

  void done() {
    if (!run_.progress || stage_.empty()) return;
    const std::lock_guard lock(mutex_);
    run_.progress(stage_, static_cast<double>(++done_) / blocks_);
  }

  void fail(int index, std::exception_ptr failure) {
    const std::lock_guard lock(mutex_);
    if (!failure_ || index < failed_index_) {
      failure_ = std::move(failure);
      failed_index_ = index;
    }
    failed_.store(true, std::memory_order_relaxed);
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
    if (run_.stop.stop_requested()) throw Error(ErrorKind::kCancelled, "cancelled");
  }

 private:
  const Run& run_;
  std::string_view stage_;
  int blocks_;
  int done_ = 0;
  int failed_index_ = 0;
  std::atomic<bool> failed_ = false;
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace

void for_each_block(const Run& run, std::string_view stage, int count, int block_size,
                    const std::function<void(Block)>& work) {
  check(block_size > 0, "block_size must be positive");
  const int blocks = (count + block_size - 1) / block_size;
  Ledger ledger(run, stage, blocks);
  const auto task = [&](int index) {
    if (ledger.stopped()) return;
    try {
      work({index, index * block_size, std::min(count, (index + 1) * block_size)});
      ledger.done();
    } catch (...) {
      ledger.fail(index, std::current_exception());
    }
  };
  if (run.executor) {
    run.executor(blocks, task);
  } else {
    run_on_threads(thread_count(run, blocks), blocks, task);
  }
  ledger.rethrow();
}

}  // namespace zonal
