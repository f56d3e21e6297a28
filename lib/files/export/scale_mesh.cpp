#include "export/scale_mesh.hpp"

namespace quadrille::exports {

void scale_mesh(QuadMesh& mesh, const LengthScale& scale) {
  const double factor = scale.factor;
  scale_lengths(mesh.face, scale);
  for (Vec2& node : mesh.nodes) node = factor * node;
  for (double& bound : mesh.elem_jacobian_bound) bound *= factor * factor;
  mesh.least_jacobian_bound *= factor * factor;
  for (double& length : mesh.elem_node_distance) length *= factor;
}

}  // namespace quadrille::exports
