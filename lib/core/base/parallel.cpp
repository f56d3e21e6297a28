#include "base/parallel.hpp"

#include <sched.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <fstream>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "base/stopwatch.hpp"

namespace quadrille {

namespace {

// Many times what the start of a thread costs. A loop starts its k-th further thread after k such times.
constexpr double seconds_per_start = 5e-4;

double least_cpu_seconds = -1;  // of start_threads_after; negative: it was not called

// Chunks of indices, handed out in ascending order: when f(i) throws, all lower indices have been handed out already.
class Loop {
 public:
  Loop(int n, const std::function<void(int)>& f) : n_(n), chunk_(std::max(1, n / 256)), f_(f) {}

  void run() {
    while (run_next_chunk()) {
    }
  }
  /// False if there is nothing left to do.
  bool run_next_chunk() {
    if (failed_) return false;
    const int begin = next_.fetch_add(chunk_);
    if (begin >= n_) return false;
    run_chunk(begin, std::min(n_, begin + chunk_));
    return next_ < n_;
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

/// Further threads for a loop, up to a number, as it lasts.
class Helpers {
 public:
  Helpers(Loop& loop, int greatest_number) : loop_(&loop), greatest_number_(greatest_number) {
    while (least_cpu_seconds < 0 && can_start()) start();
  }

  /// Starts a thread if that is worth it; called by the thread that runs the loop, between its chunks.
  void start_if_due() {
    if (can_start() && is_due()) start();
  }

 private:
  bool can_start() const { return static_cast<int>(threads_.size()) < greatest_number_; }
  bool is_due() const {
    const double lasted = seconds_of(CLOCK_MONOTONIC) - begin_;
    return lasted > seconds_per_start * static_cast<double>(threads_.size() + 1) &&
           seconds_of(CLOCK_PROCESS_CPUTIME_ID) > least_cpu_seconds;
  }
  void start() {
    try {
      threads_.emplace_back([loop = loop_] { loop->run(); });
    } catch (const std::system_error&) {
      greatest_number_ = 0;  // no more can be had (a limit of processes or memory): those that there are do the work
    }
  }

  Loop* loop_;
  int greatest_number_;
  double begin_ = seconds_of(CLOCK_MONOTONIC);
  std::vector<std::jthread> threads_;
};

int processors_of_affinity() {
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) == 0) return CPU_COUNT(&set);
  return static_cast<int>(std::thread::hardware_concurrency());  // more processors than fit into a set; 0: unknown
}

/// Of /proc/self/cgroup: the line "0::/path" is that of version 2.
std::string own_control_group() {
  std::ifstream file("/proc/self/cgroup");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("0::/")) return line.substr(3);
  return "/";
}

}  // namespace

void start_threads_after(double cpu_seconds) { least_cpu_seconds = cpu_seconds; }

void parallel_for(int n, int num_threads, const std::function<void(int)>& f) {
  num_threads = std::min(num_threads, n);
  if (num_threads <= 1) {
    for (int i = 0; i < n; ++i) f(i);
    return;
  }
  Loop loop(n, f);
  {
    Helpers helpers(loop, num_threads - 1);
    while (loop.run_next_chunk()) helpers.start_if_due();
  }  // joins
  loop.rethrow();
}

int quota_of_control_group(const std::string& mount, const std::string& group) {
  int least = 0;
  for (std::string path = group;; path.resize(path.rfind('/'))) {
    double quota = 0, period = 0;
    std::ifstream file(mount + path + "/cpu.max");  // "max" is no number: there is no quota then
    if (file >> quota >> period && quota > 0 && period > 0) {
      const int processors = static_cast<int>(std::ceil(std::min(quota / period, 1e6)));
      least = least == 0 ? processors : std::min(least, processors);
    }
    if (path.find('/') == std::string::npos) return least;
  }
}

int available_processors() {
  const int allowed = std::max(1, processors_of_affinity());
  const int quota = quota_of_control_group("/sys/fs/cgroup", own_control_group());
  return quota > 0 ? std::min(allowed, quota) : allowed;
}

}  // namespace quadrille
