#include "guide/absorb.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/tie_classes.hpp"
#include "guide/admissible_valence.hpp"
#include "guide/segment_in_mesh.hpp"

namespace quadrille::guide {
namespace {

using zeros::FoundZero;

struct Near {
  int zero;
  double distance;
};

/// The corner nearest to x within reach; std::nullopt if no corner is within reach or two are equally near.
std::optional<std::size_t> nearest_corner(const std::vector<Corner>& corners, Vec2 x, double reach, double tol) {
  std::optional<std::size_t> nearest;
  double least = reach + tol;
  bool is_tie = false;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const double d = distance(corners[c].position, x);
    if (d > reach + tol) continue;
    is_tie = nearest && std::abs(d - least) <= tol;
    if (!nearest || d < least) nearest = c, least = d;
  }
  return is_tie ? std::nullopt : nearest;
}

NodeMark mark(const Corner& corner) { return {corner.position, corner.valence, NodeLocation::corner}; }

NodeMark mark(const FoundZero& zero) { return {zero.x, 4 - zero.index, NodeLocation::inside}; }

/// The zeros that one corner may absorb.
using Candidates = std::vector<Near>;

/// Candidates of each corner, nearest first.
std::vector<Candidates> candidates_of(const field::FieldEvaluator& evaluator, const std::vector<FoundZero>& zeros,
                                      double length, double tol, const std::vector<Corner>& corners) {
  std::vector<Candidates> by_corner(corners.size());
  for (int i = 0; i < static_cast<int>(zeros.size()); ++i) {
    const auto c = nearest_corner(corners, zeros[i].x, length, tol);
    if (c && is_segment_in_mesh(evaluator, corners[*c].position, zeros[i].x))
      by_corner[*c].push_back({i, distance(corners[*c].position, zeros[i].x)});
  }
  for (Candidates& list : by_corner)
    std::stable_sort(list.begin(), list.end(), [](const Near& a, const Near& b) { return a.distance < b.distance; });
  return by_corner;
}

NodeChange change_for(const std::vector<FoundZero>& zeros, Candidates::const_iterator first,
                      Candidates::const_iterator last, const Corner& before, int valence, double length) {
  NodeChange change;
  change.kind = ChangeKind::absorb;
  change.reason = fmt::format(
      "a node of valence {} is {:.3g} from the corner of {:.6g} degrees, less than the absorption distance {:.3g}",
      4 - zeros[first->zero].index, first->distance, before.angle_degrees, length);
  change.before = {mark(before)};
  for (; first != last; ++first) change.before.push_back(mark(zeros[first->zero]));
  change.after = {{before.position, valence, NodeLocation::corner}};
  return change;
}

/// Decides classes of equally near candidates, each class as a whole.
void absorb_into(Corner& corner, const std::vector<FoundZero>& zeros, const Candidates& candidates, double length,
                 double tol, std::vector<bool>& is_absorbed, std::vector<NodeChange>& changes) {
  for (auto first = candidates.begin(); first != candidates.end();) {
    const auto last =
        end_of_ties(first, candidates.end(), tol, [](const Near& candidate) { return candidate.distance; });
    int valence = corner.valence;
    for (auto it = first; it != last; ++it) valence -= zeros[it->zero].index;
    if (is_admissible_after_absorption(corner.angle_degrees, valence)) {
      changes.push_back(change_for(zeros, first, last, corner, valence, length));
      for (auto it = first; it != last; ++it) is_absorbed[it->zero] = true;
      corner.valence = valence;
      corner.source = NodeSource::absorb;
    }
    first = last;
  }
}

}  // namespace

std::vector<bool> absorb_into_corners(const field::FieldEvaluator& evaluator, const std::vector<FoundZero>& zeros,
                                      double length, std::vector<Corner>& corners, std::vector<NodeChange>& changes) {
  std::vector<bool> is_absorbed(zeros.size(), false);
  if (length == 0) return is_absorbed;
  const double tol = 1e-6 * length;
  const std::vector<Candidates> candidates = candidates_of(evaluator, zeros, length, tol, corners);
  for (std::size_t c = 0; c < corners.size(); ++c)
    if (corners[c].source != NodeSource::line)
      absorb_into(corners[c], zeros, candidates[c], length, tol, is_absorbed, changes);
  return is_absorbed;
}

}  // namespace quadrille::guide
