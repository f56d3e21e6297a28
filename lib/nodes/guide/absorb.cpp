#include "guide/absorb.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/tolerance.hpp"
#include "curve/face_boundary.hpp"
#include "guide/valence.hpp"
#include "placement/node_ledger.hpp"

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

/// The zeros that one corner may absorb.
using Candidates = std::vector<Near>;

/// Candidates of each corner, nearest first.
std::vector<Candidates> candidates_of(const CadFace& face, const std::vector<FoundZero>& zeros, double length,
                                      double tol, const std::vector<Corner>& corners) {
  const curve::FaceBoundary boundary(face);
  std::vector<Candidates> by_corner(corners.size());
  for (int i = 0; i < static_cast<int>(zeros.size()); ++i) {
    const auto c = nearest_corner(corners, zeros[i].x, length, tol);
    if (!c) continue;
    const Vec2 corner = corners[*c].position;
    if (boundary.is_visible(corner + 0.1 * (zeros[i].x - corner), zeros[i].x))  // off the corner's own sides
      by_corner[*c].push_back({i, distance(corner, zeros[i].x)});
  }
  for (Candidates& list : by_corner)
    std::stable_sort(list.begin(), list.end(), [](const Near& a, const Near& b) { return a.distance < b.distance; });
  return by_corner;
}

placement::NodeEdit edit_of(const std::vector<FoundZero>& zeros, Candidates::const_iterator first,
                            Candidates::const_iterator last, const Corner& corner, double length) {
  placement::NodeEdit edit;
  edit.kind = ChangeKind::absorb;
  edit.reason = fmt::format(
      "a node of valence {} is {:.3g} from the corner of {:.6g} degrees, less than the absorption distance {:.3g}",
      4 - zeros[first->zero].index, first->distance, corner.angle_degrees, length);
  edit.corners = {{corner.joint, corner.valence}};
  for (; first != last; ++first) {
    const FoundZero& zero = zeros[first->zero];
    edit.zeros.push_back({zero.x, 4 - zero.index, NodeLocation::inside});
    edit.corners[0].valence -= zero.index;
  }
  return edit;
}

/// Decides classes of equally near candidates of one corner, each class as a whole.
void absorb_into(std::size_t c, const std::vector<FoundZero>& zeros, const Candidates& candidates, double length,
                 double tol, std::vector<bool>& is_absorbed, CriticalPoints& points) {
  for (auto first = candidates.begin(); first != candidates.end();) {
    const auto last =
        end_of_ties(first, candidates.end(), tol, [](const Near& candidate) { return candidate.distance; });
    const placement::NodeEdit edit = edit_of(zeros, first, last, points.corners[c], length);
    if (is_admissible_after_absorption(points.corners[c].angle_degrees, edit.corners[0].valence)) {
      placement::apply({edit}, points);
      for (auto it = first; it != last; ++it) is_absorbed[it->zero] = true;
    }
    first = last;
  }
}

}  // namespace

std::vector<bool> absorb_into_corners(const CadFace& face, const std::vector<FoundZero>& zeros, double length,
                                      CriticalPoints& points) {
  std::vector<bool> is_absorbed(zeros.size(), false);
  if (length == 0) return is_absorbed;
  const double tol = tolerance::tied * length;
  const std::vector<Candidates> candidates = candidates_of(face, zeros, length, tol, points.corners);
  for (std::size_t c = 0; c < candidates.size(); ++c)
    if (points.corners[c].source != NodeSource::line)
      absorb_into(c, zeros, candidates[c], length, tol, is_absorbed, points);
  return is_absorbed;
}

}  // namespace quadrille::guide
