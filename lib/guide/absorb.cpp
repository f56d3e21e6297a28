#include "guide/absorb.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "guide/clusters.hpp"
#include "guide/valence.hpp"

namespace quadrille::guide {
namespace {

struct Near {
  int zero;
  double distance;
};

/// The corner nearest to x within reach; -1: none, or two as near.
int nearest_corner(const std::vector<Corner>& corners, Vec2 x, double reach, double tol) {
  int nearest = -1;
  double least = reach + tol;
  bool is_tie = false;
  for (int c = 0; c < static_cast<int>(corners.size()); ++c) {
    const double d = distance(corners[c].position, x);
    if (d > reach + tol) continue;
    is_tie = nearest >= 0 && std::abs(d - least) <= tol;
    if (nearest < 0 || d < least) nearest = c, least = d;
  }
  return is_tie ? -1 : nearest;
}

NodeMark mark(const Corner& corner) { return {corner.position, corner.valence, NodeLocation::corner}; }

NodeChange change_for(const zeros::FoundZero& zero, const Corner& before, int valence, double d, double length) {
  NodeChange change;
  change.kind = ChangeKind::absorb;
  change.reason = fmt::format(
      "a node of valence {} stands {:.3g} from the corner of {:.6g} degrees, nearer than corner-absorb, {:.3g}",
      4 - zero.index, d, before.angle_degrees, length);
  change.before = {mark(before), {zero.x, 4 - zero.index, NodeLocation::inside}};
  change.after = {{before.position, valence, NodeLocation::corner}};
  return change;
}

}  // namespace

bool may_become(double angle_degrees, int valence) {
  if (valence == 0) return std::abs(angle_degrees - 45) < degrees(near_tie);
  const double block = angle_degrees / valence;
  return valence > 0 && valence <= 4 && block >= 15 && block <= 165 && std::abs(valence - angle_degrees / 90) <= 0.75;
}

std::vector<bool> absorb_into_corners(const field::FieldEvaluator& evaluator,
                                      const std::vector<zeros::FoundZero>& zeros, double length,
                                      std::vector<Corner>& corners, std::vector<NodeChange>& changes) {
  std::vector<bool> is_absorbed(zeros.size(), false);
  if (length == 0) return is_absorbed;
  const double tol = 1e-6 * length;
  std::vector<std::vector<Near>> by_corner(corners.size());
  for (int i = 0; i < static_cast<int>(zeros.size()); ++i) {
    const int c = nearest_corner(corners, zeros[i].x, length, tol);
    if (c >= 0 && sees(evaluator, corners[c].position, zeros[i].x))
      by_corner[c].push_back({i, distance(corners[c].position, zeros[i].x)});
  }
  for (std::size_t c = 0; c < corners.size(); ++c) {
    std::vector<Near>& list = by_corner[c];
    std::stable_sort(list.begin(), list.end(), [](const Near& a, const Near& b) { return a.distance < b.distance; });
    for (auto first = list.begin(); first != list.end();) {
      auto last = first;
      int valence = corners[c].valence;
      for (; last != list.end() && last->distance - first->distance <= tol; ++last) valence -= zeros[last->zero].index;
      if (may_become(corners[c].angle_degrees, valence)) {
        NodeChange change = change_for(zeros[first->zero], corners[c], valence, first->distance, length);
        for (auto other = first; other != last; ++other) {
          is_absorbed[other->zero] = true;
          if (other != first)
            change.before.push_back({zeros[other->zero].x, 4 - zeros[other->zero].index, NodeLocation::inside});
        }
        changes.push_back(std::move(change));
        corners[c].valence = valence;
        corners[c].source = NodeSource::absorb;
      }
      first = last;
    }
  }
  return is_absorbed;
}

}  // namespace quadrille::guide
