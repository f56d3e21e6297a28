#pragma once
// The exit of a streamline's step from the reference triangle of its element.

#include "base/vec2.hpp"
#include "trace/step.hpp"

namespace quadrille::trace {

/// The local edge through which a step exits its element, and the fraction of the step before it; edge -1: the step
/// ends inside.
struct ElementExit {
  int edge = -1;
  double fraction = 2;
};

/// The first edge that the step crosses outwards. A point up to 1e-12 (barycentric) beyond an edge counts as inside, so
/// that a line that grazes an edge does not alternate between both elements without advancing.
ElementExit first_exit(const StreamStep& step);

/// Fraction along local edge `edge` at which `xi` lies, in [0, 1], as in spectral::tri_edge_point.
double fraction_along_edge(int edge, Vec2 xi);

/// The arc length after which the tangent at `state` is outside the element by a twentieth of its size, at most
/// `limit`: much farther outside the polynomial of the field is inaccurate.
double length_to_exit(const StreamState& state, double limit);

}  // namespace quadrille::trace
