#pragma once
// A curve of a face as two curves.

#include "model/cad_face.hpp"

namespace quadrille::cad {

/// Divides a curve of the boundary at the parameter t inside it, where its tangent is continuous: later curves are
/// renumbered. Both parts have its name and its edge.
void split_curve(CadFace& face, int curve, double t);

}  // namespace quadrille::cad
