#include "features/cancel_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "base/tolerance.hpp"
#include "features/acts_as_corner.hpp"
#include "features/nearest_first.hpp"

namespace quadrille::features {
namespace {

struct Pair {
  double distance = 0;
  int a = 0, b = 0;
};

using Pairs = std::vector<Pair>;

bool do_see_each_other(const BoundaryClearance& clearance, const FeatureNode& a, const FeatureNode& b) {
  // If a node lies on the boundary, the segment starts a little inside.
  const Vec2 lift = 1e-3 * (b.position - a.position);
  return clearance.is_segment_inside(a.is_inside() ? a.position : a.position + lift,
                                     b.is_inside() ? b.position : b.position - lift);
}

/// Without the node, a side of a block would have a corner in it: its fillet is too small for the distance.
bool does_hold_corner(const CadFace& face, const BoundaryClearance& clearance, const FeatureNode& node,
                      double distance) {
  return is_on_corner_fillet(face, node, distance) || is_beside_corner_fillet(clearance, node, distance);
}

Pairs opposite_pairs(const CadFace& face, const FeatureState& state, const BoundaryClearance& clearance, double below) {
  return nearest_first<Pair>(static_cast<int>(state.nodes.size()), [&](int i, int j) -> std::optional<Pair> {
    const FeatureNode &a = state.nodes[i], &b = state.nodes[j];
    const double d = distance(a.position, b.position);
    if (d < below - state.tie && a.index() * b.index() < 0 && (a.is_inside() || b.is_inside()) &&
        !does_hold_corner(face, clearance, a, d) && !does_hold_corner(face, clearance, b, d) &&
        do_see_each_other(clearance, a, b))
      return Pair{d, i, j};
    return std::nullopt;
  });
}

/// The sets of nodes that the pairs [first, last) link, each in ascending order.
std::vector<std::vector<int>> linked_sets(Pairs::const_iterator first, Pairs::const_iterator last) {
  std::vector<std::vector<int>> sets;
  const auto set_of = [&](int node) {
    for (size_t s = 0; s < sets.size(); ++s) {
      if (std::find(sets[s].begin(), sets[s].end(), node) != sets[s].end()) return s;
    }
    sets.push_back({node});
    return sets.size() - 1;
  };
  for (; first != last; ++first) {
    const size_t a = set_of(first->a), b = set_of(first->b);
    if (a == b) continue;
    sets[a].insert(sets[a].end(), sets[b].begin(), sets[b].end());
    sets.erase(sets.begin() + static_cast<std::ptrdiff_t>(b));
  }
  for (std::vector<int>& set : sets) std::sort(set.begin(), set.end());
  return sets;
}

/// The node of index 1 or -1 that replaces the members; std::nullopt if they must stay.
std::optional<FeatureNode> middle_of(const std::vector<FeatureNode>& members, const BoundaryClearance& clearance) {
  FeatureNode middle = members.front();
  Vec2 sum;
  int index = 0;
  for (const FeatureNode& node : members) {
    if (!node.is_inside()) return std::nullopt;
    sum += node.position;
    index += node.index();
  }
  middle.position = sum / static_cast<double>(members.size());
  middle.valence = 4 - index;
  middle.hole.reset();
  middle.changed_by = ChangeKind::cancel;
  if (std::abs(index) != 1 || !clearance.is_segment_inside(members.front().position, middle.position))
    return std::nullopt;
  return middle;
}

/// Decides one set and appends the nodes that it removes to `removed`; false if the set stays unchanged.
bool cancel_set(FeatureState& state, const BoundaryClearance& clearance, const std::vector<int>& set,
                const std::string& why, std::vector<int>& removed) {
  std::vector<FeatureNode> before;
  int index = 0;
  for (const int i : set) {
    before.push_back(state.nodes[i]);
    index += before.back().index();
  }
  if (index == 0) {
    record(state, ChangeKind::cancel, before, {}, why + ": they cancel");
    removed.insert(removed.end(), set.begin(), set.end());
    return true;
  }
  const std::optional<FeatureNode> middle = middle_of(before, clearance);
  if (!middle) return false;
  record(state, ChangeKind::cancel, before, {*middle},
         fmt::format("{}: one node of valence {} replaces them", why, middle->valence));
  state.nodes[set.front()] = *middle;
  removed.insert(removed.end(), set.begin() + 1, set.end());
  return true;
}

/// Decides the nearest class of pairs that changes any node; false if no class changes a node.
bool cancel_nearest(const CadFace& face, FeatureState& state, const BoundaryClearance& clearance, double below) {
  const Pairs pairs = opposite_pairs(face, state, clearance, below);
  const auto distance_of = [](const Pair& pair) { return pair.distance; };
  for (auto first = pairs.begin(); first != pairs.end();) {
    const auto last = end_of_chained_ties(first, pairs.end(), state.tie, distance_of);
    const std::string why =
        fmt::format("nodes of opposite index are {:.4g} apart, less than {:.4g} (feature size {:.4g})", first->distance,
                    below, state.size);
    bool is_done = false;
    std::vector<int> removed;
    for (const std::vector<int>& set : linked_sets(first, last))
      is_done |= cancel_set(state, clearance, set, why, removed);
    remove_nodes(state, removed);
    if (is_done) return true;
    first = last;
  }
  return false;
}

}  // namespace

void cancel_pairs(const CadFace& face, FeatureState& state, const BoundaryClearance& clearance, double below) {
  while (cancel_nearest(face, state, clearance, below)) {
  }
}

}  // namespace quadrille::features
