#pragma once
// Folds of splines: short stretches on which a curve runs back on itself.

#include "model/cad_face.hpp"

namespace quadrille::heal {

/// Puts the poles at each fold in the order in which the curve passes them: a leg of the control polygon is a fold if
/// it is at most `most` long, a length, and runs against both of its neighbours. Returns how far the curve may have
/// moved, the greatest distance of a pole from its old position; 0 if there is no fold, or one that would move a pole
/// further than `most`: the curve is unchanged then. Unfolding an unfolded curve changes nothing.
double unfold(Nurbs& curve, double most);

}  // namespace quadrille::heal
