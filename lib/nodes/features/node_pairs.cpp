#include "features/node_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "features/loop_section.hpp"

namespace quadrille::features {
namespace {

struct Pair {
  double distance = 0;
  int a = 0, b = 0;
  SectionPoint middle{};  ///< of boundary nodes: the middle of the boundary between them
};
using Pairs = std::vector<Pair>;

/// The pairs of nodes, nearest first; those of equal distance are in the order of i, then j. pair_of(i, j) returns the
/// pair of nodes i < j, or std::nullopt if they form no pair.
template <typename PairOf>
Pairs nearest_first(const FeatureState& state, const PairOf& pair_of) {
  Pairs pairs;
  for (int i = 0; i < static_cast<int>(state.nodes.size()); ++i)
    for (int j = i + 1; j < static_cast<int>(state.nodes.size()); ++j)
      if (const std::optional<Pair> pair = pair_of(i, j)) pairs.push_back(*pair);
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
  return pairs;
}

/// Decides the nearest class of equally distant pairs that changes any node; false if no class does. decide(first,
/// last, removed) decides one class: it returns whether nodes were changed and adds those to be removed to `removed`.
template <typename Decide>
bool decide_nearest(const Pairs& pairs, FeatureState& state, const Decide& decide) {
  for (auto first = pairs.begin(); first != pairs.end();) {
    const auto last =
        end_of_chained_ties(first, pairs.end(), state.tie, [](const Pair& pair) { return pair.distance; });
    std::vector<int> removed;
    const bool is_changed = decide(first, last, removed);
    remove_nodes(state, removed);
    if (is_changed) return true;
    first = last;
  }
  return false;
}

/// Whether the node, on the boundary, lies on a fillet that is a corner at this distance (feature_constants). Not nodes
/// of a small hole, which move with it.
bool is_on_corner_fillet(const CadFace& face, const FeatureNode& node, double distance) {
  if (node.is_inside() || node.hole) return false;
  return std::abs(curve::curvature(face.curves[node.curve], node.t)) * feature_constants.corner_radius * distance > 1;
}

/// Whether the node, inside, is so near to the boundary that it belongs to such a fillet.
bool is_beside_corner_fillet(const curve::FaceBoundary& boundary, const FeatureNode& node, double distance) {
  return node.is_inside() && boundary.nearest(node.position).distance < feature_constants.corner_clearance * distance;
}

bool do_see_each_other(const curve::FaceBoundary& boundary, const FeatureNode& a, const FeatureNode& b) {
  // If a node lies on the boundary, the segment starts a little inside.
  const Vec2 lift = 1e-3 * (b.position - a.position);
  return boundary.is_visible(a.is_inside() ? a.position : a.position + lift,
                             b.is_inside() ? b.position : b.position - lift);
}

/// Without the node, a side of a block would have a corner in it: its fillet is too small for the distance.
bool does_hold_corner(const curve::FaceBoundary& boundary, const FeatureNode& node, double distance) {
  return is_on_corner_fillet(boundary.face(), node, distance) || is_beside_corner_fillet(boundary, node, distance);
}

Pairs opposite_pairs(const FeatureState& state, const curve::FaceBoundary& boundary, double below) {
  return nearest_first(state, [&](int i, int j) -> std::optional<Pair> {
    const FeatureNode &a = state.nodes[i], &b = state.nodes[j];
    const double d = distance(a.position, b.position);
    if (d < below - state.tie && a.index() * b.index() < 0 && (a.is_inside() || b.is_inside()) &&
        !does_hold_corner(boundary, a, d) && !does_hold_corner(boundary, b, d) && do_see_each_other(boundary, a, b))
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
std::optional<FeatureNode> middle_of(const std::vector<FeatureNode>& members, const curve::FaceBoundary& boundary) {
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
  if (std::abs(index) != 1 || !boundary.is_visible(members.front().position, middle.position)) return std::nullopt;
  return middle;
}

/// Decides one set and appends the nodes that it removes to `removed`; false if the set stays unchanged.
bool cancel_set(FeatureState& state, const curve::FaceBoundary& boundary, const std::vector<int>& set,
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
  const std::optional<FeatureNode> middle = middle_of(before, boundary);
  if (!middle) return false;
  record(state, ChangeKind::cancel, before, {*middle},
         fmt::format("{}: one node of valence {} replaces them", why, middle->valence));
  state.nodes[set.front()] = *middle;
  removed.insert(removed.end(), set.begin() + 1, set.end());
  return true;
}

bool cancel_nearest(FeatureState& state, const curve::FaceBoundary& boundary, double below) {
  const auto cancel = [&](Pairs::const_iterator first, Pairs::const_iterator last, std::vector<int>& removed) {
    const std::string why =
        fmt::format("nodes of opposite index are {:.4g} apart, less than {:.4g} (feature size {:.4g})", first->distance,
                    below, state.size);
    bool is_done = false;
    for (const std::vector<int>& set : linked_sets(first, last))
      is_done |= cancel_set(state, boundary, set, why, removed);
    return is_done;
  };
  return decide_nearest(opposite_pairs(state, boundary, below), state, cancel);
}

/// A part of a whole loop, as fractions of its length: it starts at `first` and is `part` long.
struct LoopPart {
  double first = 0, part = 0;
};

bool has_corner(const CadFace& face, int loop, const LoopSection& whole, const LoopPart& between) {
  for (int j = face.loop_offsets[loop]; j < face.loop_offsets[loop + 1]; ++j) {
    if (!face.joints[j].is_corner) continue;
    const double at = whole.foot(face.joints[j].position).fraction - between.first;
    if (at - std::floor(at) <= between.part) return true;
  }
  return false;
}

/// The shorter part of the loop between the two points.
LoopPart shorter_part(const LoopSection& whole, Vec2 a, Vec2 b) {
  double first = whole.foot(a).fraction, part = whole.foot(b).fraction - first;
  part -= std::floor(part);
  if (part > 0.5) {
    first += part;
    part = 1 - part;
  }
  return {first, part};
}

std::optional<SectionPoint> middle_between(const CadFace& face, const FeatureNode& a, const FeatureNode& b) {
  const int loop = face.loop_of(a.curve);
  if (loop != face.loop_of(b.curve)) return {};
  const LoopSection whole = whole_loop(face, loop);
  const LoopPart between = shorter_part(whole, a.position, b.position);
  const double greatest = feature_constants.greatest_merge_detour * distance(a.position, b.position);
  if (between.part * whole.length() > greatest || has_corner(face, loop, whole, between)) return {};
  return whole.at(between.first + between.part / 2);
}

bool may_merge(const FeatureNode& a, const FeatureNode& b) {
  if (a.is_inside() || b.is_inside() || a.valence != 3 || b.valence != 3) return false;
  return !a.hole || a.hole != b.hole;
}

Pairs close_pairs(const CadFace& face, const FeatureState& state) {
  const auto pair_of = [&](int i, int j) -> std::optional<Pair> {
    const FeatureNode &a = state.nodes[i], &b = state.nodes[j];
    const double d = distance(a.position, b.position);
    if (!may_merge(a, b) || d >= feature_constants.spacing * state.size - state.tie) return std::nullopt;
    if (is_on_corner_fillet(face, a, d) || is_on_corner_fillet(face, b, d)) return std::nullopt;
    const auto middle = middle_between(face, a, b);
    return middle ? std::optional(Pair{d, i, j, *middle}) : std::nullopt;
  };
  return nearest_first(state, pair_of);
}

/// Replaces the first node of the pair by the merged one.
void merge(FeatureState& state, const Pair& pair) {
  const FeatureNode a = state.nodes[pair.a], b = state.nodes[pair.b];
  FeatureNode merged = a;
  merged.position = pair.middle.position;
  merged.curve = pair.middle.curve;
  merged.t = pair.middle.t;
  merged.valence = 4;
  merged.changed_by = ChangeKind::feature;
  record(
      state, ChangeKind::feature, {a, b}, {merged},
      fmt::format("two boundary nodes are {:.4g} apart, less than half the feature size, {:.4g}: one node of valence "
                  "4 replaces them",
                  pair.distance, feature_constants.spacing * state.size));
  state.nodes[pair.a] = merged;
}

/// Merges the pairs of a class that have no node in common with others of it.
bool merge_nearest(const CadFace& face, FeatureState& state) {
  const auto merge_class = [&](Pairs::const_iterator first, Pairs::const_iterator last, std::vector<int>& removed) {
    std::vector<int> uses(state.nodes.size());
    for (auto pair = first; pair != last; ++pair) ++uses[pair->a], ++uses[pair->b];
    for (; first != last; ++first) {
      if (uses[first->a] > 1 || uses[first->b] > 1) continue;
      merge(state, *first);
      removed.push_back(first->b);
    }
    return !removed.empty();
  };
  return decide_nearest(close_pairs(face, state), state, merge_class);
}

}  // namespace

void cancel_pairs(FeatureState& state, const curve::FaceBoundary& boundary, double below) {
  while (cancel_nearest(state, boundary, below)) {
  }
}

void merge_on_boundary(const CadFace& face, FeatureState& state) {
  while (merge_nearest(face, state)) {
  }
}

}  // namespace quadrille::features
