#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>

#include "zonal/base/run.h"

namespace zonal {

/// What a task is at.
struct WorkProgress {
  std::string title, stage;
  double fraction = 0;  ///< of the stage
};

/// How a task ended: with something to do where the window lives, or with what went wrong.
struct WorkResult {
  std::string title;
  std::function<void()> deliver = {};  ///< empty after an error
  std::string message = {}, hint = {};
  bool cancelled = false;  ///< by a person; what is replaced by newer work ends without a result
};

/// One task at a time on a thread of its own, for work that would freeze a window. All calls come from one thread, the
/// window's; `wake` is called from the other one whenever there is something new to show.
class BackgroundWork {
 public:
  /// Does its work and returns what to do with it in the window, by collect()'s caller. What it throws is a message.
  using Task = std::function<std::function<void()>(const Run&)>;

  /// Tasks run as `like` says: on as many threads, by the same executor and instruction set.
  explicit BackgroundWork(std::function<void()> wake, const Run& like = {});
  /// Stops what runs and waits for it.
  ~BackgroundWork();
  BackgroundWork(const BackgroundWork&) = delete;
  BackgroundWork& operator=(const BackgroundWork&) = delete;

  /// What runs is stopped, what waits is forgotten, and this begins.
  void replace(std::string title, Task);
  /// What runs may end and be collected, what waits is forgotten: for a stream of requests of which the newest counts,
  /// where stopping each for the next would never end one.
  void follow(std::string title, Task);
  /// Stops everything; the result says so.
  void cancel();

  bool busy() const;
  /// nullopt when nothing runs.
  std::optional<WorkProgress> progress() const;
  /// The newest result that was not collected yet.
  std::optional<WorkResult> collect();

 private:
  struct Waiting {
    std::string title;
    Task task;
  };
  void work(std::stop_token);
  WorkResult result_of(Waiting&, const Run&);

  std::function<void()> wake_;
  Run like_;  // its progress and its stop are not those of a task
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::optional<Waiting> waiting_;
  std::optional<WorkProgress> progress_;  // of what runs
  std::stop_source running_;
  bool replaced_ = false;  // what runs has a successor that nobody wants it to outlive
  std::optional<WorkResult> result_;
  std::jthread thread_;  // last: it uses all the others
};

}  // namespace zonal
