#include <algorithm>

#include "base/angle.hpp"
#include "check/rules.hpp"

namespace quadrille {

namespace {

void numbers_are_finite(const CriticalPoints& points, Findings& findings) {
  if (!is_finite(points.origin)) findings.add("origin is not finite");
  for (std::size_t i = 0; i < points.critical_points.size(); ++i) {
    const CriticalPoint& p = points.critical_points[i];
    bool is_sound = is_finite(p.position) && is_finite(p.xi) && is_finite(p.error);
    for (const double d : p.jacobian) is_sound = is_sound && is_finite(d);
    if (!is_sound) findings.add("critical point {} holds a number that is not finite", i);
  }
  for (std::size_t i = 0; i < points.corners.size(); ++i)
    if (!is_finite(points.corners[i].position) || !is_finite(points.corners[i].angle_degrees))
      findings.add("corner {} holds a number that is not finite", i);
}

void valences_fit_indices(const CriticalPoints& points, Findings& findings) {
  for (std::size_t i = 0; i < points.critical_points.size(); ++i) {
    const CriticalPoint& p = points.critical_points[i];
    if (p.valence != 4 - p.index || p.index == 0 || p.index > 4 || p.index < -60)
      findings.add("critical point {}: valence {} must be 4 - index, and index {} between -60 and 4 and not 0", i,
                   p.valence, p.index);
  }
}

void elements_are_sound(const CriticalPoints& points, Findings& findings) {
  constexpr double tol = 1e-6;
  for (std::size_t i = 0; i < points.critical_points.size(); ++i) {
    const CriticalPoint& p = points.critical_points[i];
    if (p.elem < 0) findings.add("critical point {}: elem is negative", i);
    if (p.xi.x < -1 - tol || p.xi.y < -1 - tol || p.xi.x + p.xi.y > tol)
      findings.add("critical point {}: xi lies outside the reference triangle", i);
  }
}

void corners_are_sound(const CriticalPoints& points, Findings& findings) {
  for (std::size_t i = 0; i < points.corners.size(); ++i) {
    const Corner& c = points.corners[i];
    if (c.joint < 0 || (i > 0 && c.joint <= points.corners[i - 1].joint))
      findings.add("corners must be sorted by joint; entry {} is not", i);
    if (c.curves[0] < 0 || c.curves[1] < 0) findings.add("corner {}: a curve is negative", i);
    if (!(c.angle_degrees > 0) || !(c.angle_degrees < 360)) findings.add("corner {}: its angle is not in (0, 360)", i);
    if (c.valence < 0 || c.valence > 4) findings.add("corner {}: valence {} is outside 0 to 4", i, c.valence);
  }
}

void index_sum_is_right(const CriticalPoints& points, Findings& findings) {
  int nodes = 0, corners = 0, boundary = 0;
  for (const CriticalPoint& p : points.critical_points) nodes += 4 - p.valence;
  for (const Corner& c : points.corners) corners += 2 - c.valence;
  for (const IrregularBoundaryPoint& b : points.boundary_nodes) boundary += 2 - b.valence;
  if (nodes + corners + boundary != points.index_sum)
    findings.add(
        "index_sum.value is {}, but the lists add up to {}: 4 - V over {} critical points {}, 2 - V over {} corners "
        "{}, over {} boundary nodes {}",
        points.index_sum, nodes + corners + boundary, points.critical_points.size(), nodes, points.corners.size(),
        corners, points.boundary_nodes.size(), boundary);
}

void index_sum_holds(const CriticalPoints& points, Findings& findings) {
  if (points.index_sum_expected > 4 || points.index_sum_expected % 4 != 0)
    findings.add("index_sum.expected is {}: it must be 4, or 4 less for each hole", points.index_sum_expected);
  if (points.index_sum != points.index_sum_expected)
    findings.add("the index sum is {}, not {}", points.index_sum, points.index_sum_expected);
}

void jacobians_fit_indices(const CriticalPoints& points, Findings& findings) {
  for (std::size_t i = 0; i < points.critical_points.size(); ++i) {
    const CriticalPoint& p = points.critical_points[i];
    const double det = p.jacobian[0] * p.jacobian[3] - p.jacobian[1] * p.jacobian[2];
    if (std::abs(p.index) == 1 && det * p.index < 0)
      findings.add("critical point {}: index {} and the sign of its Jacobian's determinant disagree", i, p.index);
  }
}

void points_differ(const CriticalPoints& points, Findings& findings) {
  const auto& list = points.critical_points;
  double extent = 0;
  for (const CriticalPoint& p : list) extent = std::max({extent, std::abs(p.position.x), std::abs(p.position.y)});
  for (const Corner& c : points.corners) extent = std::max({extent, std::abs(c.position.x), std::abs(c.position.y)});
  for (std::size_t i = 0; i < list.size(); ++i)
    for (std::size_t j = i + 1; j < list.size(); ++j)
      if (distance(list[i].position, list[j].position) <= 1e-10 * extent)
        findings.add("critical points {} and {} are at one place", i, j);
}

void errors_are_sound(const CriticalPoints& points, Findings& findings) {
  for (std::size_t i = 0; i < points.critical_points.size(); ++i)
    if (points.critical_points[i].error < 0) findings.add("critical point {}: its error is negative", i);
}

void forms_are_known(const CriticalPoints& points, Findings& findings) {
  if (points.form != "harmonic" && points.form != "phase")
    findings.add("form '{}' is not known; it must be harmonic or phase", points.form);
}

void boundary_nodes_are_sound(const CriticalPoints& points, Findings& findings) {
  for (std::size_t i = 0; i < points.boundary_nodes.size(); ++i) {
    const IrregularBoundaryPoint& b = points.boundary_nodes[i];
    if (!is_finite(b.t) || !is_finite(b.position) || b.curve < 0)
      findings.add("boundary node {}: a number is not finite or its curve negative", i);
    if (b.valence < 1 || b.valence > 4 || b.valence == 2)
      findings.add("boundary node {}: valence {} must be 1, 3 or 4", i, b.valence);
  }
}

constexpr Rule<CriticalPoints> rules[] = {
    {"CRT-R01", RuleKind::structure, numbers_are_finite},   {"CRT-R02", RuleKind::quick, valences_fit_indices},
    {"CRT-R03", RuleKind::quick, elements_are_sound},       {"CRT-R04", RuleKind::quick, corners_are_sound},
    {"CRT-R05", RuleKind::quick, index_sum_is_right},       {"CRT-R06", RuleKind::quick, index_sum_holds},
    {"CRT-R07", RuleKind::full, jacobians_fit_indices},     {"CRT-R08", RuleKind::quick, points_differ},
    {"CRT-R11", RuleKind::quick, errors_are_sound},         {"CRT-R12", RuleKind::quick, forms_are_known},
    {"CRT-R13", RuleKind::quick, boundary_nodes_are_sound},
};

/// Critical points beside the field that they are said to be of.
struct PointsOfField {
  const CriticalPoints& points;
  const Field& field;
};

void elements_exist(const PointsOfField& pair, Findings& findings) {
  const auto& list = pair.points.critical_points;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (!is_index(list[i].elem, pair.field.mesh.elem2vertices.size()))
      findings.add("critical point {}: the field has no element {}", i, list[i].elem);
}

void corners_are_the_faces(const PointsOfField& pair, Findings& findings) {
  const CadFace& face = pair.field.mesh.face;
  std::size_t next = 0;
  const auto& corners = pair.points.corners;
  for (int j = 0; j < face.num_curves(); ++j) {
    if (!face.joints[j].is_corner) continue;
    if (next == corners.size() || corners[next].joint != j)
      return findings.add("the corner at {} (joint {}) is not listed in its place",
                          place(face, face.joints[j].position), j);
    const Corner& c = corners[next++];
    if (c.curves[0] != face.previous_in_loop(j) || c.curves[1] != j)
      findings.add("corner {}: its curves are {} and {}", next - 1, face.previous_in_loop(j), j);
    if (distance(c.position, face.joints[j].position) > 1e-9 * face.diameter ||
        std::abs(c.angle_degrees - degrees(face.joints[j].interior_angle)) > 1e-6)
      findings.add("corner {}: position or angle differs from that of joint {}", next - 1, j);
  }
  if (next != corners.size()) findings.add("corner {}: joint {} is no corner", next, corners[next].joint);
}

void boundary_nodes_lie_on_curves(const PointsOfField& pair, Findings& findings) {
  const CadFace& face = pair.field.mesh.face;
  for (std::size_t i = 0; i < pair.points.boundary_nodes.size(); ++i) {
    const IrregularBoundaryPoint& b = pair.points.boundary_nodes[i];
    if (!is_index(b.curve, face.curves.size()))
      findings.add("boundary node {}: the face has no curve {}", i, b.curve);
    else if (b.t < face.curves[b.curve].begin() || b.t > face.curves[b.curve].end())
      findings.add("boundary node {}: curve {} has no parameter {}", i, b.curve, b.t);
  }
  const std::size_t num_offsets = pair.points.twist_offsets.size();
  if (num_offsets != 0 && static_cast<int>(num_offsets) != face.num_loops() - 1)
    findings.add("twist_offsets has {} entries for {} holes", num_offsets, face.num_loops() - 1);
}

constexpr Rule<PointsOfField> rules_with_field[] = {
    {"CRT-R09", RuleKind::quick, elements_exist},
    {"CRT-R10", RuleKind::quick, corners_are_the_faces},
    {"CRT-R14", RuleKind::quick, boundary_nodes_lie_on_curves},
};

}  // namespace

std::vector<Violation> check_critical_points(const CriticalPoints& points, CheckDepth depth) {
  return apply_rules(rules, points, depth);
}

std::vector<Violation> check_critical_points_of(const CriticalPoints& points, const Field& field) {
  return apply_rules(rules_with_field, PointsOfField{points, field}, CheckDepth::quick);
}

}  // namespace quadrille
