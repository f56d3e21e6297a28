#include "galerkin/discretization.hpp"

#include <fmt/format.h>

#include "base/position_text.hpp"
#include "mesh/tri_maps.hpp"

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

}  // namespace quadrille::galerkin
