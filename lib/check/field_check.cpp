#include <algorithm>

#include "check/rules.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille {

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

void coefficients_fit(const Field& field, Findings& findings) {
  const std::vector<int>& offsets = field.coef_offsets;
  const std::size_t n = field.elem_order.size();
  if (offsets.size() != n + 1 || offsets.front() != 0)
    return findings.add("coef_offsets must begin with 0 and have {} entries", n + 1);
  for (std::size_t e = 0; e < n; ++e) {
    const int order = field.elem_order[e];
    if (order < 1 || order > max_tri_order)
      return findings.add("element {}: order {} is outside 1 to {}", e, order, max_tri_order);
    if (static_cast<long long>(offsets[e + 1]) - offsets[e] != (order + 1) * (order + 2) / 2)
      return findings.add("element {} of order {} must own {} coefficients", e, order, (order + 1) * (order + 2) / 2);
  }
  const auto end = static_cast<std::size_t>(offsets.back());
  const bool is_phase = field.kind == "phase";
  if (is_phase && (field.phase.s.size() != end || !field.u.empty() || !field.v.empty()))
    findings.add("s must have {} coefficients, u and v none", offsets.back());
  if (!is_phase && (field.u.size() != end || field.v.size() != end))
    findings.add("u and v must have {} coefficients each", offsets.back());
}

void joints_exist(const Field& field, Findings& findings) {
  for (std::size_t i = 0; i < field.liftings.size(); ++i)
    if (!is_index(field.liftings[i].joint, field.mesh.face.joints.size()))
      findings.add("lifting {} names a joint that does not exist", i);
}

void numbers_are_finite(const Field& field, Findings& findings) {
  if (!are_finite(field.u) || !are_finite(field.v)) findings.add("u or v holds a number that is not finite");
  if (!are_finite(field.phase.s)) findings.add("s holds a number that is not finite");
  if (!are_finite(field.elem_sensor)) findings.add("elem_sensor holds a number that is not finite");
  if (!are_finite(field.elem_error)) findings.add("elem_error holds a number that is not finite");
  for (std::size_t i = 0; i < field.liftings.size(); ++i) {
    const Lifting& lifting = field.liftings[i];
    if (!is_finite(lifting.apex) || !is_finite(lifting.pole) || !is_finite(lifting.jump))
      findings.add("lifting {} holds a number that is not finite", i);
  }
}

void kinds_are_known(const Field& field, Findings& findings) {
  if (field.kind != "harmonic" && field.kind != "phase")
    findings.add("kind '{}' is not known; it must be harmonic or phase", field.kind);
  if (field.method != "cg" && field.method != "dg") findings.add("method '{}' is not cg or dg", field.method);
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

bool is_sound(const std::vector<PhaseTurn>& turns) {
  return std::all_of(turns.begin(), turns.end(), [](const PhaseTurn& turn) { return is_finite(turn.position); });
}

void phase_is_sound(const Field& field, Findings& findings) {
  if (field.kind != "phase") return;
  const CadFace& face = field.mesh.face;
  const PhaseForm& phase = field.phase;
  if (!field.liftings.empty()) findings.add("a field of kind phase has no liftings");
  if (!is_sound(phase.terms.nodes) || !is_sound(phase.terms.holes) || !is_sound(phase.terms.images))
    findings.add("a term of the phase holds a number that is not finite");
  for (const CornerAngle& corner : phase.terms.corner_angles)
    if (!is_finite(corner.apex) || !is_finite(corner.pole) || !is_finite(corner.beta) || corner.apex == corner.pole)
      findings.add("a corner angle of the phase is not finite, or its pole is its apex");
  const std::size_t num_holes = face.num_loops() - 1;
  if (phase.terms.holes.size() != num_holes || phase.twists.size() != num_holes ||
      phase.best_twists.size() != num_holes || phase.periods.size() != num_holes ||
      (!phase.twist_offsets.empty() && phase.twist_offsets.size() != num_holes))
    findings.add("holes, twists, best_twists and periods must have {} entries, one a hole", num_holes);
  if (phase.terms.nodes.size() != phase.nodes.nodes.size())
    findings.add("terms has {} nodes, {} were asked for", phase.terms.nodes.size(), phase.nodes.nodes.size());
  for (std::size_t k = 0; k < std::min(phase.terms.nodes.size(), phase.nodes.nodes.size()); ++k)
    if (phase.terms.nodes[k].turns != 4 - phase.nodes.nodes[k].valence ||
        phase.terms.nodes[k].position != phase.nodes.nodes[k].position)
      findings.add("node {} of the terms is not the one asked for", k);
  for (const CornerValence& corner : phase.nodes.corners)
    if (!is_index(corner.joint, face.joints.size())) findings.add("joint {} does not exist", corner.joint);
  for (const BoundaryNode& node : phase.nodes.boundary_nodes)
    if (!is_index(node.curve, face.curves.size())) findings.add("curve {} does not exist", node.curve);
}

constexpr Rule<Field> rules[] = {
    {"FLD-R01", RuleKind::structure, arrays_agree},      {"FLD-R02", RuleKind::structure, coefficients_fit},
    {"FLD-R03", RuleKind::structure, joints_exist},      {"FLD-R04", RuleKind::structure, numbers_are_finite},
    {"FLD-R05", RuleKind::quick, kinds_are_known},       {"FLD-R06", RuleKind::quick, liftings_fit},
    {"FLD-R07", RuleKind::quick, adapt_steps_are_sound}, {"FLD-R08", RuleKind::quick, errors_are_sound},
    {"FLD-R09", RuleKind::quick, phase_is_sound},
};

}  // namespace

std::vector<Violation> check_field(const Field& field, CheckDepth depth) {
  std::vector<Violation> all = check_tri_mesh(field.mesh, depth);
  if (!all.empty()) return all;
  return apply_rules(rules, field, depth);
}

}  // namespace quadrille
