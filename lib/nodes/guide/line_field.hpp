#pragma once
// Irregular nodes and corner valences by rule if the field does not determine them (lib/method.md §3).

#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::guide {

/// For a face whose field has no zeros that can be isolated, as where its boundary data lie on one line
/// (field/boundary_values, is_line_field): corner valences by rule (guide/line_corners). If no symmetric choice fits,
/// all ties have the larger valence, and nodes (guide/node_ring) are added about the rotation centre, or about the most
/// interior point that is invariant under the symmetries of the face. No elements are set.
CriticalPoints line_field_points(const CadFace& face, int max_valence);

}  // namespace quadrille::guide
