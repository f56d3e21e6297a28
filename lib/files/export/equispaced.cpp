#include "export/equispaced.hpp"

#include "export/renode.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::exports {

std::vector<Vec2> equispaced_nodes(const QuadMesh& mesh) {
  if (mesh.order <= 2) return mesh.nodes;  // the same points
  std::vector<double> points;
  for (int i = 0; i <= mesh.order; ++i) points.push_back(-1 + 2.0 * i / mesh.order);
  return renoded(mesh, spectral::interpolation_matrix(spectral::gll_points(mesh.order), points));
}

}  // namespace quadrille::exports
