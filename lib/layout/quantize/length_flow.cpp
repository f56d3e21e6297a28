#include "quantize/length_flow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace quadrille::quantize {
namespace {

constexpr double step_cost = 1e-3;  // of each arc of a path: of equally good paths the shortest is taken

/// One of the two sides of a node (a pair of opposite sides of a face): number 2 node + which.
using Side = int;
Side opposite(Side side) { return side ^ 1; }

/// Where an arc lies: its sides, -1 where it has none.
using Ends = std::array<Side, 2>;

/// An arc becomes longer or shorter by 1.
struct Change {
  int arc = -1, by = 0;
};

class LengthFlow {
 public:
  LengthFlow(const std::vector<TFace>& faces, const std::vector<double>& targets)
      : targets_(targets), ends_(targets.size(), {-1, -1}), arcs_on_(4 * faces.size()), surplus_(2 * faces.size(), 0) {
    for (int f = 0; f < static_cast<int>(faces.size()); ++f)
      for (int k = 0; k < 4; ++k) {
        const Side side = 4 * f + 2 * (k % 2) + k / 2;
        for (const HalfEdge h : faces[f][k]) {
          ends_[h.arc][ends_[h.arc][0] < 0 ? 0 : 1] = side;
          arcs_on_[side].push_back(h.arc);
        }
      }
    for (const double target : targets) lengths_.push_back(std::max(1, static_cast<int>(std::lround(target))));
    for (std::size_t a = 0; a < ends_.size(); ++a)
      for (const Side side : ends_[a])
        if (side >= 0) add_surplus(side, lengths_[a]);
  }

  /// Balances all nodes; those that a strip without a way out contains remain as they are.
  FlowLengths balanced(const std::vector<TFace>& faces) {
    FlowLengths result;
    std::unordered_set<Side> enclosed;  // in a strip
    for (int node = 0; node < static_cast<int>(surplus_.size()); ++node)
      while (surplus_[node] != 0) {
        const Side start = 2 * node + (surplus_[node] > 0 ? 1 : 0);
        if (enclosed.contains(start)) break;
        if (augment(start)) continue;
        for (const auto& [side, label] : labels_) enclosed.insert(side);
        result.strips.push_back(arcs_along_labels(faces));
        break;
      }
    if (result.strips.empty()) result.lengths = lengths_;
    return result;
  }

 private:
  /// How a search has reached a side that must become longer by 1.
  struct Label {
    double cost = 0;
    Side from = -1;
    Change change;
    bool is_final = false;
  };

  void add_surplus(Side side, int by) { surplus_[side / 2] += side % 2 == 0 ? by : -by; }

  /// Of the longer side over the other one, 0 if it is not the longer.
  int excess(Side side) const { return std::max(0, side % 2 == 0 ? surplus_[side / 2] : -surplus_[side / 2]); }

  double cost_of(const Change& change) const {
    const double target = targets_[change.arc], before = lengths_[change.arc] - target, after = before + change.by;
    return std::max(0.0, (after * after - before * before) / std::max(target, 0.5)) + step_cost;
  }

  void apply(const Change& change, int sign) {
    lengths_[change.arc] += sign * change.by;
    for (const Side side : ends_[change.arc])
      if (side >= 0) add_surplus(side, sign * change.by);
  }

  /// The other side of an arc that lies on `side`; -1: it lies on the boundary.
  Side beyond(int arc, Side side) const { return ends_[arc][0] == side ? ends_[arc][1] : ends_[arc][0]; }

  /// Makes `start` longer by 1, or the side opposite to it shorter. A path may shorten an arc twice, so that its length
  /// would be 0: then that arc is not shortened, and another path is searched.
  bool augment(Side start) {
    std::vector<int> kept;
    for (;;) {
      const std::vector<Change> path = cheapest_path(start, kept);
      if (path.empty()) return false;
      for (const Change& change : path) apply(change, 1);
      const auto vanished =
          std::find_if(path.begin(), path.end(), [&](const Change& change) { return lengths_[change.arc] < 1; });
      if (vanished == path.end()) return true;
      kept.push_back(vanished->arc);
      for (const Change& change : path) apply(change, -1);
    }
  }

  /// Dijkstra's method over sides that must become longer. Empty if there is no path.
  std::vector<Change> cheapest_path(Side start, const std::vector<int>& kept) {
    labels_.clear();
    open_ = {};
    labels_[start] = {};
    open_.push({0, start});
    best_end_ = -1;
    while (!open_.empty()) {
      const auto [cost, side] = open_.top();
      open_.pop();
      if (best_end_ >= 0 && cost >= best_cost_) break;
      Label& label = labels_[side];
      if (label.is_final) continue;
      label.is_final = true;
      if (side != start && excess(side) > (side == opposite(start) ? 1 : 0)) return path_to(side, {});
      for (const int arc : arcs_on_[side]) reach(side, cost, {arc, 1}, beyond(arc, side), true);
      for (const int arc : arcs_on_[opposite(side)])
        if (lengths_[arc] > 1 && std::find(kept.begin(), kept.end(), arc) == kept.end())
          reach(side, cost, {arc, -1}, beyond(arc, opposite(side)), false);
    }
    return best_end_ < 0 ? std::vector<Change>() : path_to(best_end_, best_change_);
  }

  /// A change on one side of an arc must be made up for on its other side: where that becomes longer, the side opposite
  /// to it must, and where it becomes shorter, it must itself become longer again.
  void reach(Side from, double cost, const Change& change, Side other, bool is_longer) {
    cost += cost_of(change);
    if (other < 0) {
      if (best_end_ < 0 || cost < best_cost_) best_end_ = from, best_cost_ = cost, best_change_ = change;
      return;
    }
    const Side next = is_longer ? opposite(other) : other;
    const auto [at, is_new] = labels_.try_emplace(next);
    if (!is_new && (at->second.is_final || at->second.cost <= cost)) return;
    at->second = {cost, from, change, false};
    open_.push({cost, next});
  }

  /// Of the faces that the last search has reached, the arcs across the direction in which it did.
  std::vector<int> arcs_along_labels(const std::vector<TFace>& faces) const {
    std::set<int> along;
    for (const auto& [side, label] : labels_)
      for (const int k : {1, 3})
        for (const HalfEdge h : faces[side / 4][(side % 4 / 2 + k) % 4]) along.insert(h.arc);
    return {along.begin(), along.end()};
  }

  std::vector<Change> path_to(Side side, const Change& last) const {
    std::vector<Change> path;
    if (last.arc >= 0) path.push_back(last);
    for (const Label* label = &labels_.at(side); label->from >= 0; label = &labels_.at(label->from))
      path.push_back(label->change);
    return path;
  }

  const std::vector<double>& targets_;
  std::vector<Ends> ends_;
  std::vector<std::vector<int>> arcs_on_;  // each side
  std::vector<int> surplus_;               // of each node: of its side 0 over its side 1
  std::vector<int> lengths_;

  // The search.
  std::unordered_map<Side, Label> labels_;
  std::priority_queue<std::pair<double, Side>, std::vector<std::pair<double, Side>>, std::greater<>> open_;
  Side best_end_ = -1;  // of a path to the boundary
  double best_cost_ = 0;
  Change best_change_;
};

}  // namespace

FlowLengths flow_lengths(const std::vector<TFace>& faces, const std::vector<double>& targets) {
  return LengthFlow(faces, targets).balanced(faces);
}

}  // namespace quadrille::quantize
