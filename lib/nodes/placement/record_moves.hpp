#pragma once
// Moves irregular nodes and records where they were.

#include <functional>
#include <string>

#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::placement {

/// Gives the nodes of `points` the positions of those of `moved`. Adds a change of the kind `place` for each node that
/// moved by more than 1e-9 diameters, with the reason for a move of that length; such nodes get the source `place`, no
/// Jacobian and no error bar, and keep `elem` and `xi` of their old position, because only the caller has the mesh. If
/// no node moved so far, nothing changes.
void record_moves(const CadFace& face, const CriticalPoints& moved, const std::function<std::string(double)>& reason,
                  CriticalPoints& points);

}  // namespace quadrille::placement
