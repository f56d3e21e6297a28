#include "export/edge_numbering.hpp"
#include "export/groups.hpp"
#include "export/mfem_text.hpp"
#include "export/renode.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

/// MFEM's numbers of its geometries (geom.hpp of its source).
constexpr int segment_type = 1, square_type = 3;

EdgeNumbering mfem_numbering(const QuadMesh& mesh) {
  EdgeNumbering edges = number_edges(mesh);
  require_edges_known_by_ends(mesh, edges, "MFEM");
  return edges;
}

class MfemQuadWriter : public MfemWriter<QuadMesh, EdgeNumbering> {
 public:
  MfemQuadWriter(const QuadMesh& mesh, const Frame& frame, bool with_names)
      : MfemWriter(mesh, mfem_numbering(mesh), 2, with_names), frame_(frame) {}

 private:
  int vertex(int elem, int corner) const { return vertex_numbers_[numbering_.elem2verts[4 * elem + corner % 4]]; }

  void write_elements() override {
    print("\nelements\n{}\n", mesh_.num_elems());
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      const int attribute = 1 + groups_.block2region[mesh_.elem_block[elem]];
      print("{} {} {} {} {} {}\n", attribute, square_type, vertex(elem, 0), vertex(elem, 1), vertex(elem, 2),
            vertex(elem, 3));
    }
  }

  void write_boundary() override {
    std::vector<QuadBoundaryEdge> edges = mesh_.boundary_edges;
    const std::vector<QuadBoundaryEdge> inner = interface_edges_once(mesh_);
    edges.insert(edges.end(), inner.begin(), inner.end());
    print("\nboundary\n{}\n", edges.size());
    for (const QuadBoundaryEdge& e : edges)
      print("{} {} {} {}\n", 1 + groups_.curve2boundary[e.curve], segment_type, vertex(e.elem, e.side),
            vertex(e.elem, e.side + 1));
  }

  int space_dim() const override { return space_dimension(mesh_, frame_); }

  void print_position(int node) override {
    const auto x = position(mesh_, frame_, node);
    print("{} {}", x[0], x[1]);
    if (space_dim() == 3) print(" {}", x[2]);
    print("\n");
  }

  /// Edges (each in its own direction), elements (i fastest).
  void write_inner_nodes() override {
    const int n = mesh_.order;
    for (const NumberedEdge& edge : numbering_.edges) {
      const std::vector<int> nodes = edge_nodes(mesh_, edge);
      for (int k = 1; k < n; ++k) print_position(nodes[k]);
    }
    for (int elem = 0; elem < mesh_.num_elems(); ++elem)
      for (int j = 1; j < n; ++j)
        for (int i = 1; i < n; ++i) print_position(mesh_.elem_nodes[elem * mesh_.nodes_per_elem() + j * (n + 1) + i]);
  }

  const Frame& frame_;
};

}  // namespace

Exported mfem_mesh10(const QuadMesh& mesh, const Frame& frame) { return MfemQuadWriter(mesh, frame, false).exported(); }
Exported mfem_mesh13(const QuadMesh& mesh, const Frame& frame) { return MfemQuadWriter(mesh, frame, true).exported(); }

}  // namespace quadrille::exports
