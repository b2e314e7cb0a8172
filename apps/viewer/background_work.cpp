#include "apps/viewer/background_work.h"

#include <new>
#include <utility>

#include "zonal/base/error.h"

namespace zonal {

BackgroundWork::BackgroundWork(std::function<void()> wake, const Run& like)
    : wake_(std::move(wake)), like_(like), thread_([this](std::stop_token stop) { work(stop); }) {}

BackgroundWork::~BackgroundWork() {
  {
    const std::lock_guard lock(mutex_);
    waiting_.reset();
    running_.request_stop();
  }
  thread_.request_stop();
}

void BackgroundWork::replace(std::string title, Task task) {
  const std::lock_guard lock(mutex_);
  waiting_ = Waiting{std::move(title), std::move(task)};
  result_.reset();
  if (progress_) {
    replaced_ = true;
    running_.request_stop();
  }
  changed_.notify_all();
}

void BackgroundWork::follow(std::string title, Task task) {
  const std::lock_guard lock(mutex_);
  waiting_ = Waiting{std::move(title), std::move(task)};
  changed_.notify_all();
}

void BackgroundWork::cancel() {
  const std::lock_guard lock(mutex_);
  if (waiting_ && !progress_) result_ = WorkResult{.title = waiting_->title, .cancelled = true};
  waiting_.reset();
  replaced_ = false;
  running_.request_stop();
}

bool BackgroundWork::busy() const {
  const std::lock_guard lock(mutex_);
  return progress_.has_value() || waiting_.has_value();
}

std::optional<WorkProgress> BackgroundWork::progress() const {
  const std::lock_guard lock(mutex_);
  return progress_;
}

std::optional<WorkResult> BackgroundWork::collect() {
  const std::lock_guard lock(mutex_);
  return std::exchange(result_, std::nullopt);
}

WorkResult BackgroundWork::result_of(Waiting& waiting, const Run& run) {
  WorkResult result{.title = waiting.title};
  try {
    result.deliver = waiting.task(run);
  } catch (const Error& e) {
    result.cancelled = e.kind() == ErrorKind::kCancelled;
    result.message = e.what();
    result.hint = e.hint();
  } catch (const std::bad_alloc&) {
    result.message = "there is not enough memory for this";
    result.hint = "use a smaller picture or mesh";
  } catch (const std::exception& e) {
    result.message = std::string("this is an error of the program: ") + e.what();
  }
  return result;
}

void BackgroundWork::work(std::stop_token stop) {
  while (true) {
    Run run = like_;
    Waiting task;
    {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [&] { return waiting_.has_value(); })) return;
      task = std::move(*waiting_);
      waiting_.reset();
      progress_ = WorkProgress{task.title, {}, 0};
      running_ = std::stop_source();
      replaced_ = false;
      run.stop = running_.get_token();
    }
    run.progress = [this](std::string_view stage, double fraction) {
      {
        const std::lock_guard lock(mutex_);
        progress_->stage = stage;
        progress_->fraction = fraction;
      }
      wake_();
    };
    WorkResult result = result_of(task, run);
    {
      const std::lock_guard lock(mutex_);
      // Work that ended in spite of being stopped is still not wanted.
      if (run.stop.stop_requested() && result.deliver) {
        result.deliver = nullptr;
        result.cancelled = true;
      }
      if (!replaced_) result_ = std::move(result);
      progress_.reset();
    }
    if (stop.stop_requested()) return;
    wake_();
  }
}

}  // namespace zonal
