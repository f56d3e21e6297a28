#include "features/feature_cancel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <set>
#include <utility>

namespace quadrille::features {
namespace {

struct Pair {
  double distance = 0;
  int a = 0, b = 0;
};

bool are_visible(const Walls& walls, const FeatureNode& a, const FeatureNode& b) {
  // A boundary node lies on a wall: look at it from inside.
  const Vec2 lift = 1e-3 * (b.position - a.position);
  return walls.sees(a.is_inside() ? a.position : a.position + lift, b.is_inside() ? b.position : b.position - lift);
}

std::vector<Pair> opposite_pairs(const FeatureNodes& state, const Walls& walls, double below) {
  std::vector<Pair> pairs;
  const int n = static_cast<int>(state.nodes.size());
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) {
      const FeatureNode &a = state.nodes[i], &b = state.nodes[j];
      const double d = distance(a.position, b.position);
      if (d < below - state.tie && a.index() * b.index() < 0 && (a.is_inside() || b.is_inside()) &&
          are_visible(walls, a, b))
        pairs.push_back({d, i, j});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
  return pairs;
}

/// What pairs [first, last) link, each set in ascending sequence.
std::vector<std::vector<int>> linked(const std::vector<Pair>& pairs, size_t first, size_t last) {
  std::vector<std::vector<int>> sets;
  const auto set_of = [&](int node) {
    for (size_t s = 0; s < sets.size(); ++s) {
      if (std::find(sets[s].begin(), sets[s].end(), node) != sets[s].end()) return s;
    }
    sets.push_back({node});
    return sets.size() - 1;
  };
  for (size_t p = first; p < last; ++p) {
    const size_t a = set_of(pairs[p].a), b = set_of(pairs[p].b);
    if (a == b) continue;
    sets[a].insert(sets[a].end(), sets[b].begin(), sets[b].end());
    sets.erase(sets.begin() + static_cast<std::ptrdiff_t>(b));
  }
  for (std::vector<int>& set : sets) std::sort(set.begin(), set.end());
  return sets;
}

/// The node that stands for `members`, or none (no valence) where they are to stay.
FeatureNode middle_of(const std::vector<FeatureNode>& members, const Walls& walls) {
  FeatureNode middle = members.front();
  Vec2 sum;
  int index = 0;
  for (const FeatureNode& node : members) {
    if (!node.is_inside()) return {};
    sum += node.position;
    index += node.index();
  }
  middle.position = sum / static_cast<double>(members.size());
  middle.valence = 4 - index;
  middle.hole = -1;
  middle.changed_by = ChangeKind::cancel;
  return std::abs(index) == 1 && walls.sees(members.front().position, middle.position) ? middle : FeatureNode{};
}

/// Marks what goes with valence 4; whether anything was done.
bool resolve(FeatureNodes& state, const Walls& walls, const std::vector<int>& set, double nearest, double below) {
  std::vector<FeatureNode> before, after;
  int index = 0;
  for (const int i : set) {
    before.push_back(state.nodes[i]);
    index += state.nodes[i].index();
  }
  if (index != 0) {
    after.push_back(middle_of(before, walls));
    if (after.front().valence == 4) return false;
  }
  const std::string outcome = index == 0 ? "cancel" : fmt::format("become one of valence {}", 4 - index);
  record(state, ChangeKind::cancel, before, after,
         fmt::format("nodes of opposite index {:.4g} apart, nearer than {:.4g} (feature size {:.4g}), {}", nearest,
                     below, state.size, outcome));
  for (const int i : set) {
    state.nodes[i].curve = -1;
    state.nodes[i].valence = 4;
  }
  if (index != 0) state.nodes[set.front()] = after.front();
  return true;
}

/// The nearest class of pairs of which some set can be resolved; false: there is none.
bool cancel_nearest(FeatureNodes& state, const Walls& walls, double below) {
  const std::vector<Pair> pairs = opposite_pairs(state, walls, below);
  for (size_t first = 0; first < pairs.size();) {
    size_t last = first + 1;
    while (last < pairs.size() && pairs[last].distance - pairs[last - 1].distance <= state.tie) ++last;
    bool is_done = false;
    for (const std::vector<int>& set : linked(pairs, first, last))
      is_done |= resolve(state, walls, set, pairs[first].distance, below);
    drop_regular(state);
    if (is_done) return true;
    first = last;
  }
  return false;
}

}  // namespace

void cancel_pairs(FeatureNodes& state, const Walls& walls, double below) {
  while (cancel_nearest(state, walls, below)) {
  }
}

}  // namespace quadrille::features
