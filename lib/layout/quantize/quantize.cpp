#include "quantize/quantize.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <queue>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "graph/candidate_layout.hpp"
#include "quantize/integer_program.hpp"
#include "surface/positions.hpp"

namespace quadrille::quantize {
namespace {

TFace sides_of(const graph::Subdivision& subdivision, int f) {
  const std::vector<HalfEdge> cycle = subdivision.cycle(f);
  const auto is_corner = [&](HalfEdge h) { return subdivision.quarters(h) == 1; };
  if (subdivision.num_corners(f) != 4 || !std::all_of(cycle.begin(), cycle.end(), [&](HalfEdge h) {
        return is_corner(h) || subdivision.quarters(h) == 2;
      }))
    throw ComputeError(
        fmt::format("the face of the T-mesh around {} is not four-sided: {} arcs, {} corners",
                    surface::position_text(subdivision.graph().face, graph::middle_of_face(subdivision, f)),
                    cycle.size(), subdivision.num_corners(f)));
  const size_t n = cycle.size();
  size_t first = 0;  // the half-edge after a corner
  while (!is_corner(cycle[(first + n - 1) % n])) ++first;
  TFace face;
  int side = 0;
  for (size_t k = 0; k < n; ++k) {
    const HalfEdge h = cycle[(first + k) % n];
    face[side].push_back(h);
    if (is_corner(h)) ++side;
  }
  return face;
}

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

using Term = IntegerProgram::Term;

constexpr double max_length = 1e4;  // of one arc
constexpr int max_pieces = 60;      // of a cost function
// The time that the integer program takes grows faster than the number of arcs.
constexpr int max_program_arcs = 2000;

void add_face_equations(const std::vector<TFace>& faces, IntegerProgram& program) {
  for (const TFace& face : faces)
    for (const int k : {0, 1}) {
      std::vector<Term> terms;
      for (const HalfEdge h : face[k]) terms.push_back({h.arc, 1});
      for (const HalfEdge h : face[k + 2]) terms.push_back({h.arc, -1});
      program.add_equation(terms, 0);
    }
}

// n = 1 + y_2 + y_3 + ..., 0 <= y_k <= 1, where y_k has the cost of the step from k - 1 to k.
void add_deviation(IntegerProgram& program, int variable, double target) {
  std::vector<Term> terms{{variable, 1}};
  const int last = std::clamp(static_cast<int>(std::ceil(2 * target)) + 4, 4, max_pieces);
  for (int k = 2; k <= last; ++k) {
    const double cost = (2 * k - 1 - 2 * target) / std::max(target, 0.5);
    terms.push_back({program.add_variable(0, k < last ? 1 : max_length, cost, false), -1});
  }
  program.add_equation(terms, 1);
}

// Arcs of one symmetry orbit have one length in the plane: they are assigned the same integer length.
void add_ties(const std::vector<double>& arc_lengths, IntegerProgram& program) {
  std::vector<int> by_length(arc_lengths.size());
  std::iota(by_length.begin(), by_length.end(), 0);
  std::stable_sort(by_length.begin(), by_length.end(), [&](int a, int b) { return arc_lengths[a] < arc_lengths[b]; });
  for (size_t k = 0; k + 1 < by_length.size(); ++k) {
    const int a = by_length[k], b = by_length[k + 1];
    if (arc_lengths[b] - arc_lengths[a] <= tolerance::tied * arc_lengths[b]) program.add_equation({{a, 1}, {b, -1}}, 0);
  }
}

std::vector<int> solve(const std::vector<TFace>& faces, const std::vector<double>& arc_lengths, double unit,
                       bool ties) {
  const int num_arcs = static_cast<int>(arc_lengths.size());
  IntegerProgram program;
  for (int a = 0; a < num_arcs; ++a) program.add_variable(1, max_length, 0, true);
  add_face_equations(faces, program);
  if (ties) add_ties(arc_lengths, program);
  for (int a = 0; a < num_arcs; ++a) add_deviation(program, a, arc_lengths[a] / unit);
  std::vector<int> lengths;
  const std::vector<double> solution = program.solve();
  if (!solution.empty())
    for (int a = 0; a < num_arcs; ++a) lengths.push_back(static_cast<int>(std::lround(solution[a])));
  return lengths;
}

}  // namespace

std::vector<TFace> t_mesh_faces(const graph::Subdivision& subdivision) {
  std::vector<TFace> all;
  for (int f = 0; f < subdivision.face_bound(); ++f) all.push_back(sides_of(subdivision, f));
  if (subdivision.num_components() > subdivision.graph().face.num_regions())
    throw ComputeError(fmt::format("the T-mesh has {} unconnected parts", subdivision.num_components()));
  return all;
}

FlowLengths flow_lengths(const std::vector<TFace>& faces, const std::vector<double>& targets) {
  return LengthFlow(faces, targets).balanced(faces);
}

std::vector<int> quantize(const std::vector<TFace>& faces, const std::vector<double>& arc_lengths, double unit) {
  std::vector<int> lengths = solve(faces, arc_lengths, unit, true);
  return lengths.empty() ? solve(faces, arc_lengths, unit, false) : lengths;
}

Quantization quantize_or_explain(const std::vector<TFace>& faces, const std::vector<double>& arc_lengths, double unit) {
  const int num_arcs = static_cast<int>(arc_lengths.size());
  if (num_arcs > max_program_arcs) {
    std::vector<double> targets;
    for (const double length : arc_lengths) targets.push_back(length / unit);
    FlowLengths found = flow_lengths(faces, targets);
    return {std::move(found.lengths), std::move(found.strips)};
  }
  Quantization result{quantize(faces, arc_lengths, unit), {}};
  if (!result.lengths.empty()) return result;
  if (const std::vector<int> zero_arcs = forced_zero_arcs(faces, num_arcs); !zero_arcs.empty())
    result.strips.push_back(infeasibility_certificate(faces, num_arcs, zero_arcs.front()));
  return result;
}

// The equations are homogeneous: all arcs that can be positive can be 1 or more at once.
std::vector<int> forced_zero_arcs(const std::vector<TFace>& faces, int num_arcs) {
  IntegerProgram program;
  for (int a = 0; a < num_arcs; ++a) program.add_variable(0, max_length, 0, false);
  add_face_equations(faces, program);
  std::vector<int> positive;  // variables min(length, 1)
  for (int a = 0; a < num_arcs; ++a) {
    positive.push_back(program.add_variable(0, 1, -1, false));
    const int rest = program.add_variable(0, max_length, 0, false);
    program.add_equation({{a, 1}, {positive.back(), -1}, {rest, -1}}, 0);
  }
  const std::vector<double> solution = program.solve();
  std::vector<int> zero;
  for (int a = 0; a < num_arcs; ++a)
    if (solution.empty() || solution[positive[a]] < 0.5) zero.push_back(a);
  return zero;
}

std::vector<int> infeasibility_certificate(const std::vector<TFace>& faces, int num_arcs, int zero_arc) {
  IntegerProgram program;
  std::vector<std::vector<Term>> column(num_arcs);  // of the equations' matrix
  for (int f = 0; f < static_cast<int>(faces.size()); ++f)
    for (const int k : {0, 1}) {
      const int plus = program.add_variable(0, max_length, 1, false);
      const int minus = program.add_variable(0, max_length, 1, false);
      for (const int side : {k, k + 2})
        for (const HalfEdge h : faces[f][side]) {
          const double sign = side == k ? 1 : -1;
          column[h.arc].push_back({plus, sign});
          column[h.arc].push_back({minus, -sign});
        }
    }
  for (int a = 0; a < num_arcs; ++a) {
    column[a].push_back({program.add_variable(0, max_length, 0, false), -1});
    program.add_equation(column[a], a == zero_arc ? 1 : 0);
  }
  const std::vector<double> solution = program.solve();
  std::set<int> along;  // arcs along the strip
  if (solution.empty()) return {};
  for (size_t e = 0; e < 2 * faces.size(); ++e) {
    if (solution[2 * e] + solution[2 * e + 1] < tolerance::tied) continue;
    for (const size_t side : {e % 2 + 1, (e % 2 + 3) % 4})
      for (const HalfEdge h : faces[e / 2][side]) along.insert(h.arc);
  }
  return {along.begin(), along.end()};
}

}  // namespace quadrille::quantize
