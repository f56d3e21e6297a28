#pragma once
// Irregular nodes and corner valences by rule where the field decides nothing (lib/method.md §3).

#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::guide {

/// For a face whose boundary data lie on one line (field/boundary_values, is_line_field): corner valences by rule
/// (guide/line_corners), and where no symmetric choice fits, all ties large and nodes (guide/node_ring) about the
/// rotation centre, or about the most interior point that is invariant under the symmetries of the face. No elements
/// are set.
CriticalPoints line_field_points(const CadFace& face, int max_valence);

}  // namespace quadrille::guide
