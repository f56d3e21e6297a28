#include "base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace quadrille {

namespace {

// Chunks of indices, handed out in ascending order: when f(i) throws, all lower indices have been handed out already.
class Loop {
 public:
  Loop(int n, const std::function<void(int)>& f) : n_(n), chunk_(std::max(1, n / 256)), f_(f) {}

  void run() {
    while (!failed_) {
      const int begin = next_.fetch_add(chunk_);
      if (begin >= n_) return;
      run_chunk(begin, std::min(n_, begin + chunk_));
    }
  }
  void rethrow() const {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  void run_chunk(int begin, int end) {
    int i = begin;
    try {
      for (; i < end; ++i) f_(i);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      failed_ = true;
      if (exception_ && i > where_) return;
      exception_ = std::current_exception();
      where_ = i;
    }
  }

  const int n_, chunk_;
  const std::function<void(int)>& f_;
  std::atomic<int> next_ = 0;
  std::atomic<bool> failed_ = false;
  std::mutex mutex_;
  std::exception_ptr exception_;
  int where_ = 0;  ///< the index for which f threw exception_
};

}  // namespace

void parallel_for(int n, int num_threads, const std::function<void(int)>& f) {
  num_threads = std::min(num_threads, n);
  if (num_threads <= 1) {
    for (int i = 0; i < n; ++i) f(i);
    return;
  }
  Loop loop(n, f);
  std::vector<std::jthread> helpers;
  for (int i = 1; i < num_threads; ++i) helpers.emplace_back([&loop] { loop.run(); });
  loop.run();
  helpers.clear();  // joins
  loop.rethrow();
}

}  // namespace quadrille
