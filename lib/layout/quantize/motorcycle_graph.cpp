#include "quantize/motorcycle_graph.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace quadrille::quantize {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

struct Front {
  int trail = 0;
  bool is_backwards = false;
  bool is_stopped = false;
};

/// A front reaches a crossing on its trail, number `side` of the two (0: Crossing::a, 1: b).
struct Arrival {
  double time = 0;
  int front = 0, crossing = 0, side = 0;
};

/// The fronts of all trails; trail i has the fronts first[i] ... first[i + 1] - 1.
struct Fronts {
  std::vector<Front> all;
  std::vector<int> first;
};

Fronts fronts_of(const std::vector<MotorcycleTrail>& trails) {
  Fronts fronts;
  for (int i = 0; i < static_cast<int>(trails.size()); ++i) {
    fronts.first.push_back(static_cast<int>(fronts.all.size()));
    fronts.all.push_back({i, false, false});
    if (trails[i].from_both_ends) fronts.all.push_back({i, true, false});
  }
  fronts.first.push_back(static_cast<int>(fronts.all.size()));
  return fronts;
}

// All arrivals if no front were stopped, by time.
std::vector<Arrival> arrivals_of(const std::vector<MotorcycleTrail>& trails, const Fronts& fronts,
                                 const std::vector<graph::Crossing>& crossings) {
  std::vector<Arrival> arrivals;
  for (int c = 0; c < static_cast<int>(crossings.size()); ++c)
    for (const int side : {0, 1}) {
      const int trail = side == 0 ? crossings[c].a : crossings[c].b;
      const double s = side == 0 ? crossings[c].s : crossings[c].t;
      for (int f = fronts.first[trail]; f < fronts.first[trail + 1]; ++f) {
        const double travelled = fronts.all[f].is_backwards ? trails[trail].length - s : s;
        arrivals.push_back({travelled - trails[trail].head_start, f, c, side});
      }
    }
  std::stable_sort(arrivals.begin(), arrivals.end(),
                   [](const Arrival& a, const Arrival& b) { return a.time < b.time; });
  return arrivals;
}

class Propagation {
 public:
  Propagation(const std::vector<MotorcycleTrail>& trails, const std::vector<graph::Crossing>& crossings, double tie)
      : crossings_(crossings), tie_(tie), fronts_(fronts_of(trails)), passed_at_(crossings.size(), {never, never}) {
    for (const MotorcycleTrail& trail : trails) covered.push_back({never, trail.length});
  }

  void process(const Arrival& arrival) {
    Front& front = fronts_.all[arrival.front];
    if (front.is_stopped) return;
    std::array<double, 2>& passed_at = passed_at_[arrival.crossing];
    if (passed_at[arrival.side] < never) {  // by the front from the other end: they meet
      front.is_stopped = true;
      covered[front.trail].first = never;
      return;
    }
    passed_at[arrival.side] = arrival.time;
    if (passed_at[1 - arrival.side] < never && !passes_tie(arrival, passed_at[1 - arrival.side])) stop(arrival);
  }

  const Fronts& fronts() const { return fronts_; }

  std::vector<CoveredPart> covered;

 private:
  void stop(const Arrival& arrival) {
    Front& front = fronts_.all[arrival.front];
    front.is_stopped = true;
    const graph::Crossing& c = crossings_[arrival.crossing];
    CoveredPart& part = covered[front.trail];
    (front.is_backwards ? part.last : part.first) = arrival.side == 0 ? c.s : c.t;
    const bool is_alone = fronts_.first[front.trail + 1] - fronts_.first[front.trail] == 1;
    if (is_alone) part.last = never;
  }

  bool passes_tie(const Arrival& arrival, double before) {
    const graph::Crossing& c = crossings_[arrival.crossing];
    return arrival.time - before <= tie_ && c.a != c.b && tied_.insert({c.a, c.b}).second;
  }

  const std::vector<graph::Crossing>& crossings_;
  double tie_;
  Fronts fronts_;
  std::vector<std::array<double, 2>> passed_at_;  // when each of the two trails of a crossing reached it
  std::set<std::pair<int, int>> tied_;
};

}  // namespace

std::vector<CoveredPart> trace_motorcycle_graph(const std::vector<MotorcycleTrail>& trails,
                                                const std::vector<graph::Crossing>& crossings, double tie) {
  Propagation propagation(trails, crossings, tie);
  for (const Arrival& arrival : arrivals_of(trails, propagation.fronts(), crossings)) propagation.process(arrival);
  return std::move(propagation.covered);
}

}  // namespace quadrille::quantize
