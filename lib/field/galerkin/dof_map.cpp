#include "galerkin/dof_map.hpp"

#include <algorithm>

#include "spectral/modified_basis.hpp"

namespace quadrille::galerkin {

namespace {

// The order of every edge, chosen from the orders of its one or two elements.
std::vector<int> edge_orders(const mesh::TriTopology& topology, const std::vector<int>& elem_order,
                             const int& (*choose)(const int&, const int&)) {
  std::vector<int> edge2order;
  edge2order.reserve(topology.edge2elems.size());
  for (const auto& [first, second] : topology.edge2elems) {
    edge2order.push_back(second < 0 ? elem_order[first] : choose(elem_order[first], elem_order[second]));
  }
  return edge2order;
}

bool is_backwards(const TriMesh& mesh, int elem, int edge) {
  return mesh.elem2vertices[elem][edge] > mesh.elem2vertices[elem][(edge + 1) % 3];
}

// Numbers all entities on the boundary, or all others, in elimination order.
void number(const std::vector<int>& elimination_order, const std::vector<bool>& on_boundary, bool number_boundary,
            DofMap& map) {
  const int num_vertices = static_cast<int>(map.vertex2dof.size());
  for (const int entity : elimination_order) {
    if (on_boundary[entity] != number_boundary) continue;
    if (entity < num_vertices) {
      map.vertex2dof[entity] = map.num_dofs++;
    } else {
      map.edge2dof[entity - num_vertices] = map.num_dofs;
      map.num_dofs += map.edge2order[entity - num_vertices] - 1;
    }
  }
}

void add_element(const TriMesh& mesh, const mesh::TriTopology& topology, int elem, int order, DofMap& map) {
  for (const int vertex : mesh.elem2vertices[elem]) {
    map.elem2dofs.push_back(map.vertex2dof[vertex]);
    map.elem2signs.push_back(1);
  }
  for (int k = 0; k < 3; ++k) {
    const int edge = topology.elem2edges[elem][k];
    const bool backwards = is_backwards(mesh, elem, k);
    for (int degree = 2; degree <= order; ++degree) {
      map.elem2dofs.push_back(degree <= map.edge2order[edge] ? map.edge2dof[edge] + degree - 2 : -1);
      map.elem2signs.push_back(backwards && degree % 2 == 1 ? -1 : 1);
    }
  }
  map.elem2offset.push_back(static_cast<int>(map.elem2dofs.size()));
}

}  // namespace

DofMap make_dof_map(const TriMesh& mesh, const mesh::TriTopology& topology, const std::vector<int>& elimination_order,
                    const std::vector<int>& elem_order) {
  const int num_vertices = static_cast<int>(mesh.vertices.size());
  const int num_edges = static_cast<int>(topology.edge2vertices.size());
  DofMap map;
  map.vertex2dof.assign(num_vertices, -1);
  map.edge2dof.assign(num_edges, -1);
  map.edge2order = edge_orders(topology, elem_order, std::min<int>);
  std::vector<bool> on_boundary(num_vertices + num_edges, false);
  for (int edge = 0; edge < num_edges; ++edge) {
    if (topology.edge2elems[edge][1] >= 0) continue;
    on_boundary[num_vertices + edge] = true;
    for (const int vertex : topology.edge2vertices[edge]) on_boundary[vertex] = true;
  }
  number(elimination_order, on_boundary, false, map);
  map.num_unknowns = map.num_dofs;
  number(elimination_order, on_boundary, true, map);
  map.elem2offset.push_back(0);
  for (int e = 0; e < mesh.num_elems(); ++e) add_element(mesh, topology, e, elem_order[e], map);
  return map;
}

DofMap make_trace_map(const TriMesh& mesh, const mesh::TriTopology& topology, const std::vector<int>& elimination_order,
                      const std::vector<int>& elem_order) {
  const int num_vertices = static_cast<int>(mesh.vertices.size());
  DofMap map;
  map.edge2order = edge_orders(topology, elem_order, std::max<int>);
  map.edge2dof.assign(map.edge2order.size(), -1);
  for (const bool on_boundary : {false, true}) {
    for (const int entity : elimination_order) {
      const int edge = entity - num_vertices;
      if (edge < 0 || (topology.edge2elems[edge][1] < 0) != on_boundary) continue;
      map.edge2dof[edge] = map.num_dofs;
      map.num_dofs += map.edge2order[edge] + 1;
    }
    if (!on_boundary) map.num_unknowns = map.num_dofs;
  }
  map.elem2offset.push_back(0);
  for (int e = 0; e < mesh.num_elems(); ++e) {
    for (int k = 0; k < 3; ++k) {
      const int edge = topology.elem2edges[e][k];
      for (int degree = 0; degree <= map.edge2order[edge]; ++degree) {
        map.elem2dofs.push_back(map.edge2dof[edge] + degree);
        map.elem2signs.push_back(is_backwards(mesh, e, k) && degree % 2 == 1 ? -1 : 1);
      }
    }
    map.elem2offset.push_back(static_cast<int>(map.elem2dofs.size()));
  }
  return map;
}

}  // namespace quadrille::galerkin
