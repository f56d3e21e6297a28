#include "galerkin/discretization.hpp"

#include <fmt/format.h>

#include "base/position_text.hpp"
#include "galerkin/element_matrices.hpp"
#include "mesh/tri_maps.hpp"
#include "spectral/modified_basis.hpp"

namespace quadrille::galerkin {

MeshContext::MeshContext(const TriMesh& tri_mesh)
    : mesh(&tri_mesh),
      topology(mesh::tri_topology(tri_mesh)),
      maps(mesh::tri_maps(tri_mesh)),
      tree(mesh::nested_dissection(tri_mesh, topology)) {}

std::string MeshContext::describe(int elem) const {
  const Vec2 x = maps[elem].position({-1.0 / 3, -1.0 / 3}) + mesh->face.origin;
  return fmt::format("element {} near {}", elem, position_text(x));
}

StiffnessTable::StiffnessTable(const MeshContext& context) : context_(&context), curved_(context.maps.size()) {}

Eigen::MatrixXd StiffnessTable::operator()(int elem, int order) {
  const spectral::TriMap& map = context_->maps[elem];
  if (map.is_affine()) return stiffness_matrix(map, order);
  Integrals& integrals = curved_[elem];
  const int higher = spectral::table_order(order);
  if (integrals.order != higher) integrals = {higher, stiffness_matrix(map, higher)};
  return cut_down(integrals.stiffness, higher, order);
}

}  // namespace quadrille::galerkin
