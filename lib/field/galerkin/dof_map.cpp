#include "galerkin/dof_map.hpp"

#include <algorithm>

namespace quadrille::galerkin {

namespace {

// Which modes have dofs, and the order of an edge, chosen from those of its two elements.
struct Numbering {
  bool has_vertices;
  int least_degree;  // of the modes of an edge
  const int& (*edge_order)(const int&, const int&);
};

DofMap make_map(const TriMesh& mesh, const mesh::TriTopology& topology, const std::vector<int>& elimination_order,
                const std::vector<int>& elem_order, const Numbering& numbering) {
  const int num_vertices = static_cast<int>(mesh.vertices.size()), least = numbering.least_degree;
  DofMap map;
  std::vector<bool> is_on_boundary(num_vertices + topology.edge2elems.size(),
                                   false);  // by entity: vertices, then edges
  for (std::size_t edge = 0; edge < topology.edge2elems.size(); ++edge) {
    const auto [a, b] = topology.edge2elems[edge];
    map.edge2order.push_back(b < 0 ? elem_order[a] : numbering.edge_order(elem_order[a], elem_order[b]));
    if (b >= 0) continue;
    is_on_boundary[num_vertices + edge] = true;
    for (const int vertex : topology.edge2vertices[edge]) is_on_boundary[vertex] = true;
  }
  if (numbering.has_vertices) map.vertex2dof.assign(num_vertices, -1);
  map.edge2dof.assign(map.edge2order.size(), -1);
  for (const bool boundary : {false, true}) {
    for (const int entity : elimination_order) {
      const int edge = entity - num_vertices;
      if (is_on_boundary[entity] != boundary || (edge < 0 && !numbering.has_vertices)) continue;
      (edge < 0 ? map.vertex2dof[entity] : map.edge2dof[edge]) = map.num_dofs;
      map.num_dofs += edge < 0 ? 1 : map.edge2order[edge] - least + 1;
    }
    if (!boundary) map.num_unknowns = map.num_dofs;
  }
  return map;
}

// Appends the modes of degree `least` .. `order` of edge k of an element; -1 for those that the edge does not have.
void add_edge(const TriMesh& mesh, const mesh::TriTopology& topology, int elem, int k, int least, int order,
              DofMap& map) {
  const int edge = topology.elem2edges[elem][k];
  const bool is_backwards = mesh.elem2vertices[elem][k] > mesh.elem2vertices[elem][(k + 1) % 3];
  for (int degree = least; degree <= order; ++degree) {
    map.elem2dofs.push_back(degree <= map.edge2order[edge] ? map.edge2dof[edge] + degree - least : -1);
    map.elem2signs.push_back(is_backwards && degree % 2 == 1 ? -1 : 1);
  }
}

}  // namespace

DofMap make_dof_map(const TriMesh& mesh, const mesh::TriTopology& topology, const std::vector<int>& elimination_order,
                    const std::vector<int>& elem_order) {
  DofMap map = make_map(mesh, topology, elimination_order, elem_order, {true, 2, std::min<int>});
  map.elem2offset.push_back(0);
  for (int e = 0; e < mesh.num_elems(); ++e) {
    for (const int vertex : mesh.elem2vertices[e]) map.elem2dofs.push_back(map.vertex2dof[vertex]);
    map.elem2signs.insert(map.elem2signs.end(), 3, 1);
    for (int k = 0; k < 3; ++k) add_edge(mesh, topology, e, k, 2, elem_order[e], map);
    map.elem2offset.push_back(static_cast<int>(map.elem2dofs.size()));
  }
  return map;
}

DofMap make_trace_map(const TriMesh& mesh, const mesh::TriTopology& topology, const std::vector<int>& elimination_order,
                      const std::vector<int>& elem_order) {
  DofMap map = make_map(mesh, topology, elimination_order, elem_order, {false, 0, std::max<int>});
  map.elem2offset.push_back(0);
  for (int e = 0; e < mesh.num_elems(); ++e) {
    for (int k = 0; k < 3; ++k) add_edge(mesh, topology, e, k, 0, map.edge2order[topology.elem2edges[e][k]], map);
    map.elem2offset.push_back(static_cast<int>(map.elem2dofs.size()));
  }
  return map;
}

}  // namespace quadrille::galerkin
