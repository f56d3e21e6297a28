#include "quantize/motorcycle.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <utility>

namespace quadrille::quantize {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

struct Front {
  int trail = 0;
  bool backwards = false;
  bool stopped = false;
};

/// A front comes to a crossing as its trail `side` (0: Crossing::a, 1: b).
struct Arrival {
  double time = 0;
  int front = 0, crossing = 0, side = 0;
};

class Race {
 public:
  Race(const std::vector<Trail>& trails, const std::vector<graph::Crossing>& crossings, double tie)
      : crossings_(crossings), tie_(tie), laid_(crossings.size(), {never, never}) {
    for (int i = 0; i < static_cast<int>(trails.size()); ++i) {
      covered.push_back({never, trails[i].length});
      first_front_.push_back(static_cast<int>(fronts_.size()));
      fronts_.push_back({i, false, false});
      if (trails[i].from_both_ends) fronts_.push_back({i, true, false});
    }
    first_front_.push_back(static_cast<int>(fronts_.size()));
    for (int c = 0; c < static_cast<int>(crossings.size()); ++c) {
      add_arrivals(trails, crossings[c].a, crossings[c].s, c, 0);
      add_arrivals(trails, crossings[c].b, crossings[c].t, c, 1);
    }
  }

  void run() {
    std::stable_sort(arrivals_.begin(), arrivals_.end(),
                     [](const Arrival& a, const Arrival& b) { return a.time < b.time; });
    for (const Arrival& arrival : arrivals_)
      if (!fronts_[arrival.front].stopped) arrive(arrival);
  }

  std::vector<Covered> covered;

 private:
  void add_arrivals(const std::vector<Trail>& trails, int trail, double s, int crossing, int side) {
    for (int f = first_front_[trail]; f < first_front_[trail + 1]; ++f) {
      const double way = fronts_[f].backwards ? trails[trail].length - s : s;
      arrivals_.push_back({way - trails[trail].head_start, f, crossing, side});
    }
  }

  void arrive(const Arrival& arrival) {
    std::array<double, 2>& laid = laid_[arrival.crossing];
    if (laid[arrival.side] < never) return meet(fronts_[arrival.front]);
    laid[arrival.side] = arrival.time;
    if (laid[1 - arrival.side] < never && !passes_tie(arrival, laid[1 - arrival.side])) stop(arrival);
  }

  // The front that comes the other way has been here.
  void meet(Front& front) {
    front.stopped = true;
    covered[front.trail].first = never;
  }

  void stop(const Arrival& arrival) {
    Front& front = fronts_[arrival.front];
    front.stopped = true;
    const graph::Crossing& c = crossings_[arrival.crossing];
    Covered& part = covered[front.trail];
    (front.backwards ? part.last : part.first) = arrival.side == 0 ? c.s : c.t;
    const bool is_alone = first_front_[front.trail + 1] - first_front_[front.trail] == 1;
    if (is_alone) part.last = never;
  }

  bool passes_tie(const Arrival& arrival, double before) {
    const graph::Crossing& c = crossings_[arrival.crossing];
    return arrival.time - before <= tie_ && c.a != c.b && tied_.insert({c.a, c.b}).second;
  }

  const std::vector<graph::Crossing>& crossings_;
  double tie_;
  std::vector<Front> fronts_;
  std::vector<int> first_front_;  // of each trail, and the end
  std::vector<Arrival> arrivals_;
  std::vector<std::array<double, 2>> laid_;  // when each of the two trails of a crossing came to it
  std::set<std::pair<int, int>> tied_;
};

}  // namespace

std::vector<Covered> race(const std::vector<Trail>& trails, const std::vector<graph::Crossing>& crossings, double tie) {
  Race race(trails, crossings, tie);
  race.run();
  return std::move(race.covered);
}

}  // namespace quadrille::quantize
