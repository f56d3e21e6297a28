#pragma once
// A quad mesh in another unit or size.

#include "model/length_scale.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// Multiplies all positions and lengths of the mesh by scale.factor > 0, areas and Jacobians by its square.
void scale_mesh(QuadMesh& mesh, const LengthScale& scale);

}  // namespace quadrille::exports
