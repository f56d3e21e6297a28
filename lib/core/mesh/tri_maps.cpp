#include "mesh/tri_maps.hpp"

#include "spectral/orthogonal_basis.hpp"

namespace quadrille::mesh {

std::vector<spectral::TriMap> tri_maps(const TriMesh& mesh) {
  std::vector<spectral::TriMap> maps;
  maps.reserve(mesh.elem2vertices.size());
  const int num_nodes = spectral::num_tri_modes(mesh.order);
  std::size_t next_curved = 0;
  for (int e = 0; e < mesh.num_elems(); ++e) {
    if (next_curved < mesh.curved_elems.size() && mesh.curved_elems[next_curved] == e) {
      maps.emplace_back(mesh.order, &mesh.curved_nodes[next_curved * num_nodes]);
      ++next_curved;
    } else {
      const auto& [a, b, c] = mesh.elem2vertices[e];
      maps.emplace_back(std::array<Vec2, 3>{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
    }
  }
  return maps;
}

}  // namespace quadrille::mesh
