#include "sew/inner_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "curve/face_boundary.hpp"
#include "curve/nurbs.hpp"
#include "sew/curve_crossings.hpp"
#include "sew/match_curves.hpp"

namespace quadrille::sew {
namespace {

class NodeFinder {
 public:
  NodeFinder(const Region& region, const std::vector<heal::LoopCurve>& curves, double tol, const std::string& file)
      : region_(region), curves_(curves), tol_(tol), file_(file) {}

  std::vector<Vec2> find() {
    for (int c = 0; c < region_.num_curves(); ++c)
      if (!has_seam(region_, c)) nodes_.push_back(region_.curves[c].curve.poles.front());
    const curve::CurveTree boundary = boundary_of(region_), inside(curves_, &heal::LoopCurve::curve);
    for (const heal::LoopCurve& inner : curves_) {
      for (const Vec2 end : ends_of(inner.curve)) add_foot(end, boundary, -1);
      for (const heal::LoopCurve& outer : region_.curves) add_crossings(outer, inner);
    }
    for (size_t i = 0; i < curves_.size(); ++i) {
      for (const Vec2 end : ends_of(curves_[i].curve)) add_foot(end, inside, static_cast<int>(i));
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

  // Adds the point nearest to x on a curve other than number `own`, if it is within the tolerance.
  void add_foot(Vec2 x, const curve::CurveTree& curves, int own) {
    const curve::NearestPoint foot = curves.nearest(x, [own](int c) { return c != own; });
    if (foot.distance <= tol_) add(foot.position);
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

}  // namespace

std::vector<Vec2> inner_nodes(const Region& region, const std::vector<heal::LoopCurve>& curves, double tol,
                              const std::string& file) {
  return NodeFinder(region, curves, tol, file).find();
}

}  // namespace quadrille::sew
