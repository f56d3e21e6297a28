#include "trace/launch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angle.hpp"
#include "base/bracketed_root.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/point_grid.hpp"
#include "base/tolerance.hpp"
#include "curve/chain.hpp"
#include "curve/face_boundary.hpp"
#include "curve/nurbs.hpp"
#include "field/evaluate.hpp"
#include "surface/positions.hpp"
#include "trace/launch_directions.hpp"

namespace quadrille::trace {
namespace {

GraphNode irregular_node(const CadFace& face, const CriticalPoint& p) {
  if (p.valence > 2) return {p.position, NodeKind::irregular, p.valence, -1};
  throw ComputeError(
      fmt::format("the zero of the field at {} has index {:+d}: it must be split into nodes of valence "
                  "3: run critpoints",
                  surface::position_text(face, p.position), p.index));
}

GraphNode joint_node(const CadFace& face, int joint, NodeKind kind, int valence) {
  return {face.joints[joint].position, kind, valence, joint, face.curves[joint].begin()};
}

GraphNode corner_node(const CadFace& face, const Corner& c) {
  if (c.valence > 0) return joint_node(face, c.joint, NodeKind::corner, c.valence);
  throw ComputeError(
      fmt::format("the corner of {:.1f} degrees at {} has valence 0 and makes a block of three sides: critpoints "
                  "--degenerate divide splits it into three blocks of four sides",
                  c.angle_degrees, surface::position_text(face, c.position)));
}

GraphNode boundary_node(const CadFace& face, const IrregularBoundaryPoint& b) {
  const Nurbs& curve = face.curves[b.curve];
  const double tol = 1e-12 * (curve.end() - curve.begin());
  GraphNode node{curve::point(curve, b.t), NodeKind::boundary, b.valence, b.curve, b.t};
  if (b.t <= curve.begin() + tol) node = joint_node(face, b.curve, NodeKind::boundary, b.valence);
  if (b.t >= curve.end() - tol) node = joint_node(face, face.next_in_loop(b.curve), NodeKind::boundary, b.valence);
  if (b.valence >= 3) return node;
  throw ComputeError(
      fmt::format("a node of valence {} on the smooth boundary at {} makes a block whose "
                  "sides form a straight angle there: no valid element has such a corner",
                  b.valence, surface::position_text(face, node.position)));
}

// The direction of the field's cross nearest to `direction` at x; false outside the mesh. `at`: where to look first.
bool direction_at(const field::FieldEvaluator& evaluator, Vec2 x, double direction, mesh::Location& at, double& found) {
  Vec2 value;
  if (!evaluator.value_near(x, at, value)) return false;
  found = guided_angle(value, direction);
  return true;
}

// Bearing offset beta: the direction at origin + radius e(angle + beta) is angle + (1 + power) beta. The root is
// bracketed because the direction nearly jumps next to corners of 45, 135, ... degrees. False when the first point lies
// outside the domain.
bool bend_launch(const field::FieldEvaluator& evaluator, Vec2 origin, double angle, double radius, double power,
                 double& beta) {
  bool inside = true;
  mesh::Location at;
  const auto residual = [&](double b) {
    double direction = angle;
    if (!direction_at(evaluator, origin + radius * unit(angle + b), angle, at, direction)) inside = false;
    return direction - angle - (1 + power) * b;
  };
  beta = 0;
  residual(0);
  if (!inside) return false;
  double width = 1e-12;
  while ((width *= 4) < 0.2) {
    const double low = residual(-width), high = residual(width);
    if (!inside) break;
    if ((low < 0) == (high < 0)) continue;
    // Rounding of directions is a few 1e-16: nothing smaller is sought.
    const double falling = low < 0 ? -0.1 : 0.1;
    beta =
        width * (2 * falling_root_to_round_off([&](double f) { return falling * residual(width * (2 * f - 1)); }) - 1);
    return true;
  }
  return true;  // no such direction nearby: the line starts straight
}

// Distances of a line's first point from its node, relative to the distance to the nearest feature.
struct LaunchRadii {
  double least = 1e-4;  // near enough that the quadratic launch misses the separatrix by less than round-off, far
                        // enough that the field has a direction
  // The field of a corner near a tie (4 omega near pi modulo 2 pi) turns across its line the faster the nearer the
  // corner. Starting farther away costs no accuracy there: neighbouring lines converge to such a line.
  double greatest = 0.05;
  double stiff_turn_rate = 50;  // radians of the direction per radian of the bearing
  // Lines of a corner that absorbed zeros start on an arc beyond these zeros.
  double beyond_zeros = 2;  // relative to the distance of the farthest of them
  double greatest_beyond_zeros = 0.4;
};
constexpr LaunchRadii radii{};

constexpr int num_cuts = 4;

/// From the start of the inner loop to where the axis crosses it: half of the length to the image of the start.
double length_to_axis(const CadFace& face, const std::vector<curve::ArcLength>& lengths, const MirrorAxis& axis) {
  const int first = face.loop_offsets[1];
  const Vec2 start = face.joints[first].position, along = start - axis.point;
  const Vec2 image = axis.point + 2 * dot(along, axis.direction) * axis.direction - along;
  const auto is_inner = [&](int c) { return c >= first && c < face.loop_offsets[2]; };
  const curve::NearestPoint at = curve::FaceBoundary(face).nearest(image, is_inner);
  double length = lengths[at.curve - first].at(at.t);
  for (int c = first; c < at.curve; ++c) length += lengths[c - first].total();
  return length / 2;
}

/// The least length from the start of the inner loop with which one of the cuts is on an axis, or two are its images.
double start_of_cuts(const CadFace& face, const std::vector<curve::ArcLength>& lengths, double total,
                     const std::vector<MirrorAxis>& axes) {
  double start = total;
  for (const MirrorAxis& axis : axes) {
    const double shift = std::remainder(length_to_axis(face, lengths, axis), total / (2 * num_cuts));
    if (std::abs(shift) < std::abs(start)) start = shift;
  }
  if (axes.empty() || std::abs(start) <= tolerance::same_point * face.diameter) return 0;
  return start > 0 ? start : start + total;
}

// Nodes and joints.
PointGrid features(const CadFace& face, const std::vector<GraphNode>& nodes) {
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

Sector sector_at(const CadFace& face, const GraphNode& node) {
  const Nurbs& curve = face.curves[node.curve];
  if (node.t > curve.begin()) return {angle_of(curve::tangent(curve, node.t)), pi};
  return {face.joints[node.curve].tangent_out, face.joints[node.curve].interior_angle};
}

std::vector<double> directions_in(const field::FieldEvaluator& evaluator, const Sector& sector, int valence) {
  return is_phase(evaluator) ? phase_corner_launch_directions(sector.interior_angle, valence)
                             : corner_launch_directions(sector.interior_angle, valence);
}

Launch launch_from_sector(const field::FieldEvaluator& evaluator, int node, Vec2 apex, const Sector& sector,
                          double angle, double feature) {
  for (double radius = radii.least;; radius = std::min(4 * radius, radii.greatest)) {
    const Launch launch =
        launch_line(evaluator, node, apex, sector.tangent_out + angle, radius * feature, pi / sector.interior_angle);
    if (radius >= radii.greatest || turn_rate(evaluator, launch) < radii.stiff_turn_rate) return launch;
  }
}

}  // namespace

std::vector<GraphNode> fixed_nodes(const CadFace& face, const CriticalPoints& points) {
  std::vector<GraphNode> nodes;
  for (const CriticalPoint& p : points.critical_points) nodes.push_back(irregular_node(face, p));
  for (const Corner& c : points.corners) nodes.push_back(corner_node(face, c));
  for (const IrregularBoundaryPoint& b : points.boundary_nodes) nodes.push_back(boundary_node(face, b));
  return nodes;
}

std::vector<Vec2> positions(const std::vector<GraphNode>& nodes) {
  std::vector<Vec2> positions;
  for (const GraphNode& node : nodes) positions.push_back(node.position);
  return positions;
}

Launch launch_line(const field::FieldEvaluator& evaluator, int node, Vec2 origin, double angle, double radius,
                   double power) {
  for (int attempt = 0; attempt < 6; ++attempt, radius /= 10) {
    double beta = 0;
    if (!bend_launch(evaluator, origin, angle, radius, power, beta)) continue;
    mesh::Location at = evaluator.locator().find(origin + radius * unit(angle + beta));
    if (at.elem < 0) continue;
    Launch launch{{node, -1, 0}, origin, angle, radius, at.elem, at.xi, evaluator.maps()[at.elem].position(at.xi),
                  angle};
    if (!direction_at(evaluator, launch.x, angle, at, launch.angle_there)) continue;
    return launch;
  }
  throw ComputeError(fmt::format("the separatrix from {} at {:.2f} degrees starts outside the mesh",
                                 surface::position_text(evaluator.field().mesh.face, origin), degrees(wrap_pi(angle))));
}

Launch launch_from_boundary(const field::FieldEvaluator& evaluator, int curve, double t) {
  const TriMesh& mesh = evaluator.field().mesh;
  const Nurbs& c = mesh.face.curves[curve];
  const Vec2 x = curve::point(c, t);
  const double angle = angle_of(left_of(curve::tangent(c, t)));
  for (const BoundaryEdge& edge : mesh.boundary_edges) {
    if (edge.curve != curve || t < edge.t0 || t > edge.t1) continue;
    const double fraction = (t - edge.t0) / (edge.t1 - edge.t0);
    Vec2 xi = spectral::tri_edge_point(edge.edge, fraction);
    if (!evaluator.maps()[edge.elem].invert(x, xi)) xi = spectral::tri_edge_point(edge.edge, fraction);
    return {{-1, curve, t}, x, angle, 0, edge.elem, xi, x, angle};
  }
  throw Defect("launch_from_boundary: no boundary edge contains the parameter");
}

std::vector<Launch> launch_all(const field::FieldEvaluator& evaluator, const CriticalPoints& points) {
  const CadFace& face = evaluator.field().mesh.face;
  const std::vector<GraphNode> nodes = fixed_nodes(face, points);
  const int num_inner = static_cast<int>(points.critical_points.size()), num = static_cast<int>(nodes.size());
  const PointGrid others = features(face, nodes);
  std::vector<Launch> launches;
  for (int n = 0; n < num_inner; ++n) {
    const Vec2 x = nodes[n].position;
    const mesh::Location at = evaluator.locator().find(x);
    if (at.elem < 0) throw FormatError("an irregular node lies outside the field's mesh");
    const double feature = feature_distance(others, x, 4 * element_size(evaluator, at.elem));
    for (const double angle : directions_at(evaluator, n, points.critical_points[n], at, feature))
      launches.push_back(launch_line(evaluator, n, x, angle, radii.least * feature, 1));
  }
  for (int n = num_inner; n < num; ++n) {
    const Sector sector = sector_at(face, nodes[n]);
    const double feature = feature_distance(others, nodes[n].position, face.diameter / 10);
    const double absorbed = is_phase(evaluator) ? 0 : distance_of_absorbed(points, nodes[n].position);
    // The harmonic field has an absorbed zero where it was, not at the corner: only beyond it are its directions those
    // of a corner of the new valence.
    if (absorbed > 0 && absorbed < radii.greatest_beyond_zeros * feature) {
      const double radius = std::min(radii.beyond_zeros * absorbed, radii.greatest_beyond_zeros * feature);
      for (const double angle : launch_directions_on_arc(evaluator, nodes[n].position, sector.tangent_out,
                                                         sector.interior_angle, radius, nodes[n].valence))
        launches.push_back(launch_line(evaluator, n, nodes[n].position, sector.tangent_out + angle, radius, 1));
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

std::vector<Launch> launch_cuts(const field::FieldEvaluator& evaluator, const std::vector<MirrorAxis>& axes) {
  const CadFace& face = evaluator.field().mesh.face;
  std::vector<curve::ArcLength> lengths;
  const int first = face.loop_offsets[1], last = face.loop_offsets[2];
  double total = 0;
  for (int c = first; c < last; ++c) {
    lengths.emplace_back(face.curves[c]);
    total += lengths.back().total();
  }
  const double start = start_of_cuts(face, lengths, total, axes);
  std::vector<Launch> launches;
  for (int k = 0; k < num_cuts; ++k) {
    double along = std::fmod(start + total * k / num_cuts, total);
    int c = first;
    while (c + 1 < last && along >= lengths[c - first].total() * (1 - 1e-12)) along -= lengths[c++ - first].total();
    launches.push_back(launch_from_boundary(evaluator, c, lengths[c - first].parameter(std::max(along, 0.0))));
  }
  return launches;
}

}  // namespace quadrille::trace
