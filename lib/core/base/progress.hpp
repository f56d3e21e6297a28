#pragma once
// How far a run is, for people who wait: counted by the computations, shown by another thread (cli/progress_line).
// Nothing that is computed depends on it.

#include <array>
#include <atomic>
#include <optional>
#include <vector>

namespace quadrille {

/// The parts of the present phase that are under way, each inside the one before: "solutions", "elements". Without
/// locks, since a process may be forked meanwhile. Counting costs as much as an atomic addition.
class Progress {
 public:
  /// What is known of the number of steps of a part.
  enum class Total { exact, bound, unknown };

  /// A part, from the construction of this object to its destruction, which are on the thread that began the parts
  /// around it. Without a Progress, nothing is counted.
  class Part {
   public:
    /// `name` is a string literal, `total` the number of steps or, with Total::bound, the most there can be. A total of
    /// 0 is unknown.
    Part(Progress* progress, const char* name, long long total = 0, Total kind = Total::exact);
    ~Part();
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

    /// Counts steps as done; any thread may call this.
    void advance(long long steps = 1) const {
      if (done_ != nullptr) done_->fetch_add(steps, std::memory_order_relaxed);
    }

   private:
    Progress* progress_;
    std::atomic<long long>* done_ = nullptr;  ///< null: not counted
  };

  struct Count {
    const char* name = nullptr;
    long long done = 0, total = 0;
    Total kind = Total::unknown;
  };
  /// The parts under way, the outermost first, for any thread; std::nullopt while one begins or ends.
  std::optional<std::vector<Count>> counts() const;

 private:
  static constexpr int max_depth = 4;  // deeper parts are not counted
  struct Level {
    std::atomic<const char*> name = nullptr;
    std::atomic<long long> done = 0, total = 0;
    std::atomic<Total> kind = Total::unknown;
  };
  std::atomic<unsigned> changes_ = 0;  ///< of the parts under way: odd while one begins or ends
  std::atomic<int> depth_ = 0;
  std::array<Level, max_depth> levels_;
};

}  // namespace quadrille
