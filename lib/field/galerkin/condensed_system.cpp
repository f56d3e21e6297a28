#include "galerkin/condensed_system.hpp"

#include <algorithm>

namespace quadrille::galerkin {
namespace {

// Which modes have dofs, and the order of an edge, chosen from those of its two elements.
struct Numbering {
  bool has_vertices;
  int least_degree;  // of the modes of an edge
  const int& (*edge_order)(const int&, const int&);
};

// By entity: vertices, then edges.
std::vector<bool> entities_on_boundary(const TriMesh& mesh, const mesh::TriTopology& topology) {
  const std::size_t num_vertices = mesh.vertices.size();
  std::vector<bool> is_on_boundary(num_vertices + topology.edge2elems.size(), false);
  for (std::size_t edge = 0; edge < topology.edge2elems.size(); ++edge) {
    if (topology.edge2elems[edge][1] >= 0) continue;
    is_on_boundary[num_vertices + edge] = true;
    for (const int vertex : topology.edge2vertices[edge]) is_on_boundary[vertex] = true;
  }
  return is_on_boundary;
}

DofMap make_map(const TriMesh& mesh, const mesh::TriTopology& topology, const std::vector<int>& elimination_order,
                const std::vector<int>& elem_order, const std::vector<bool>& is_given, const Numbering& numbering) {
  const int num_vertices = static_cast<int>(mesh.vertices.size()), least = numbering.least_degree;
  DofMap map;
  for (const auto& [a, b] : topology.edge2elems)
    map.edge2order.push_back(b < 0 ? elem_order[a] : numbering.edge_order(elem_order[a], elem_order[b]));
  if (numbering.has_vertices) map.vertex2dof.assign(num_vertices, -1);
  map.edge2dof.assign(map.edge2order.size(), -1);
  for (const bool given : {false, true}) {
    for (const int entity : elimination_order) {
      const int edge = entity - num_vertices;
      if (is_given[entity] != given || (edge < 0 && !numbering.has_vertices)) continue;
      (edge < 0 ? map.vertex2dof[entity] : map.edge2dof[edge]) = map.num_dofs;
      map.num_dofs += edge < 0 ? 1 : map.edge2order[edge] - least + 1;
    }
    if (!given) map.num_unknowns = map.num_dofs;
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

bool has_given_dofs(const DofMap& map, int elem) {
  return std::any_of(&map.elem2dofs[map.elem2offset[elem]], map.elem2dofs.data() + map.elem2offset[elem + 1],
                     [&](int dof) { return dof >= map.num_unknowns; });
}

// Adds to `sum` the rows from `first` on of the full matrix times `dofs`; `at_given`: only what elements with given
// dofs contribute.
void add_product(const DofMap& map, const CondensedElements& elements, const Eigen::MatrixXd& dofs, int first,
                 bool at_given, Eigen::MatrixXd& sum) {
  for (int e = 0; e < static_cast<int>(elements.size()); ++e) {
    if (at_given && !has_given_dofs(map, e)) continue;
    const Eigen::MatrixXd of_elem = element_dofs(map, e, dofs);
    if (of_elem.isZero(0)) continue;
    const Eigen::MatrixXd local = elements[e]->schur * of_elem;
    const int offset = map.elem2offset[e];
    for (int i = 0; i < local.rows(); ++i) {
      const int dof = map.elem2dofs[offset + i], row = dof - first;
      if (dof >= 0 && row >= 0 && row < sum.rows()) sum.row(row) += map.elem2signs[offset + i] * local.row(i);
    }
  }
}

// A boundary mode of an element that has a given value in one of many columns.
struct GivenMode {
  int mode, column;
  double value;
};

std::vector<GivenMode> given_modes(const DofMap& map, int elem, const SparseColumns& given) {
  std::vector<GivenMode> modes;
  const int offset = map.elem2offset[elem], n = map.elem2offset[elem + 1] - offset;
  for (int i = 0; i < n; ++i) {
    const int row = map.elem2dofs[offset + i] - map.num_unknowns;
    if (row < 0) continue;
    for (SparseColumns::InnerIterator entry(given, row); entry; ++entry)
      modes.push_back({i, static_cast<int>(entry.col()), map.elem2signs[offset + i] * entry.value()});
  }
  return modes;
}

}  // namespace

DofMap make_dof_map(const TriMesh& mesh, const mesh::TriTopology& topology, const std::vector<int>& elimination_order,
                    const std::vector<int>& elem_order) {
  return make_dof_map(mesh, topology, elimination_order, elem_order, entities_on_boundary(mesh, topology));
}

DofMap make_dof_map(const TriMesh& mesh, const mesh::TriTopology& topology, const std::vector<int>& elimination_order,
                    const std::vector<int>& elem_order, const std::vector<bool>& is_given) {
  DofMap map = make_map(mesh, topology, elimination_order, elem_order, is_given, {true, 2, std::min<int>});
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
  DofMap map = make_map(mesh, topology, elimination_order, elem_order, entities_on_boundary(mesh, topology),
                        {false, 0, std::max<int>});
  map.elem2offset.push_back(0);
  for (int e = 0; e < mesh.num_elems(); ++e) {
    for (int k = 0; k < 3; ++k) add_edge(mesh, topology, e, k, 0, map.edge2order[topology.elem2edges[e][k]], map);
    map.elem2offset.push_back(static_cast<int>(map.elem2dofs.size()));
  }
  return map;
}

Eigen::MatrixXd right_hand_side(const DofMap& map, const CondensedElements& elements, const Eigen::MatrixXd& given) {
  Eigen::MatrixXd dofs = Eigen::MatrixXd::Zero(map.num_dofs, given.cols()),
                  rhs = Eigen::MatrixXd::Zero(map.num_unknowns, given.cols());
  dofs.bottomRows(given.rows()) = -given;
  add_product(map, elements, dofs, 0, true, rhs);
  return rhs;
}

SparseData sparse_data(const DofMap& map, const CondensedElements& elements, const SparseColumns& given) {
  SparseData data{SparseColumns(map.num_unknowns, given.cols()), Eigen::MatrixXd::Zero(given.cols(), given.cols())};
  std::vector<Eigen::Triplet<double>> rhs;
  for (int e = 0; e < static_cast<int>(elements.size()); ++e) {
    const std::vector<GivenMode> modes = given_modes(map, e, given);
    if (modes.empty()) continue;
    const Eigen::MatrixXd schur = elements[e]->schur.dense();
    const int offset = map.elem2offset[e];
    for (const GivenMode& of : modes) {
      for (int i = 0; i < schur.rows(); ++i) {
        const int dof = map.elem2dofs[offset + i];
        if (dof >= 0 && dof < map.num_unknowns)
          rhs.emplace_back(dof, of.column, -map.elem2signs[offset + i] * schur(i, of.mode) * of.value);
      }
      for (const GivenMode& other : modes)
        data.product(other.column, of.column) += other.value * schur(other.mode, of.mode) * of.value;
    }
  }
  data.rhs.setFromTriplets(rhs.begin(), rhs.end());
  return data;
}

Eigen::MatrixXd element_dofs(const DofMap& map, int elem, const Eigen::MatrixXd& dofs) {
  const int offset = map.elem2offset[elem], n = map.elem2offset[elem + 1] - offset;
  Eigen::MatrixXd local = Eigen::MatrixXd::Zero(n, dofs.cols());
  for (int i = 0; i < n; ++i) {
    const int dof = map.elem2dofs[offset + i];
    if (dof >= 0) local.row(i) = map.elem2signs[offset + i] * dofs.row(dof);
  }
  return local;
}

Eigen::MatrixXd reactions(const DofMap& map, const CondensedElements& elements, const Eigen::MatrixXd& dofs) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(map.num_dofs - map.num_unknowns, dofs.cols());
  add_product(map, elements, dofs, map.num_unknowns, true, sum);
  return sum;
}

double relative_residual(const DofMap& map, const CondensedElements& elements, const Eigen::MatrixXd& rhs,
                         const Eigen::MatrixXd& dofs, const Eigen::MatrixXd& load) {
  // Applies the matrix to all dofs: the reactions of the given ones form the right-hand side.
  Eigen::MatrixXd residual = Eigen::MatrixXd::Zero(map.num_unknowns, dofs.cols());
  add_product(map, elements, dofs, 0, false, residual);
  if (load.size() > 0) residual -= load;
  const double scale = rhs.norm();
  return scale > 0 ? residual.norm() / scale : residual.norm();
}

}  // namespace quadrille::galerkin
