#pragma once
// Is a set of loops the boundary of one region? Decided on the curves themselves, not on a polygon: pieces are
// enclosed by their chord and the greatest distance of a pole from it, and halved until the question is answered.

#include <optional>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::cad {

/// Where two curves come closer than the tolerance without being neighbours at that place.
struct Contact {
  int loop_a = 0, curve_a = 0, loop_b = 0, curve_b = 0;
  Vec2 position;
};

/// The first contact among the curves of all loops, within a curve included; none for simple, disjoint loops.
/// `tol` is a length: closer than that is contact.
std::optional<Contact> find_contact(const std::vector<std::vector<Nurbs>>& loops, double tol);

/// How often the loop winds around x, which does not lie on it.
int winding_number(const std::vector<Nurbs>& loop, Vec2 x);

}  // namespace quadrille::cad
