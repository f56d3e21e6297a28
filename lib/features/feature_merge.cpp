#include "features/feature_merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "features/feature_stretch.hpp"

namespace quadrille::features {
namespace {

struct BoundaryPair {
  double distance = 0;
  int a = 0, b = 0;
  BoundaryPlace middle;
};

Stretch whole_loop(const CadFace& face, int loop) {
  std::vector<CurvePart> parts;
  for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c)
    parts.push_back({c, face.curves[c].begin(), face.curves[c].end()});
  return {face, parts, true};
}

/// Whether a corner of the loop lies on it from `first` on, a share `part` of it long.
bool has_corner(const CadFace& face, int loop, const Stretch& whole, double first, double part) {
  for (int j = face.loop_offsets[loop]; j < face.loop_offsets[loop + 1]; ++j) {
    if (!face.joints[j].is_corner) continue;
    const double at = whole.foot(face.joints[j].position).fraction - first;
    if (at - std::floor(at) <= part) return true;
  }
  return false;
}

std::optional<BoundaryPlace> middle_between(const CadFace& face, const FeatureNode& a, const FeatureNode& b) {
  const int loop = face.loop_of(a.curve);
  if (loop != face.loop_of(b.curve)) return {};
  const Stretch whole = whole_loop(face, loop);
  double first = whole.foot(a.position).fraction, part = whole.foot(b.position).fraction - first;
  part -= std::floor(part);
  if (part > 0.5) {
    first += part;
    part = 1 - part;
  }
  if (part * whole.length() > 2 * distance(a.position, b.position)) return {};
  if (has_corner(face, loop, whole, first, part)) return {};
  return whole.at(first + part / 2);
}

std::vector<BoundaryPair> close_pairs(const CadFace& face, const FeatureNodes& state) {
  std::vector<BoundaryPair> pairs;
  const int n = static_cast<int>(state.nodes.size());
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) {
      const FeatureNode &a = state.nodes[i], &b = state.nodes[j];
      if (a.is_inside() || b.is_inside() || a.valence != 3 || b.valence != 3) continue;
      if (a.hole >= 0 && a.hole == b.hole) continue;
      const double d = distance(a.position, b.position);
      if (d >= state.size / 2 - state.tie) continue;
      if (const auto middle = middle_between(face, a, b)) pairs.push_back({d, i, j, *middle});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const BoundaryPair& a, const BoundaryPair& b) { return a.distance < b.distance; });
  return pairs;
}

void merge(FeatureNodes& state, const BoundaryPair& pair) {
  const FeatureNode a = state.nodes[pair.a], b = state.nodes[pair.b];
  FeatureNode merged = a;
  merged.position = pair.middle.position;
  merged.curve = pair.middle.curve;
  merged.t = pair.middle.t;
  merged.valence = 4;
  merged.changed_by = ChangeKind::feature;
  record(state, ChangeKind::feature, {a, b}, {merged},
         fmt::format("two nodes on the boundary {:.4g} apart, nearer than half the feature size, {:.4g}, become one",
                     pair.distance, state.size / 2));
  state.nodes[pair.a] = merged;
  FeatureNode& gone = state.nodes[pair.b];
  gone.curve = -1;
  gone.valence = 4;
}

/// The nearest class of pairs with one that shares no node with others of it; false: there is none.
bool merge_nearest(const CadFace& face, FeatureNodes& state) {
  const std::vector<BoundaryPair> pairs = close_pairs(face, state);
  for (size_t first = 0; first < pairs.size();) {
    size_t last = first + 1;
    while (last < pairs.size() && pairs[last].distance - pairs[last - 1].distance <= state.tie) ++last;
    std::vector<int> uses(state.nodes.size());
    for (size_t p = first; p < last; ++p) ++uses[pairs[p].a], ++uses[pairs[p].b];
    bool is_done = false;
    for (size_t p = first; p < last; ++p) {
      if (uses[pairs[p].a] > 1 || uses[pairs[p].b] > 1) continue;
      merge(state, pairs[p]);
      is_done = true;
    }
    drop_regular(state);
    if (is_done) return true;
    first = last;
  }
  return false;
}

}  // namespace

void merge_on_boundary(const CadFace& face, FeatureNodes& state) {
  while (merge_nearest(face, state)) {
  }
}

}  // namespace quadrille::features
