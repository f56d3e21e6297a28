#include <algorithm>
#include <numeric>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "check/rules.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::check {

namespace {

constexpr int max_winding = 1000000;  // whole turns; more would use up the digits of the phase

bool is_sound(const CriticalPoint& p) {
  return is_finite(p.position) && is_finite(p.xi) && is_finite(p.error) &&
         std::all_of(p.jacobian.begin(), p.jacobian.end(), [](double d) { return is_finite(d); });
}

bool is_sound(const NodeChange& change) {
  const auto is_finite_mark = [](const NodeMark& mark) { return is_finite(mark.position); };
  return std::all_of(change.before.begin(), change.before.end(), is_finite_mark) &&
         std::all_of(change.after.begin(), change.after.end(), is_finite_mark);
}

bool is_sound(const Certificate& c) {
  const auto is_finite_cell = [](const CertificateCell& cell) {
    return std::all_of(cell.vertices.begin(), cell.vertices.end(), [](double x) { return is_finite(x); });
  };
  return are_finite(c.disc_centres) && are_finite(c.disc_radii) && is_finite(c.cells_examined) &&
         is_finite(c.cells_excluded) && is_finite(c.cells_isolated) && is_finite(c.cells_left_to_corners) &&
         std::all_of(c.cells.begin(), c.cells.end(), is_finite_cell);
}

template <typename Entry, typename IsSound>
void each_is_finite(const std::vector<Entry>& list, const char* name, const IsSound& sound, Findings& findings) {
  for (std::size_t i = 0; i < list.size(); ++i)
    if (!sound(list[i])) findings.add("{} {} contains a number that is not finite", name, i);
}

void numbers_are_finite(const CriticalPoints& points, Findings& findings) {
  if (!is_finite(points.origin)) findings.add("origin is not finite");
  const auto point_is_sound = [](const CriticalPoint& p) { return is_sound(p); };
  each_is_finite(points.critical_points, "critical point", point_is_sound, findings);
  each_is_finite(points.zeros, "zero", point_is_sound, findings);
  each_is_finite(
      points.corners, "corner", [](const Corner& c) { return is_finite(c.position) && is_finite(c.angle_degrees); },
      findings);
  each_is_finite(
      points.boundary_nodes, "boundary node",
      [](const IrregularBoundaryPoint& b) { return is_finite(b.position) && is_finite(b.t); }, findings);
  each_is_finite(
      points.clusters, "cluster",
      [](const Cluster& c) { return is_finite(c.centre) && is_finite(c.radius) && are_finite(c.members); }, findings);
  each_is_finite(
      points.changes, "change", [](const NodeChange& c) { return is_sound(c); }, findings);
  if (!is_sound(points.certificate)) findings.add("the certificate contains a number that is not finite");
}

void valences_fit_indices(const CriticalPoints& points, Findings& findings) {
  for (std::size_t i = 0; i < points.critical_points.size(); ++i) {
    const CriticalPoint& p = points.critical_points[i];
    if (p.index == 0 || p.index > 4 || p.index < -60 || p.valence != 4 - p.index)
      findings.add("critical point {}: valence {} must be 4 - index, and index {} between -60 and 4 and not 0", i,
                   p.valence, p.index);
  }
}

void elements_are_sound(const CriticalPoints& points, Findings& findings) {
  for (std::size_t i = 0; i < points.critical_points.size(); ++i) {
    const CriticalPoint& p = points.critical_points[i];
    if (p.elem < 0) findings.add("critical point {}: elem is negative", i);
    if (std::min(p.xi.x, p.xi.y) < -1 - tolerance::same_point || p.xi.x + p.xi.y > tolerance::same_point)
      findings.add("critical point {}: xi lies outside the reference triangle", i);
  }
}

void corners_are_sound(const CriticalPoints& points, Findings& findings) {
  for (std::size_t i = 0; i < points.corners.size(); ++i) {
    const Corner& c = points.corners[i];
    if (c.joint < 0 || (i > 0 && c.joint <= points.corners[i - 1].joint))
      findings.add("corners must be sorted by joint; entry {} is not", i);
    if (c.curves[0] < 0 || c.curves[1] < 0) findings.add("corner {}: a curve is negative", i);
    const bool is_full_circle = std::abs(c.angle_degrees - 360) < 1e-6 && is_slit_tip(points.face, c.joint);
    if (!is_full_circle && (!(c.angle_degrees > 0) || !(c.angle_degrees < 360)))
      findings.add("corner {}: its angle is not in (0, 360), or 360 at the end of a slit", i);
    if (c.valence < 0 || c.valence > 4) findings.add("corner {}: valence {} is outside 0 to 4", i, c.valence);
  }
}

void index_sum_is_right(const CriticalPoints& points, Findings& findings) {
  long long nodes = 0, corners = 0, boundary = 0;  // a damaged file may contain valences of any size
  for (const CriticalPoint& p : points.critical_points) nodes += 4LL - p.valence;
  for (const Corner& c : points.corners) corners += 2LL - c.valence;
  for (const IrregularBoundaryPoint& b : points.boundary_nodes) boundary += 2LL - b.valence;
  if (nodes + corners + boundary != points.index_sum)
    findings.add(
        "index_sum.value is {}, but the lists add up to {}: 4 - V over {} critical points {}, 2 - V over {} corners "
        "{}, over {} boundary nodes {}",
        points.index_sum, nodes + corners + boundary, points.critical_points.size(), nodes, points.corners.size(),
        corners, points.boundary_nodes.size(), boundary);
}

void index_sum_holds(const CriticalPoints& points, Findings& findings) {
  const int expected = points.index_sum_expected;
  if (!points.face.curves.empty() && expected != 4 * points.face.euler_characteristic())
    findings.add("index_sum.expected is {}: it must be {}, 4 for each region of the face less 4 for each hole",
                 expected, 4 * points.face.euler_characteristic());
  else if (points.face.curves.empty() && (expected > 4 || expected % 4 != 0))
    findings.add("index_sum.expected is {}: it must be 4, or 4 less for each hole", expected);
  if (points.index_sum != points.index_sum_expected)
    findings.add("the index sum is {}, not {}", points.index_sum, points.index_sum_expected);
}

void jacobians_fit_indices(const CriticalPoints& points, Findings& findings) {
  for (std::size_t i = 0; i < points.critical_points.size(); ++i) {
    const CriticalPoint& p = points.critical_points[i];
    const double det = p.jacobian[0] * p.jacobian[3] - p.jacobian[1] * p.jacobian[2];
    if ((p.index == 1 || p.index == -1) && det * p.index < 0)
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
        findings.add("critical points {} and {} coincide", i, j);
}

void errors_are_sound(const CriticalPoints& points, Findings& findings) {
  for (std::size_t i = 0; i < points.critical_points.size(); ++i)
    if (points.critical_points[i].error < 0) findings.add("critical point {}: its error is negative", i);
}

void form_fits_lists(const CriticalPoints& points, Findings& findings) {
  if (points.form == NodeForm::harmonic && (!points.boundary_nodes.empty() || !points.hole_winding_offsets.empty()))
    findings.add("boundary_nodes and hole_winding_offsets are for the form phase; a harmonic field has none");
}

void boundary_nodes_are_sound(const CriticalPoints& points, Findings& findings) {
  const auto& list = points.boundary_nodes;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].curve < 0) findings.add("boundary node {}: its curve is negative", i);
    if (list[i].valence < 1 || list[i].valence > 4 || list[i].valence == 2)
      findings.add("boundary node {}: valence {} must be 1, 3 or 4", i, list[i].valence);
    for (std::size_t j = 0; j < i; ++j)
      if (list[i].curve == list[j].curve && list[i].t == list[j].t)
        findings.add("boundary nodes {} and {} coincide", j, i);
  }
  for (const int offset : points.hole_winding_offsets)
    if (std::abs(static_cast<double>(offset)) > max_winding)
      findings.add("hole_winding_offsets: {} is not between -{} and {}", offset, max_winding, max_winding);
}

void zeros_are_sound(const CriticalPoints& points, Findings& findings) {
  for (std::size_t i = 0; i < points.zeros.size(); ++i)
    if (points.zeros[i].elem < 0 || points.zeros[i].error < 0)
      findings.add("zero {}: its element or its error is negative", i);
}

void clusters_are_sound(const CriticalPoints& points, Findings& findings) {
  for (std::size_t i = 0; i < points.clusters.size(); ++i) {
    const Cluster& c = points.clusters[i];
    if (c.radius < 0) findings.add("cluster {}: its radius is negative", i);
    if (c.member_indices.empty()) continue;
    const long long sum = std::accumulate(c.member_indices.begin(), c.member_indices.end(), 0LL);
    if (c.member_indices.size() != c.members.size())
      findings.add("cluster {}: {} member_indices for {} members", i, c.member_indices.size(), c.members.size());
    else if (sum != c.index)
      findings.add("cluster {}: its index is {}, its members' add up to {}", i, c.index, sum);
  }
}

void certificate_is_sound(const CriticalPoints& points, Findings& findings) {
  const Certificate& c = points.certificate;
  if (c.elements < 0 || c.greatest_depth < 0 || c.cells_examined < 0 || c.cells_excluded < 0 || c.cells_isolated < 0 ||
      c.cells_left_to_corners < 0)
    findings.add("certificate: a count is negative");
  for (std::size_t i = 0; i < c.cells.size(); ++i)
    if (c.cells[i].elem < 0) findings.add("certificate: the element of cell {} is negative", i);
  if (c.disc_centres.size() != c.disc_radii.size())
    findings.add("certificate: {} disc_centres, but {} disc_radii", c.disc_centres.size(), c.disc_radii.size());
  if (std::any_of(c.disc_radii.begin(), c.disc_radii.end(), [](double r) { return r < 0; }))
    findings.add("certificate: a radius is negative");
}

/// The record of the search: used by reports and pictures only, but it must be correct.
void findings_of_the_search_are_sound(const CriticalPoints& points, Findings& findings) {
  zeros_are_sound(points, findings);
  clusters_are_sound(points, findings);
  certificate_is_sound(points, findings);
}

long long index_of(const std::vector<NodeMark>& marks) {
  long long sum = 0;
  for (const NodeMark& mark : marks) sum += (mark.location == NodeLocation::inside ? 4LL : 2LL) - mark.valence;
  return sum;
}

void changes_keep_the_index_sum(const CriticalPoints& points, Findings& findings) {
  for (std::size_t i = 0; i < points.changes.size(); ++i) {
    const NodeChange& change = points.changes[i];
    // The index before the changes is undefined for a field that vanishes on whole curves.
    if (change.kind != ChangeKind::line && index_of(change.before) != index_of(change.after))
      findings.add("change {} ({}): index {} before, {} after", i, enum_name(change.kind), index_of(change.before),
                   index_of(change.after));
  }
}

constexpr Rule<CriticalPoints> critical_points_rules[] = {
    {"CRT-R01", RuleKind::structure, numbers_are_finite},
    {"CRT-R02", RuleKind::quick, valences_fit_indices},
    {"CRT-R03", RuleKind::quick, elements_are_sound},
    {"CRT-R04", RuleKind::quick, corners_are_sound},
    {"CRT-R05", RuleKind::quick, index_sum_is_right},
    {"CRT-R06", RuleKind::quick, index_sum_holds},
    {"CRT-R07", RuleKind::full, jacobians_fit_indices},
    {"CRT-R08", RuleKind::quick, points_differ},
    {"CRT-R11", RuleKind::quick, errors_are_sound},
    {"CRT-R12", RuleKind::quick, form_fits_lists},
    {"CRT-R13", RuleKind::quick, boundary_nodes_are_sound},
    {"CRT-R15", RuleKind::quick, findings_of_the_search_are_sound},
    {"CRT-R16", RuleKind::full, changes_keep_the_index_sum},
};

/// Critical points checked against the field that they refer to.
struct PointsOfMesh {
  const CriticalPoints& points;
  const TriMesh& mesh;
};

void elements_exist(const PointsOfMesh& pair, Findings& findings) {
  const auto& list = pair.points.critical_points;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (!is_index(list[i].elem, pair.mesh.elem2vertices.size()))
      findings.add("critical point {}: the field has no element {}", i, list[i].elem);
}

void corners_are_the_faces(const PointsOfMesh& pair, Findings& findings) {
  const CadFace& face = pair.mesh.face;
  std::size_t next = 0;
  const auto& corners = pair.points.corners;
  for (int j = 0; j < face.num_curves(); ++j) {
    if (!face.joints[j].is_corner) continue;
    if (next == corners.size() || corners[next].joint != j)
      return findings.add("the corner at {} (joint {}) is missing or out of order",
                          position_text(face, face.joints[j].position), j);
    const Corner& c = corners[next++];
    if (c.curves[0] != face.previous_in_loop(j) || c.curves[1] != j)
      findings.add("corner {}: its curves are {} and {}", next - 1, face.previous_in_loop(j), j);
    if (distance(c.position, face.joints[j].position) > 1e-9 * face.diameter ||
        std::abs(c.angle_degrees - degrees(face.joints[j].interior_angle)) > 1e-6)
      findings.add("corner {}: position or angle differs from that of joint {}", next - 1, j);
  }
  if (next != corners.size()) findings.add("corner {}: joint {} is not a corner", next, corners[next].joint);
}

void boundary_nodes_lie_on_curves(const PointsOfMesh& pair, Findings& findings) {
  const CadFace& face = pair.mesh.face;
  for (std::size_t i = 0; i < pair.points.boundary_nodes.size(); ++i) {
    const IrregularBoundaryPoint& b = pair.points.boundary_nodes[i];
    if (!is_index(b.curve, face.curves.size())) {
      findings.add("boundary node {}: the face has no curve {}", i, b.curve);
      continue;
    }
    const Nurbs& curve = face.curves[b.curve];
    if (b.t < curve.begin() || b.t > curve.end())
      findings.add("boundary node {}: curve {} has no parameter {}, only {} to {}", i, b.curve, b.t, curve.begin(),
                   curve.end());
    else if (const Vec2 on_curve = curve::point(curve, b.t); distance(on_curve, b.position) > 1e-9 * face.diameter)
      findings.add(
          "boundary node {}: its position is not that of curve {} there, which is ({}, {}) relative to the origin", i,
          b.curve, on_curve.x, on_curve.y);
  }
  const std::size_t num_offsets = pair.points.hole_winding_offsets.size();
  const int num_holes = face.num_loops() - face.num_regions();
  if (num_offsets != 0 && num_offsets != static_cast<std::size_t>(num_holes))
    findings.add("hole_winding_offsets has {} entries for {} holes", num_offsets, num_holes);
}

constexpr Rule<PointsOfMesh> rules_with_field[] = {
    {"CRT-R09", RuleKind::quick, elements_exist},
    {"CRT-R10", RuleKind::quick, corners_are_the_faces},
    {"CRT-R14", RuleKind::quick, boundary_nodes_lie_on_curves},
};

}  // namespace

std::vector<Violation> violations_of(const CriticalPoints& points, CheckDepth depth) {
  if (points.face.curves.empty()) return apply_rules(critical_points_rules, points, depth);
  return apply_rules_after(points.face, critical_points_rules, points, depth);
}

std::vector<Violation> check_critical_points_of(const CriticalPoints& points, const TriMesh& mesh) {
  return apply_rules(rules_with_field, PointsOfMesh{points, mesh}, CheckDepth::quick);
}

template std::vector<Violation> check_stage(const CriticalPoints&, CheckDepth);

}  // namespace quadrille::check
