#include "export/edge_numbering.hpp"
#include "export/groups.hpp"
#include "export/mfem_text.hpp"
#include "export/periodic_edges.hpp"
#include "export/renode.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

/// MFEM's numbers of its geometries (geom.hpp of its source).
constexpr int segment_type = 1, square_type = 3;

class MfemWriter : MfemText {
 public:
  MfemWriter(const QuadMesh& mesh, const Frame& frame, bool with_names)
      : mesh_(mesh), frame_(frame), with_names_(with_names), edges_(number_edges(mesh)), groups_(mesh_groups(mesh)) {
    require_edges_known_by_ends(mesh_, edges_, "MFEM");
    number_vertices();
  }

  /// That sides are periodic, if the file does not store it; else empty.
  const std::string& periodic_loss() const { return periodic_.loss; }

  std::string text() {
    begin(with_names_, 2);
    write_elements();
    if (with_names_) write_sets("attribute_sets", groups_.region_names);
    write_boundary();
    if (with_names_) write_sets("bdr_attribute_sets", boundary_and_interface_names(groups_));
    write_geometry();
    if (with_names_) print("\nmfem_mesh_end\n");
    return std::move(out_);
  }

 private:
  /// Vertices of periodic sides are one in the file; without periodic sides they have the numbers of edges_.
  void number_vertices() {
    periodic_ = periodic_vertices(mesh_, edges_, Motions::all, "MFEM");
    for (int v = 0; v < edges_.num_vertices(); ++v)
      vertex_numbers_.push_back(periodic_(v) == v ? num_vertices_++ : vertex_numbers_[periodic_(v)]);
  }

  int vertex(int elem, int corner) const { return vertex_numbers_[edges_.elem2verts[4 * elem + corner % 4]]; }

  void write_elements() {
    print("\nelements\n{}\n", mesh_.num_elems());
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      const int attribute = 1 + groups_.block2region[mesh_.elem_block[elem]];
      print("{} {} {} {} {} {}\n", attribute, square_type, vertex(elem, 0), vertex(elem, 1), vertex(elem, 2),
            vertex(elem, 3));
    }
  }

  /// MFEM's boundary may have elements inside the mesh: periodic sides, and interfaces with attributes after those of
  /// the boundary.
  void write_boundary() {
    std::vector<QuadBoundaryEdge> edges = mesh_.boundary_edges;
    const std::vector<QuadBoundaryEdge> inner = interface_edges_once(mesh_);
    edges.insert(edges.end(), inner.begin(), inner.end());
    print("\nboundary\n{}\n", edges.size());
    for (const QuadBoundaryEdge& e : edges)
      print("{} {} {} {}\n", 1 + groups_.curve2boundary[e.curve], segment_type, vertex(e.elem, e.side),
            vertex(e.elem, e.side + 1));
  }

  int space_dim() const { return space_dimension(mesh_, frame_); }

  void print_position(int node) {
    const auto x = position(mesh_, frame_, node);
    print("{} {}", x[0], x[1]);
    if (space_dim() == 3) print(" {}", x[2]);
    print("\n");
  }

  /// Straight-sided quads are their vertices; others a grid function of nodes, which is discontinuous where vertices of
  /// periodic sides are one.
  void write_geometry() {
    print("\nvertices\n{}\n", num_vertices_);
    if (periodic_.are_identified()) {
      write_space("L2_T1", 2, mesh_.order, space_dim());  // T1: the basis of Gauss-Lobatto nodes
      for (const int node : mesh_.elem_nodes) print_position(node);
      return;
    }
    if (mesh_.order == 1)
      print("{}\n", space_dim());
    else
      write_space("H1", 2, mesh_.order, space_dim());
    for (const int node : edges_.vertices) print_position(node);
    if (mesh_.order > 1) write_inner_nodes();
  }

  /// MFEM's own order: vertices, edges (each in its own direction), elements (i fastest).
  void write_inner_nodes() {
    const int n = mesh_.order;
    for (const NumberedEdge& edge : edges_.edges) {
      const std::vector<int> nodes = edge_nodes(mesh_, edge);
      for (int k = 1; k < n; ++k) print_position(nodes[k]);
    }
    for (int elem = 0; elem < mesh_.num_elems(); ++elem)
      for (int j = 1; j < n; ++j)
        for (int i = 1; i < n; ++i) print_position(mesh_.elem_nodes[elem * mesh_.nodes_per_elem() + j * (n + 1) + i]);
  }

  const QuadMesh& mesh_;
  const Frame& frame_;
  bool with_names_;
  EdgeNumbering edges_;
  Groups groups_;
  PeriodicVertices periodic_;
  std::vector<int> vertex_numbers_;  ///< by vertex of edges_
  int num_vertices_ = 0;
};

Exported mfem_mesh(const QuadMesh& mesh, const Frame& frame, bool with_names) {
  MfemWriter writer(mesh, frame, with_names);
  Exported result;
  result.bytes = writer.text();
  result.add_loss(writer.periodic_loss());
  return result;
}

}  // namespace

Exported mfem_mesh10(const QuadMesh& mesh, const Frame& frame) {
  const Groups groups = mesh_groups(mesh);
  Exported result = mfem_mesh(mesh, frame, false);
  add_mfem_names(groups, result);
  return result;
}

Exported mfem_mesh13(const QuadMesh& mesh, const Frame& frame) { return mfem_mesh(mesh, frame, true); }

}  // namespace quadrille::exports
