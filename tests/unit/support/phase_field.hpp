#pragma once
// A phase in closed form: its explicit terms on a mesh of a square, and a constant beside them.

#include "square_field.hpp"

namespace quadrille {

inline Field closed_phase(TriMesh mesh, PhaseTerms terms, double constant) {
  Field field = interpolated_field(std::move(mesh), 1, [&](Vec2) { return Vec2{constant, 0}; });
  field.kind = FieldKind::phase;
  field.phase.terms = std::move(terms);
  field.phase.s = std::move(field.u);
  field.u.clear(), field.v.clear();
  for (const PhaseTurn& node : field.phase.terms.nodes)
    field.phase.prescribed.nodes.push_back({node.position, 4 - node.turns});
  return field;
}

/// The disc of radius 1 with nodes of valence 3 (lib/method.md §8): sum arg[(z - a)(1 - conj(a) z)], on a square about
/// it.
inline Field disc_phase(const std::vector<Vec2>& nodes) {
  PhaseTerms terms;
  double constant = 0;
  for (const Vec2 a : nodes) {
    terms.nodes.push_back({a, 1});
    terms.images.push_back({a / norm2(a), 1});
    constant += angle_of(Vec2{-a.x, a.y});  // 1 - conj(a) z = -conj(a) (z - 1 / conj(a))
  }
  return closed_phase(square_mesh({-1, -1}, 2, 3), terms, constant);
}

}  // namespace quadrille
