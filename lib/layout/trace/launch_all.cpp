#include "trace/launch_all.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/point_grid.hpp"
#include "curve/arc_length.hpp"
#include "curve/nurbs.hpp"
#include "field/evaluate.hpp"
#include "trace/fixed_nodes.hpp"
#include "trace/launch_directions.hpp"

namespace quadrille::trace {
namespace {

// Distance of a line's first point from its node, relative to the distance to the nearest feature: near enough that the
// quadratic launch misses the separatrix by less than round-off, far enough that the field has a direction.
constexpr double relative_radius = 1e-4;
// The field of a corner near a tie (4 omega near pi modulo 2 pi) turns across its line the faster the nearer the
// corner. Starting farther away costs no accuracy there: neighbouring lines converge to such a line.
constexpr double stiff_turn_rate = 50;        // radians of the direction per radian of the bearing
constexpr double max_relative_radius = 0.05;  // relative to the distance to the nearest feature
constexpr int num_cuts = 4;
// Lines of a corner that absorbed zeros start on an arc beyond these zeros: radius of the arc, relative to the distance
// of the farthest of them, and its greatest radius, relative to the distance to the nearest feature.
constexpr double arc_beyond_zeros = 2;
constexpr double max_arc_radius = 0.4;

// Nodes and joints.
PointGrid features(const CadFace& face, const std::vector<graph::FixedNode>& nodes) {
  std::vector<Vec2> points = positions(nodes);
  for (const Joint& joint : face.joints) points.push_back(joint.position);
  return PointGrid(std::move(points));
}

// Distance to the nearest other node or joint, at most `limit`.
double feature_distance(const PointGrid& features, Vec2 x, double limit) {
  const PointGrid::Nearest other = features.nearest(x, [&](int n) { return features.points()[n] != x; });
  return std::min(limit, std::sqrt(other.distance2));
}

// Elements are as large as the scale of the field, except in the fans at corners, where they are much smaller.
double element_size(const field::FieldEvaluator& evaluator, int elem) {
  Vec2 position;
  Mat2 dx_dxi;
  evaluator.maps()[elem].evaluate({-1.0 / 3, -1.0 / 3}, position, dx_dxi);
  return std::sqrt(std::abs(det(dx_dxi)));
}

bool is_phase(const field::FieldEvaluator& evaluator) { return evaluator.field().kind == FieldKind::phase; }

std::vector<double> directions_at(const field::FieldEvaluator& evaluator, int node, const CriticalPoint& p,
                                  const mesh::Location& at, double feature) {
  if (is_phase(evaluator)) return phase_launch_directions(field::node_phase(evaluator, node), p.valence);
  const bool is_simple = std::abs(p.index) == 1;
  if (!is_simple) return launch_directions_on_circle(evaluator, p.position, 1e-2 * feature, p.valence);
  return launch_directions(evaluator.sample(at.elem, at.xi).dv_dx);
}

// Derivative of the direction by the bearing from the node.
double turn_rate(const field::FieldEvaluator& evaluator, const Launch& launch) {
  const field::FieldSample f = evaluator.sample(launch.elem, launch.xi);
  const Vec2 v = f.value, across = left_of(unit(launch.angle));
  const double rate = cross(v, f.dv_dx * across) / (4 * norm2(v));
  return std::abs(rate) * launch.radius;
}

// Distance from a corner to the farthest zero that it absorbed; 0 if it absorbed none.
double distance_of_absorbed(const CriticalPoints& points, Vec2 corner) {
  double farthest = 0;
  for (const NodeChange& change : points.changes) {
    if (change.kind != ChangeKind::absorb || change.after.size() != 1 || change.after[0].position != corner) continue;
    for (const NodeMark& mark : change.before) farthest = std::max(farthest, distance(mark.position, corner));
  }
  return farthest;
}

/// The sector of the domain at a corner or boundary node.
struct Sector {
  double tangent_out = 0;  ///< angle of the outgoing boundary tangent
  double interior_angle = pi;
};

Sector sector_at(const CadFace& face, const graph::FixedNode& node) {
  if (node.joint >= 0) return {face.joints[node.joint].tangent_out, face.joints[node.joint].interior_angle};
  return {angle_of(curve::tangent(face.curves[node.curve], node.t)), pi};
}

std::vector<double> directions_in(const field::FieldEvaluator& evaluator, const Sector& sector, int valence) {
  return is_phase(evaluator) ? phase_corner_launch_directions(sector.interior_angle, valence)
                             : corner_launch_directions(sector.interior_angle, valence);
}

// The harmonic field has an absorbed zero where it was, not at the corner: only beyond it are its directions those of
// a corner of the new valence. `radius`: of the arc on which the lines start.
std::vector<Launch> launch_beyond_absorbed(const field::FieldEvaluator& evaluator, int node,
                                           const graph::FixedNode& corner, const Sector& sector, double radius) {
  std::vector<Launch> launches;
  for (const double angle : launch_directions_on_arc(evaluator, corner.position, sector.tangent_out,
                                                     sector.interior_angle, radius, corner.valence))
    launches.push_back(launch_line(evaluator, node, corner.position, sector.tangent_out + angle, radius, 1));
  return launches;
}

Launch launch_from_sector(const field::FieldEvaluator& evaluator, int node, Vec2 apex, const Sector& sector,
                          double angle, double feature) {
  for (double radius = relative_radius;; radius = std::min(4 * radius, max_relative_radius)) {
    const Launch launch =
        launch_line(evaluator, node, apex, sector.tangent_out + angle, radius * feature, pi / sector.interior_angle);
    if (radius >= max_relative_radius || turn_rate(evaluator, launch) < stiff_turn_rate) return launch;
  }
}

}  // namespace

std::vector<Launch> launch_all(const field::FieldEvaluator& evaluator, const CriticalPoints& points) {
  const CadFace& face = evaluator.field().mesh.face;
  const std::vector<graph::FixedNode> nodes = fixed_nodes(face, points);
  const int num_inner = static_cast<int>(points.critical_points.size()), num = static_cast<int>(nodes.size());
  const PointGrid others = features(face, nodes);
  std::vector<Launch> launches;
  for (int n = 0; n < num_inner; ++n) {
    const Vec2 x = nodes[n].position;
    const mesh::Location at = evaluator.locator().find(x);
    if (at.elem < 0) throw FormatError("an irregular node lies outside the field's mesh");
    const double feature = feature_distance(others, x, 4 * element_size(evaluator, at.elem));
    for (const double angle : directions_at(evaluator, n, points.critical_points[n], at, feature))
      launches.push_back(launch_line(evaluator, n, x, angle, relative_radius * feature, 1));
  }
  for (int n = num_inner; n < num; ++n) {
    const Sector sector = sector_at(face, nodes[n]);
    const double feature = feature_distance(others, nodes[n].position, face.diameter / 10);
    const double absorbed = is_phase(evaluator) ? 0 : distance_of_absorbed(points, nodes[n].position);
    if (absorbed > 0 && absorbed < max_arc_radius * feature) {
      const double radius = std::min(arc_beyond_zeros * absorbed, max_arc_radius * feature);
      for (const Launch& launch : launch_beyond_absorbed(evaluator, n, nodes[n], sector, radius))
        launches.push_back(launch);
      continue;
    }
    for (const double angle : directions_in(evaluator, sector, nodes[n].valence))
      launches.push_back(launch_from_sector(evaluator, n, nodes[n].position, sector, angle, feature));
  }
  return launches;
}

int num_launches(const CriticalPoints& points) {
  int num = 0;
  for (const CriticalPoint& p : points.critical_points) num += p.valence;
  for (const Corner& c : points.corners) num += c.valence - 1;
  for (const IrregularBoundaryPoint& b : points.boundary_nodes) num += b.valence - 1;
  return num;
}

std::vector<Launch> launch_cuts(const field::FieldEvaluator& evaluator) {
  const CadFace& face = evaluator.field().mesh.face;
  std::vector<curve::ArcLength> lengths;
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

}  // namespace quadrille::trace
