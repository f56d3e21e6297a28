#include <algorithm>
#include <cmath>
#include <set>

#include "check/rules.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille::check {

namespace {

void arrays_agree(const Field& field, Findings& findings) {
  const std::size_t n = field.mesh.elem2vertices.size();
  if (field.elem_order.size() != n)
    findings.add("elem_order has {} entries for {} elements", field.elem_order.size(), n);
  if (!field.elem_sensor.empty() && field.elem_sensor.size() != n)
    findings.add("elem_sensor has {} entries for {} elements", field.elem_sensor.size(), n);
  if (!field.elem_error.empty() && field.elem_error.size() != n)
    findings.add("elem_error has {} entries for {} elements", field.elem_error.size(), n);
}

/// The phase of a region, and where its numbers are among those of the face: joints, curves and holes count from 0 in
/// each region.
struct RegionPhase {
  const PhaseForm& phase;
  int first_curve = 0, num_curves = 0, num_holes = 0;
  std::size_t num_coefs = 0;
};

/// Of a field of kind phase with sound coef_offsets; a missing member of region_phases counts as empty.
std::vector<RegionPhase> phases_of(const Field& field) {
  static const PhaseForm missing;
  const CadFace& face = field.mesh.face;
  const int num_regions = face.num_regions();
  if (num_regions == 1)
    return {
        {field.phase, 0, face.num_curves(), face.num_loops() - 1, static_cast<std::size_t>(field.coef_offsets.back())}};
  std::vector<RegionPhase> all;
  for (int r = 0; r < num_regions; ++r) {
    const int first_loop = face.region_loops[r], last_loop = face.region_loops[r + 1];
    const int first_curve = face.loop_offsets[first_loop];
    const auto coefs = [&](int region) { return field.coef_offsets[field.mesh.region_elems[region]]; };
    all.push_back({r < std::ssize(field.region_phases) ? field.region_phases[r] : missing, first_curve,
                   face.loop_offsets[last_loop] - first_curve, last_loop - first_loop - 1,
                   static_cast<std::size_t>(coefs(r + 1) - coefs(r))});
  }
  return all;
}

void coefficients_fit(const Field& field, Findings& findings) {
  const std::vector<int>& offsets = field.coef_offsets;
  const std::size_t n = field.elem_order.size();
  if (offsets.size() != n + 1 || offsets.front() != 0)
    return findings.add("coef_offsets must begin with 0 and have {} entries", n + 1);
  for (std::size_t e = 0; e < n; ++e) {
    const int order = field.elem_order[e];
    if (order < 1 || order > spectral::max_tri_order)
      return findings.add("element {}: order {} is outside 1 to {}", e, order, spectral::max_tri_order);
    if (static_cast<long long>(offsets[e + 1]) - offsets[e] != (order + 1) * (order + 2) / 2)
      return findings.add("element {} of order {} must own {} coefficients", e, order, (order + 1) * (order + 2) / 2);
  }
  const auto end = static_cast<std::size_t>(offsets.back());
  const bool is_phase = field.kind == FieldKind::phase;
  if (is_phase && (!field.u.empty() || !field.v.empty())) findings.add("u and v of a phase must be empty");
  if (is_phase)
    for (const RegionPhase& region : phases_of(field))
      if (region.phase.s.size() != region.num_coefs)
        findings.add("s has {} coefficients, not {}", region.phase.s.size(), region.num_coefs);
  if (!is_phase && (field.u.size() != end || field.v.size() != end))
    findings.add("u and v must have {} coefficients each", offsets.back());
}

void joints_exist(const Field& field, Findings& findings) {
  for (std::size_t i = 0; i < field.liftings.size(); ++i)
    if (!is_index(field.liftings[i].joint, field.mesh.face.joints.size()))
      findings.add("lifting {} names a joint that does not exist", i);
}

void numbers_are_finite(const Field& field, Findings& findings) {
  if (!are_finite(field.u) || !are_finite(field.v)) findings.add("u or v contains a number that is not finite");
  if (field.kind == FieldKind::phase)
    for (const RegionPhase& region : phases_of(field))
      if (!are_finite(region.phase.s)) findings.add("s contains a number that is not finite");
  if (!are_finite(field.elem_sensor)) findings.add("elem_sensor contains a number that is not finite");
  if (!are_finite(field.elem_error)) findings.add("elem_error contains a number that is not finite");
  for (std::size_t i = 0; i < field.liftings.size(); ++i) {
    const Lifting& lifting = field.liftings[i];
    if (!is_finite(lifting.apex) || !is_finite(lifting.pole) || !is_finite(lifting.jump))
      findings.add("lifting {} contains a number that is not finite", i);
  }
}

void kinds_are_known(const Field& field, Findings& findings) {
  if (field.kind != FieldKind::harmonic && field.kind != FieldKind::phase)
    findings.add("kind is not known; it must be harmonic or phase");
  if (field.method != FieldMethod::cg && field.method != FieldMethod::dg) findings.add("method is not cg or dg");
}

void liftings_fit(const Field& field, Findings& findings) {
  const CadFace& face = field.mesh.face;
  for (std::size_t i = 0; i < field.liftings.size(); ++i) {
    const Lifting& lifting = field.liftings[i];
    if (distance(lifting.apex, face.joints[lifting.joint].position) > 1e-9 * face.diameter)
      findings.add("lifting {}: its apex is not the position of joint {}", i, lifting.joint);
    if (lifting.apex == lifting.pole) findings.add("lifting {}: its pole is its apex", i);
    if (i > 0 && lifting.joint <= field.liftings[i - 1].joint)
      findings.add("liftings must be sorted by joint, one each; entry {} is not", i);
  }
}

void adapt_steps_are_sound(const Field& field, Findings& findings) {
  for (std::size_t i = 0; i < field.adapt_steps.size(); ++i) {
    const AdaptStep& step = field.adapt_steps[i];
    if (step.num_unknowns < 0 || step.num_raised < 0 || step.num_lowered < 0 || step.min_order < 1 ||
        step.max_order < step.min_order || !(step.max_sensor >= 0))
      findings.add("adapt step {}: counts must not be negative and min_order not above max_order", i);
    const std::size_t n = field.elem_order.size();
    if (step.elem_order.size() != step.elem_sensor.size() || (!step.elem_order.empty() && step.elem_order.size() != n))
      findings.add("adapt step {}: elem_order and elem_sensor must have {} entries or none", i, n);
    if (!are_finite(step.elem_sensor)) findings.add("adapt step {}: a sensor is not finite", i);
  }
}

void errors_are_sound(const Field& field, Findings& findings) {
  for (std::size_t e = 0; e < field.elem_error.size(); ++e)
    if (field.elem_error[e] < 0) findings.add("element {}: its error is negative", e);
}

constexpr int max_turns = 1000000;  // of a term or round a hole; more would use up the digits of the phase

void alignment_is_sound(const Field& field, Findings& findings) {
  for (std::size_t k = 0; k < field.alignment.size(); ++k) {
    const AlignmentPoint& point = field.alignment[k];
    const bool is_finite = std::isfinite(point.position.x) && std::isfinite(point.position.y) &&
                           std::isfinite(point.width) && std::isfinite(point.rate) && std::isfinite(point.angle);
    if (!is_finite || !(point.width > 0) || !(point.rate >= 0))
      findings.add("point {} of the alignment has a width that is not positive, a negative rate or no finite numbers",
                   k);
  }
  if (!field.alignment.empty() && field.method != FieldMethod::cg)
    findings.add("only fields of continuous elements (cg) are aligned");
}

bool is_bounded(int turns) { return turns >= -max_turns && turns <= max_turns; }

void turns_are_sound(const std::vector<PhaseTurn>& turns, const char* name, Findings& findings) {
  for (std::size_t k = 0; k < turns.size(); ++k)
    if (!is_finite(turns[k].position) || !is_bounded(turns[k].turns))
      findings.add("entry {} of terms/{}: not finite, or turns beyond {}", k, name, max_turns);
}

void hole_arrays_agree(const RegionPhase& region, Findings& findings) {
  const PhaseForm& phase = region.phase;
  const auto num_holes = static_cast<std::size_t>(region.num_holes);
  const auto require = [&](std::size_t size, const char* name) {
    if (size != num_holes) findings.add("{} has {} entries for {} holes", name, size, num_holes);
  };
  require(phase.terms.holes.size(), "terms/holes");
  require(phase.hole_winding.size(), "hole_winding");
  require(phase.best_hole_winding.size(), "best_hole_winding");
  require(phase.hole_periods.size(), "hole_periods");
  if (!phase.hole_winding_offsets.empty()) require(phase.hole_winding_offsets.size(), "hole_winding_offsets");
}

/// All terms that an evaluator adds up exist, are finite and are small enough to keep the digits of the phase.
void phase_is_sound(const RegionPhase& region, Findings& findings) {
  const PhaseForm& phase = region.phase;
  turns_are_sound(phase.terms.nodes, "nodes", findings);
  turns_are_sound(phase.terms.holes, "holes", findings);
  turns_are_sound(phase.terms.images, "images", findings);
  for (std::size_t i = 0; i < phase.terms.corner_angles.size(); ++i) {
    const CornerAngle& corner = phase.terms.corner_angles[i];
    if (!is_finite(corner.apex) || !is_finite(corner.pole) || !is_finite(corner.beta) || corner.apex == corner.pole)
      findings.add("corner angle {} is not finite, or its pole is its apex", i);
  }
  hole_arrays_agree(region, findings);
  if (!are_finite(phase.best_hole_winding) || !are_finite(phase.hole_periods) || !is_finite(phase.hole_winding_energy))
    findings.add("best_hole_winding, hole_periods or hole_winding_energy is not finite");
  if (!std::all_of(phase.hole_winding.begin(), phase.hole_winding.end(), is_bounded) ||
      !std::all_of(phase.hole_winding_offsets.begin(), phase.hole_winding_offsets.end(), is_bounded))
    findings.add("hole_winding or hole_winding_offsets: an entry is not between -{} and {}", max_turns, max_turns);
}

void phases_are_sound(const Field& field, Findings& findings) {
  if (field.kind != FieldKind::phase) return;
  if (!field.liftings.empty()) findings.add("a field of kind phase has no liftings");
  for (const RegionPhase& region : phases_of(field)) phase_is_sound(region, findings);
}

void prescribed_corners_exist(const RegionPhase& region, Findings& findings) {
  std::set<int> joints;
  for (const CornerValence& corner : region.phase.prescribed.corners) {
    if (!is_index(corner.joint, static_cast<std::size_t>(region.num_curves)))
      findings.add("joint {} does not exist", corner.joint);
    if (!joints.insert(corner.joint).second) findings.add("joint {} is listed twice", corner.joint);
    if (corner.valence < 0 || corner.valence > 4)
      findings.add("joint {}: valence {} is outside 0 to 4", corner.joint, corner.valence);
  }
}

void prescribed_boundary_nodes_exist(const CadFace& face, const RegionPhase& region, Findings& findings) {
  const std::vector<BoundaryNode>& nodes = region.phase.prescribed.boundary_nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const BoundaryNode& node = nodes[i];
    const auto has_parameter = [&](const Nurbs& curve) { return node.t >= curve.begin() && node.t <= curve.end(); };
    if (!is_index(node.curve, static_cast<std::size_t>(region.num_curves)))
      findings.add("boundary node {}: curve {} does not exist", i, node.curve);
    else if (!has_parameter(face.curves[region.first_curve + node.curve]))
      findings.add("boundary node {}: curve {} has no parameter {}", i, node.curve, node.t);
    if (node.valence < 1 || node.valence > 4 || node.valence == 2)
      findings.add("boundary node {}: valence {} must be 1, 3 or 4", i, node.valence);
  }
}

void nodes_are_prescribed(const PhaseForm& phase, Findings& findings) {
  const auto& prescribed = phase.prescribed.nodes;
  const auto& terms = phase.terms.nodes;
  if (terms.size() != prescribed.size())
    return findings.add("terms has {} nodes, {} are prescribed", terms.size(), prescribed.size());
  for (std::size_t k = 0; k < prescribed.size(); ++k) {
    if (prescribed[k].valence < 0 || prescribed[k].valence > 64 || prescribed[k].valence == 4)
      findings.add("node {}: valence {} must be 0 to 64 and not 4", k, prescribed[k].valence);
    if (terms[k].turns != 4LL - prescribed[k].valence || terms[k].position != prescribed[k].position)
      findings.add("node {} of the terms is not the prescribed one", k);
  }
}

void prescribed_index_sum_holds(const RegionPhase& region, Findings& findings) {
  const PhaseNodes& prescribed = region.phase.prescribed;
  long long sum = 0;
  for (const PhaseNode& node : prescribed.nodes) sum += 4LL - node.valence;
  for (const CornerValence& corner : prescribed.corners) sum += 2LL - corner.valence;
  for (const BoundaryNode& node : prescribed.boundary_nodes) sum += 2LL - node.valence;
  const int expected = 4 * (1 - region.num_holes);
  if (sum != expected) findings.add("the prescribed nodes have the index sum {}, not {}", sum, expected);
}

void terms_are_prescribed(const Field& field, Findings& findings) {
  if (field.kind != FieldKind::phase) return;
  for (const RegionPhase& region : phases_of(field)) {
    prescribed_corners_exist(region, findings);
    prescribed_boundary_nodes_exist(field.mesh.face, region, findings);
    nodes_are_prescribed(region.phase, findings);
    prescribed_index_sum_holds(region, findings);
  }
}

constexpr Rule<Field> field_rules[] = {
    {"FLD-R01", RuleKind::structure, arrays_agree},      {"FLD-R02", RuleKind::structure, coefficients_fit},
    {"FLD-R03", RuleKind::structure, joints_exist},      {"FLD-R04", RuleKind::structure, numbers_are_finite},
    {"FLD-R05", RuleKind::quick, kinds_are_known},       {"FLD-R06", RuleKind::quick, liftings_fit},
    {"FLD-R07", RuleKind::quick, adapt_steps_are_sound}, {"FLD-R08", RuleKind::quick, errors_are_sound},
    {"FLD-R09", RuleKind::quick, phases_are_sound},      {"FLD-R10", RuleKind::quick, terms_are_prescribed},
    {"FLD-R11", RuleKind::quick, alignment_is_sound},
};

}  // namespace

std::vector<Violation> violations_of(const Field& field, CheckDepth depth) {
  return apply_rules_after(field.mesh, field_rules, field, depth);
}

template std::vector<Violation> check_stage(const Field&, CheckDepth);

}  // namespace quadrille::check
