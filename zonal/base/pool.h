#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace zonal {

/// Scratch space for the blocks of one call: as many pieces are made as blocks run at the same time, and each is used
/// again. Fresh large memory costs the system more than most blocks' work.
template <class T>
class Pool {
 public:
  explicit Pool(std::function<std::unique_ptr<T>()> make) : make_(std::move(make)) {}

  /// A piece on loan until the end of its scope. What the last user left is still in it.
  class Loan {
   public:
    explicit Loan(Pool& pool) : pool_(pool), piece_(pool.take()) {}
    ~Loan() { pool_.give_back(std::move(piece_)); }
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;
    T& operator*() { return *piece_; }
    T* operator->() { return piece_.get(); }

   private:
    Pool& pool_;
    std::unique_ptr<T> piece_;
  };

 private:
  std::unique_ptr<T> take() {
    {
      const std::lock_guard lock(mutex_);
      if (!free_.empty()) {
        std::unique_ptr<T> piece = std::move(free_.back());
        free_.pop_back();
        return piece;
      }
    }
    return make_();
  }
  void give_back(std::unique_ptr<T> piece) {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(piece));
  }

  std::function<std::unique_ptr<T>()> make_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<T>> free_;
};

}  // namespace zonal
