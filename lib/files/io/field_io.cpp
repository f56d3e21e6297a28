#include "io/describe.hpp"

namespace quadrille::io {

namespace {

void describe_turn(Archive& a, PhaseTurn& turn) {
  a.field("position", turn.position);
  a.field("turns", turn.turns);
}

void describe_phase_nodes(Archive& archive, PhaseNodes& nodes) {
  archive.field("nodes", nodes.nodes, [](Archive& a, PhaseNode& node) {
    a.field("position", node.position, {"length", "a_k"});
    a.field("valence", node.valence);
  });
  archive.field("corners", nodes.corners, [](Archive& a, CornerValence& corner) {
    a.field("joint", corner.joint);
    a.field("valence", corner.valence);
  });
  archive.field("boundary_nodes", nodes.boundary_nodes, [](Archive& a, BoundaryNode& node) {
    a.field("curve", node.curve);
    a.field("t", node.t);
    a.field("valence", node.valence);
  });
}

void describe_phase_terms(Archive& archive, PhaseTerms& terms) {
  archive.field("nodes", terms.nodes, describe_turn);
  archive.field("holes", terms.holes, describe_turn);
  archive.field("images", terms.images, describe_turn);
  archive.field("corner_angles", terms.corner_angles, [](Archive& a, CornerAngle& corner) {
    a.field("apex", corner.apex, {"length", "c"});
    a.field("pole", corner.pole, {"length", "p_c, outside the domain"});
    a.field("beta", corner.beta, {"1", "4 - 2 pi V / omega"});
  });
}

void describe_phase_form(Archive& archive, PhaseForm& phase) {
  archive.object("prescribed", [&](Archive& a) { describe_phase_nodes(a, phase.prescribed); });
  archive.object("terms", [&](Archive& a) { describe_phase_terms(a, phase.terms); });
  archive.field("s", phase.s, {"radian", "coefficients of s in the orthonormal Dubiner basis"});
  archive.field("hole_winding_offsets", phase.hole_winding_offsets, {"", "prescribed, one for each hole or none"});
  archive.field("best_hole_winding", phase.best_hole_winding, {"1", "real winding of least energy, for each hole"});
  archive.field("hole_winding", phase.hole_winding, {"", "m_j, integers"});
  archive.field("hole_periods", phase.hole_periods, {"radian", "of lambda round each hole"});
  archive.field("hole_winding_energy", phase.hole_winding_energy, {"1", "energy above that of best_hole_winding"});
}

/// One group "0", "1", ... for each region.
void describe_region_phases(Archive& archive, const CadFace& face, std::vector<PhaseForm>& phases) {
  for (int r = 0; r < face.num_regions(); ++r) {
    if (archive.is_reading()) phases.emplace_back();
    archive.object(std::to_string(r).c_str(), [&](Archive& a) { describe_phase_form(a, phases[r]); });
  }
}

void describe_phases(Archive& archive, Field& field) {
  if (field.kind != FieldKind::phase) return;
  if (field.mesh.face.num_regions() == 1)
    archive.object("phase", [&](Archive& a) { describe_phase_form(a, field.phase); });
  else
    archive.object("region_phases",
                   [&](Archive& a) { describe_region_phases(a, field.mesh.face, field.region_phases); });
}

}  // namespace

void describe(Archive& archive, Field& field) {
  archive.field("kind", field.kind, {"", "harmonic or phase"}, "FLD-R05");
  archive.field("method", field.method, {"", "discretisation"}, "FLD-R05");
  archive.object("mesh", [&](Archive& a) { describe_triangles(a, field.mesh); });
  archive.field("elem_order", field.elem_order, {"", "polynomial order of the field on each element"});
  archive.field("coef_offsets", field.coef_offsets, {"", "coefficients of element e: coef_offsets[e] to [e+1]-1"});
  archive.field("u", field.u, {"1", "coefficients of u in the orthonormal Dubiner basis"});
  archive.field("v", field.v, {"1", "coefficients of v in the orthonormal Dubiner basis"});
  archive.field("liftings", field.liftings, [](Archive& a, Lifting& lifting) {
    a.field("joint", lifting.joint, {"", "joint of the face"});
    a.field("apex", lifting.apex, {"length", "the joint's position"});
    a.field("pole", lifting.pole, {"length", "a point outside the domain"});
    a.field("jump", lifting.jump, {"1/radian", "field value per radian"});
  });
  describe_phases(archive, field);
  archive.field("elem_sensor", field.elem_sensor, {"1", "last sensor of each element; empty before padapt"});
  archive.later_field("elem_error", field.elem_error,
                      {"1", "estimated error of the field on each element; empty: none"});
  archive.field("adapt_steps", field.adapt_steps, [](Archive& a, AdaptStep& step) {
    a.field("num_unknowns", step.num_unknowns);
    a.field("num_raised", step.num_raised);
    a.field("num_lowered", step.num_lowered);
    a.field("min_order", step.min_order);
    a.field("max_order", step.max_order);
    a.field("max_sensor", step.max_sensor, {"1", "largest sensor of the round"});
    a.later_field("elem_order", step.elem_order, {"", "orders of the round's solution"});
    a.later_field("elem_sensor", step.elem_sensor, {"1", "their sensors"});
  });
  archive.nonempty_field("alignment", field.alignment, [](Archive& a, AlignmentPoint& point) {
    a.field("position", point.position, {"length", "middle of a Gaussian"});
    a.field("width", point.width, {"length", "at which it is 1 / e"});
    a.field("rate", point.rate, {"1/length2", "its greatest mu"});
    a.field("angle", point.angle, {"radian", "of one direction of the cross"});
  });
  if (archive.is_reading()) field.mesh.provenance = field.provenance;
}

}  // namespace quadrille::io
