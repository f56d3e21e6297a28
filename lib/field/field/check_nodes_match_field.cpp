#include "field/check_nodes_match_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "surface/positions.hpp"

namespace quadrille::field {
namespace {

// Whether the field has a zero of the given index at the position.
bool is_zero(const FieldEvaluator& evaluator, const CriticalPoint& p) {
  if (p.valence != 4 - p.index) return false;
  const double diameter = evaluator.field().mesh.face.diameter;
  const mesh::Location at = evaluator.locator().find(p.position);
  if (at.elem < 0) return false;
  const FieldSample sample = evaluator.sample(at.elem, at.xi);
  // At a multiple zero the Jacobian vanishes, so the distance cannot be estimated from it, but the field is small
  // nearby.
  if (std::abs(p.index) != 1) return norm(sample.value) <= 1e-4;
  if ((det(sample.dv_dx) > 0) != (p.index > 0)) return false;
  const Vec2 off = inverse(sample.dv_dx) * sample.value;
  return norm(off) <= tolerance::same_point * diameter;
}

using surface::position_text;

void check_zeros(const FieldEvaluator& evaluator, const CriticalPoints& points) {
  const CadFace& face = evaluator.field().mesh.face;
  if (points.form == NodeForm::phase)
    throw OtherNodesError(
        "the critical points have the form \"phase\", so not all are zeros of the field, which is harmonic: run "
        "fieldsolve --nodes with them");
  for (const CriticalPoint& p : points.critical_points)
    if (!is_zero(evaluator, p))
      throw OtherNodesError(fmt::format("the node at {} is not a zero of the field: run fieldsolve --nodes",
                                        position_text(face, p.position)));
  if (!points.boundary_nodes.empty())
    throw OtherNodesError(fmt::format("a harmonic field has no node on the boundary, as at {}: run fieldsolve --nodes",
                                      position_text(face, points.boundary_nodes.front().position)));
}

int solved_valence(const PhaseNodes& solved, int joint) {
  const auto at = std::find_if(solved.corners.begin(), solved.corners.end(),
                               [&](const CornerValence& corner) { return corner.joint == joint; });
  return at == solved.corners.end() ? 2 : at->valence;
}

// Describes the first node of `points` that the phase was not solved for; empty if all agree.
std::string first_difference(const Field& field, const CriticalPoints& points) {
  const CadFace& face = field.mesh.face;
  const PhaseNodes& solved = field.phase.prescribed;
  const double tol = tolerance::round_off * face.diameter;
  for (size_t i = 0; i < points.critical_points.size(); ++i) {
    const CriticalPoint& p = points.critical_points[i];
    if (i >= solved.nodes.size() || p.valence != solved.nodes[i].valence ||
        !(distance(p.position, solved.nodes[i].position) <= tol))
      return "the node at " + position_text(face, p.position);
  }
  for (const Corner& c : points.corners)
    if (c.valence != solved_valence(solved, c.joint)) return "the corner at " + position_text(face, c.position);
  const auto position = [&](int curve, double t) { return curve::point(face.curves[curve], t); };
  for (size_t i = 0; i < points.boundary_nodes.size(); ++i) {
    const IrregularBoundaryPoint& b = points.boundary_nodes[i];
    if (i >= solved.boundary_nodes.size() || b.valence != solved.boundary_nodes[i].valence ||
        !(distance(position(b.curve, b.t), position(solved.boundary_nodes[i].curve, solved.boundary_nodes[i].t)) <=
          tol))
      return "the boundary node at " + position_text(face, b.position);
  }
  return "";
}

bool are_windings_equal(std::vector<int> a, std::vector<int> b, int num_holes) {
  a.resize(num_holes, 0), b.resize(num_holes, 0);
  return a == b;
}

void check_phase_nodes(const Field& field, const CriticalPoints& points) {
  const std::string difference = first_difference(field, points);
  if (!difference.empty())
    throw OtherNodesError(difference + " is not what the field was solved for: run fieldsolve --nodes");
  if (points.critical_points.size() != field.phase.prescribed.nodes.size() ||
      points.boundary_nodes.size() != field.phase.prescribed.boundary_nodes.size())
    throw OtherNodesError(
        fmt::format("the field was solved for {} irregular nodes and {} on the boundary, the file has {} and {}: run "
                    "fieldsolve --nodes",
                    field.phase.prescribed.nodes.size(), field.phase.prescribed.boundary_nodes.size(),
                    points.critical_points.size(), points.boundary_nodes.size()));
  if (!are_windings_equal(points.hole_winding_offsets, field.phase.hole_winding_offsets,
                          field.mesh.face.num_loops() - 1))
    throw OtherNodesError("the field was solved with other hole_winding_offsets: run fieldsolve --nodes");
}

}  // namespace

void check_nodes_match_field(const FieldEvaluator& evaluator, const CriticalPoints& points) {
  const Field& field = evaluator.field();
  const CadFace& face = field.mesh.face;
  for (const Corner& c : points.corners)
    if (c.joint < 0 || c.joint >= face.num_curves() || !face.joints[c.joint].is_corner)
      throw FormatError(fmt::format("joint {} of the critical points is not a corner of the field's face", c.joint));
  if (field.kind == FieldKind::phase)
    check_phase_nodes(field, points);
  else
    check_zeros(evaluator, points);
  const int sum = index_sum_of(points), expected = 4 * face.euler_characteristic();
  if (sum != expected)
    throw FormatError(fmt::format("the index sum of nodes and corners is {}, the domain requires {}", sum, expected));
}

}  // namespace quadrille::field
