#include "trace/launch_all.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/arc_length.hpp"

namespace quadrille {
namespace {

// A line's first point lies this far from its node, as a share of the distance to the nearest feature: near enough that
// the quadratic launch misses the separatrix by less than round-off counts, far enough that the field has a direction.
constexpr double launch_share = 1e-4;
constexpr int num_cuts = 4;
// A corner near a tie has a field that turns ever faster across its line the nearer the corner. Starting farther off is
// then no loss: such a line draws its neighbours in.
constexpr double stiff_turn = 50;         // of the direction, radians per radian of the bearing
constexpr double farthest_launch = 0.05;  // share of the distance to the nearest feature

// Distance to the nearest other node or joint, at most `limit`.
double feature_distance(const CadFace& face, const CriticalPoints& points, Vec2 x, double limit) {
  double feature = limit;
  const auto other = [&](Vec2 y) {
    if (y != x) feature = std::min(feature, distance(x, y));
  };
  for (const CriticalPoint& p : points.critical_points) other(p.position);
  for (const Joint& joint : face.joints) other(joint.position);
  return feature;
}

// Elements follow the field's scale, but for the fans of corners, which are much smaller.
double element_size(const FieldEvaluator& evaluator, int elem) {
  Vec2 position;
  Mat2 dx_dxi;
  evaluator.maps()[elem].evaluate({-1.0 / 3, -1.0 / 3}, position, dx_dxi);
  return std::sqrt(std::abs(det(dx_dxi)));
}

std::vector<double> directions_at(const FieldEvaluator& evaluator, const CriticalPoint& p, const Location& at,
                                  double feature) {
  const bool is_simple = std::abs(p.index) == 1;
  if (!is_simple) return launch_directions_on_circle(evaluator, p.position, 1e-2 * feature, p.valence);
  return launch_directions(evaluator.sample(at.elem, at.xi).dv_dx);
}

// How fast the direction turns with the bearing from the node.
double turn_rate(const FieldEvaluator& evaluator, const Launch& launch) {
  const FieldSample f = evaluator.sample(launch.elem, launch.xi);
  const Vec2 v = f.value, across = left_of(unit(launch.angle));
  const double rate = cross(v, f.dv_dx * across) / (4 * norm2(v));
  return std::abs(rate) * launch.radius;
}

Launch launch_from_corner(const FieldEvaluator& evaluator, int node, const Joint& joint, double angle, double feature) {
  double share = launch_share;
  for (;;) {
    const Launch launch =
        launch_line(evaluator, node, joint.position, angle, share * feature, pi / joint.interior_angle);
    if (share >= farthest_launch || turn_rate(evaluator, launch) < stiff_turn) return launch;
    share = std::min(4 * share, farthest_launch);
  }
}

}  // namespace

std::vector<FixedNode> fixed_nodes(const CadFace& face, const CriticalPoints& points) {
  std::vector<FixedNode> nodes;
  for (const CriticalPoint& p : points.critical_points) {
    const Vec2 place = p.position + face.origin;
    if (p.valence <= 2)
      throw ComputeError(
          fmt::format("the zero of the field at ({:.6g}, {:.6g}) has index {:+d}: it has to be split into "
                      "nodes of valence 3, which this version doesn't do",
                      place.x, place.y, p.index));
    nodes.push_back({p.position, NodeKind::irregular, p.valence, -1});
  }
  for (const Corner& c : points.corners) {
    const Vec2 place = c.position + face.origin;
    if (c.valence <= 0)
      throw ComputeError(
          fmt::format("degenerate corner of {:.1f} degrees at ({:.6g}, {:.6g}) needs midpoint division, "
                      "which this version doesn't do",
                      c.angle_degrees, place.x, place.y));
    nodes.push_back({face.joints[c.joint].position, NodeKind::corner, c.valence, c.joint});
  }
  return nodes;
}

std::vector<Launch> launch_all(const FieldEvaluator& evaluator, const CriticalPoints& points) {
  const CadFace& face = evaluator.field().mesh.face;
  std::vector<Launch> launches;
  int node = 0;
  for (const CriticalPoint& p : points.critical_points) {
    const Location at = evaluator.locator().find(p.position);
    if (at.elem < 0) throw FormatError("an irregular node lies outside the field's mesh");
    const double feature = feature_distance(face, points, p.position, 4 * element_size(evaluator, at.elem));
    for (const double angle : directions_at(evaluator, p, at, feature))
      launches.push_back(launch_line(evaluator, node, p.position, angle, launch_share * feature, 1));
    ++node;
  }
  for (const Corner& c : points.corners) {
    const Joint& joint = face.joints[c.joint];
    const double feature = feature_distance(face, points, joint.position, face.diameter / 10);
    for (const double angle : corner_launch_directions(joint.interior_angle, c.valence))
      launches.push_back(launch_from_corner(evaluator, node, joint, joint.tangent_out + angle, feature));
    ++node;
  }
  return launches;
}

std::vector<Launch> launch_cuts(const FieldEvaluator& evaluator) {
  const CadFace& face = evaluator.field().mesh.face;
  std::vector<ArcLength> lengths;
  const int first = face.loop_offsets[1], last = face.loop_offsets[2];
  double total = 0;
  for (int c = first; c < last; ++c) {
    lengths.emplace_back(face.curves[c]);
    total += lengths.back().total();
  }
  std::vector<Launch> launches;
  for (int k = 0; k < num_cuts; ++k) {
    double along = total * k / num_cuts;
    int c = first;
    while (c + 1 < last && along >= lengths[c - first].total() * (1 - 1e-12)) along -= lengths[c++ - first].total();
    launches.push_back(launch_from_boundary(evaluator, c, lengths[c - first].parameter(std::max(along, 0.0))));
  }
  return launches;
}

}  // namespace quadrille
