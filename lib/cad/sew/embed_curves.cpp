#include "sew/embed_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "curve/chain.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "curve/project.hpp"
#include "heal/blunt_cusps.hpp"
#include "outline/extent.hpp"
#include "outline/outline_checks.hpp"
#include "sew/cut_curve.hpp"
#include "sew/inner_curves.hpp"
#include "sew/sew_regions.hpp"

namespace quadrille::sew {
namespace {

Nurbs curve_of(const SideOfCurve& side) { return side.curve.curve; }

Vec2 middle_of(const Nurbs& curve) { return curve::point(curve, (curve.begin() + curve.end()) / 2); }

/// The joints of the region; where it touches itself, one for all of its curves. Seams of smooth closed curves are
/// none.
std::vector<Vec2> joints_of(const Region& region) {
  std::vector<Vec2> joints;
  for (int c = 0; c < region.num_curves(); ++c) {
    const Vec2 x = region.curves[c].curve.poles.front();
    if (!has_seam(region, c) && std::find(joints.begin(), joints.end(), x) == joints.end()) joints.push_back(x);
  }
  return joints;
}

/// Where inner curves meet the boundary of their region and each other.
class NodeFinder {
 public:
  NodeFinder(const Region& region, const std::vector<heal::LoopCurve>& curves, double tol, const std::string& file)
      : region_(region), curves_(curves), tol_(tol), file_(file) {}

  std::vector<Vec2> find() {
    nodes_ = joints_of(region_);
    for (const heal::LoopCurve& inner : curves_) {
      for (const Vec2 end : ends_of(inner.curve)) add_foot(end, region_.curves, nullptr);
      for (const heal::LoopCurve& outer : region_.curves) add_crossings(outer, inner);
    }
    for (size_t i = 0; i < curves_.size(); ++i) {
      for (const Vec2 end : ends_of(curves_[i].curve)) add_foot(end, curves_, &curves_[i]);
      for (size_t j = 0; j < i; ++j) add_crossings(curves_[j], curves_[i]);
    }
    for (const heal::LoopCurve& inner : curves_)
      for (const Vec2 end : ends_of(inner.curve)) add(end);
    return std::move(nodes_);
  }

 private:
  static std::vector<Vec2> ends_of(const Nurbs& curve) {
    if (curve::has_smooth_seam(curve)) return {};
    return {curve.poles.front(), curve.poles.back()};
  }

  void add(Vec2 x) {
    const auto is_near = [&](Vec2 node) { return distance(node, x) <= tol_; };
    if (std::none_of(nodes_.begin(), nodes_.end(), is_near)) nodes_.push_back(x);
  }

  // Adds the point nearest to x on a curve other than `own`, if it is within the tolerance.
  void add_foot(Vec2 x, const std::vector<heal::LoopCurve>& curves, const heal::LoopCurve* own) {
    double least = tol_;
    const heal::LoopCurve* nearest = nullptr;
    Vec2 foot;
    for (const heal::LoopCurve& c : curves) {
      if (&c == own || !curve::pole_box(c.curve).contains(x, tol_)) continue;
      const auto projection = curve::project(c.curve, x);
      if (projection.distance <= least) least = projection.distance, nearest = &c, foot = projection.position;
    }
    if (nearest) add(foot);
  }

  void add_crossings(const heal::LoopCurve& a, const heal::LoopCurve& b) {
    // One that lies on the other, a copy or a part of it, is left out later.
    if (std::min(one_sided_separation(a.curve, b.curve), one_sided_separation(b.curve, a.curve)) <= tol_) return;
    const std::string what = fmt::format("{}: edges {} and {}", file_, a.cad_edge, b.cad_edge);
    for (const CurveCrossing& crossing : curve_crossings(a.curve, b.curve, tol_, what)) add(crossing.position);
  }

  const Region& region_;
  const std::vector<heal::LoopCurve>& curves_;
  double tol_;
  const std::string& file_;
  std::vector<Vec2> nodes_;
};

/// The joints of the region first, then where inner curves cross or end on the boundary, cross each other, end on each
/// other, and end. Points within `tol` of each other are one node, but joints are never united. Seams of smooth closed
/// curves are no nodes. Throws as embed_curves.
std::vector<Vec2> inner_nodes(const Region& region, const std::vector<heal::LoopCurve>& curves, double tol,
                              const std::string& file) {
  return NodeFinder(region, curves, tol, file).find();
}

/// Cuts curves at nodes and collects the sides of the pieces.
class Sides {
 public:
  Sides(const Region& region, std::vector<Vec2> nodes, double tol)
      : region_(region), boundary_(boundary_of(region)), nodes_(std::move(nodes)), tol_(tol) {}

  void add_boundary() {
    // A joint may be within the tolerance of another curve of the boundary, but it is not on it.
    const int num_joints = static_cast<int>(joints_of(region_).size());
    for (int c = 0; c < region_.num_curves(); ++c)
      for (SideOfCurve& piece : pieces_of(region_.curves[c], has_seam(region_, c), num_joints))
        sides.push_back(std::move(piece));
  }

  void add_inner(const heal::LoopCurve& inner) {
    const double length = curve::ArcLength(inner.curve).total();
    lengths_.resize(sides.size());
    for (SideOfCurve& piece : pieces_of(inner, curve::has_smooth_seam(inner.curve), 0)) {
      if (!is_inside(piece.curve.curve)) continue;
      if (const int known = side_along(piece); known >= 0) {
        name_after_shorter(known, inner, length);
        continue;
      }
      const int number = static_cast<int>(sides.size());
      SideOfCurve back{piece.curve, piece.to, piece.from, number};
      back.curve.curve = curve::reversed(back.curve.curve);
      piece.twin = number + 1;
      sides.push_back(std::move(piece));
      sides.push_back(std::move(back));
      lengths_.resize(sides.size(), length);
    }
  }

  std::vector<SideOfCurve> sides;

 private:
  int nearest_node(Vec2 x) const {
    const auto nearer = [x](Vec2 a, Vec2 b) { return distance(a, x) < distance(b, x); };
    return static_cast<int>(std::min_element(nodes_.begin(), nodes_.end(), nearer) - nodes_.begin());
  }

  // Cut at the nodes from number `first` on.
  std::vector<SideOfCurve> pieces_of(const heal::LoopCurve& whole, bool is_round, int first) {
    const Nurbs& curve = whole.curve;
    const int start = is_round ? -1 : nearest_node(curve.poles.front());
    const int end = is_round ? -1 : nearest_node(curve.poles.back());
    std::vector<Cut> cuts;
    const curve::PoleBox box = curve::pole_box(curve);
    for (int n = first; n < static_cast<int>(nodes_.size()); ++n) {
      if (n == start || n == end || !box.contains(nodes_[n], tol_)) continue;
      const auto foot = curve::project(curve, nodes_[n]);
      if (foot.distance <= tol_) cuts.push_back({foot.t, n});
    }
    std::vector<CutPiece> cut = cut_curve(curve, cuts, start);
    if (cut.front().start < 0) {  // a whole smooth closed curve: its seam becomes a node
      nodes_.push_back(curve.poles.front());
      cut.front().start = static_cast<int>(nodes_.size()) - 1;
    }
    std::vector<SideOfCurve> pieces;
    for (size_t i = 0; i < cut.size(); ++i) {
      const int to = i + 1 < cut.size() ? cut[i + 1].start : is_round ? cut.front().start : end;
      const Nurbs moved = curve::with_ends(cut[i].curve, nodes_[cut[i].start], nodes_[to]);
      pieces.push_back({{moved, whole.cad_edge, whole.name}, cut[i].start, to, -1});
    }
    return pieces;
  }

  // Pieces along the boundary are none of the region's inside.
  bool is_inside(const Nurbs& curve) const {
    Vec2 farthest;
    double distance = 0;
    for (const double fraction : {0.25, 0.5, 0.75}) {
      const Vec2 x = curve::point(curve, curve.begin() + fraction * (curve.end() - curve.begin()));
      if (const double d = boundary_.nearest(x).distance; d > distance) distance = d, farthest = x;
    }
    return distance > tol_ && boundary_.winding_number(farthest) > 0;
  }

  /// The side of an inner curve that the piece lies on; -1: none.
  int side_along(const SideOfCurve& piece) const {
    const auto found = std::find_if(sides.begin(), sides.end(), [&](const SideOfCurve& side) {
      return side.twin >= 0 && side.from == piece.from && side.to == piece.to &&
             separation(side.curve.curve, piece.curve.curve) <= tol_;
    });
    return found == sides.end() ? -1 : static_cast<int>(found - sides.begin());
  }

  /// A part of a longer curve has the name of the shorter one that lies on it, one of two equally long curves has both:
  /// no name is lost.
  void name_after_shorter(int side, const heal::LoopCurve& inner, double length) {
    const std::string& known = sides[side].curve.name;
    if (inner.name.empty() || inner.name == known) return;
    const bool is_tied = std::abs(length - lengths_[side]) <= lengths_[side] * tolerance::tied;
    if (!known.empty() && !is_tied && length > lengths_[side]) return;
    const std::string name = is_tied && !known.empty() ? known + '+' + inner.name : inner.name;
    for (const int s : {side, sides[side].twin}) {
      sides[s].curve.name = name, sides[s].curve.cad_edge = inner.cad_edge;
      lengths_[s] = length;
    }
  }

  const Region& region_;
  curve::CurveTree boundary_;
  std::vector<Vec2> nodes_;
  double tol_;
  std::vector<double> lengths_;  ///< by side: of the inner curve that named it
};

/// A loop with what decides to which region it belongs.
struct TracedLoop {
  std::vector<int> sides;
  std::vector<Nurbs> curves;
  int component = 0;
  bool is_outline = false;
  double area = 0;
};

std::vector<TracedLoop> measured_loops(const std::vector<SideOfCurve>& sides) {
  int num_nodes = 0;
  for (const SideOfCurve& side : sides) num_nodes = std::max(num_nodes, side.from + 1);
  DisjointSets components(num_nodes);
  for (const SideOfCurve& side : sides) components.unite(side.from, side.to);
  std::vector<TracedLoop> loops;
  for (std::vector<int>& numbers : traced_loops(sides)) {
    TracedLoop loop{std::move(numbers), {}, 0, false, 0};
    loop.component = components.find(sides[loop.sides.front()].from);
    for (const int s : loop.sides) loop.curves.push_back(curve_of(sides[s]));
    const auto has_twin_here = [&](int s) {
      return std::find(loop.sides.begin(), loop.sides.end(), sides[s].twin) != loop.sides.end();
    };
    loop.area = outline::signed_area(loop.curves);
    loop.is_outline = loop.area > 0 && !std::all_of(loop.sides.begin(), loop.sides.end(), has_twin_here);
    loops.push_back(std::move(loop));
  }
  return loops;
}

/// For each outline, in the order of the loops, the loops of its region: itself, then its holes and slits.
std::vector<std::vector<int>> grouped(const std::vector<TracedLoop>& loops) {
  std::vector<std::vector<int>> groups;
  for (int l = 0; l < static_cast<int>(loops.size()); ++l)
    if (loops[l].is_outline) groups.push_back({l});
  for (int l = 0; l < static_cast<int>(loops.size()); ++l) {
    if (loops[l].is_outline) continue;
    const Vec2 x = middle_of(loops[l].curves.front());
    std::vector<int>* smallest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (std::vector<int>& group : groups) {
      const TracedLoop& outer = loops[group.front()];
      // A connected set of curves has no loop around itself.
      if (outer.component == loops[l].component || outer.area >= least) continue;
      if (outline::winding_number(outer.curves, x) != 0) smallest = &group, least = outer.area;
    }
    if (smallest != nullptr) smallest->push_back(l);
  }
  return groups;
}

Region region_of_loops(const Region& whole, const std::vector<SideOfCurve>& sides,
                       const std::vector<std::vector<int>>& loops) {
  Region region{whole.name, whole.cad_face, {}, {}, {0}};
  std::vector<int> numbers(sides.size(), -1), used;
  for (const std::vector<int>& loop : loops) {
    for (const int s : loop) {
      numbers[s] = region.num_curves();
      used.push_back(s);
      region.curves.push_back(sides[s].curve);
    }
    region.loop_offsets.push_back(region.num_curves());
  }
  for (const int s : used) region.other_sides.push_back(sides[s].twin < 0 ? -1 : numbers[sides[s].twin]);
  return region;
}

}  // namespace

std::vector<std::vector<std::vector<int>>> regions_of_sides(const std::vector<SideOfCurve>& sides) {
  const std::vector<TracedLoop> loops = measured_loops(sides);
  std::vector<std::vector<std::vector<int>>> regions;
  for (const std::vector<int>& group : grouped(loops)) {
    regions.emplace_back();
    for (const int l : group) regions.back().push_back(loops[l].sides);
  }
  return regions;
}

void refuse_cusps(const Region& region, const std::string& file) {
  for (int c = 0; c < region.num_curves(); ++c) {
    const int before = region.previous_in_loop(c);
    if (region.other_sides[c] == before) continue;  // the tip of a slit
    const Nurbs &in = region.curves[before].curve, &out = region.curves[c].curve;
    if (heal::is_cusp(heal::interior_angle(in, out)))
      throw FormatError(fmt::format(
          "{}: edges {} and {} meet at {} at an angle of zero: let the inner curve end at an "
          "angle to the other",
          file, region.curves[before].cad_edge, region.curves[c].cad_edge, rounded_position_text(out.poles.front())));
  }
}

std::vector<Region> embed_curves(const Region& region, const std::vector<heal::LoopCurve>& curves, double tol,
                                 const std::string& file) {
  Sides sides(region, inner_nodes(region, curves, tol, file), tol);
  sides.add_boundary();
  const size_t num_boundary = sides.sides.size();
  for (const heal::LoopCurve& inner : curves) sides.add_inner(inner);
  if (sides.sides.size() == num_boundary) return {region};
  std::vector<Region> regions;
  for (const auto& loops : regions_of_sides(sides.sides)) {
    regions.push_back(region_of_loops(region, sides.sides, loops));
    refuse_cusps(regions.back(), file);
  }
  return regions;
}

}  // namespace quadrille::sew
