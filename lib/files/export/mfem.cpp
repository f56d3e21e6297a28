#include <fmt/format.h>

#include <array>
#include <utility>

#include "base/message_text.hpp"
#include "export/cells.hpp"
#include "export/hex_periodic.hpp"
#include "export/renode.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

/// MFEM's numbers of its geometries (geom.hpp of its source), by dimension: segment, square, cube.
constexpr std::array<int, 4> geometry_types{0, 1, 3, 5};

/// As std::quoted writes it, which is how MFEM reads it.
std::string mfem_quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

/// The table of names beside a mesh of v1.0, and a sentence about it.
void add_mfem_names(const Groups& groups, Exported& exported) {
  exported.side_files.push_back(names_table(groups, groups.boundary_names, groups.region_names, true));
  exported.add_loss(
      fmt::format("MFEM v1.0 stores {} and {} by number only; their names are in *.names.json "
                  "(--format mfem13 keeps them, for MFEM 4.7 and later)",
                  groups.num_boundaries() == 1 ? "1 boundary" : fmt::format("{} boundaries", groups.num_boundaries()),
                  counted(groups.num_regions(), "region")));
}

/// Vertices on periodic sides are one in the file.
template <typename Mesh>
class MfemWriter : TextWriter {
 public:
  MfemWriter(const Mesh& mesh, std::vector<std::array<double, 3>> positions, int space_dim, bool with_names)
      : mesh_(mesh),
        positions_(std::move(positions)),
        numbering_(number_parts(mesh)),
        groups_(mesh_groups(mesh)),
        space_dim_(space_dim),
        with_names_(with_names) {
    require_known_by_vertices(mesh, numbering_, "MFEM");
    periodic_ = periodic_vertices(mesh_, numbering_, Motions::all, "MFEM");
    for (int v = 0; v < numbering_.num_vertices(); ++v)
      vertex_numbers_.push_back(periodic_(v) == v ? num_vertices_++ : vertex_numbers_[periodic_(v)]);
  }

  /// The file, and the loss of periodic sides if it does not store them.
  Exported exported() {
    print("MFEM mesh v1.{}\n\ndimension\n{}\n", with_names_ ? 3 : 0, dim);
    write_elements();
    if (with_names_) write_sets("attribute_sets", groups_.region_names);
    write_boundary();
    if (with_names_) write_sets("bdr_attribute_sets", boundary_and_interface_names(groups_));
    write_geometry();
    if (with_names_) print("\nmfem_mesh_end\n");
    Exported result;
    result.bytes = std::move(out_);
    result.add_loss(periodic_.loss);
    if (!with_names_) add_mfem_names(groups_, result);
    return result;
  }

 private:
  static constexpr int dim = mesh_dimension<Mesh>;

  void print_corner(int elem, int corner) { print(" {}", vertex_numbers_[numbering_.vertex(elem, corner)]); }

  void write_elements() {
    print("\nelements\n{}\n", mesh_.num_elems());
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      print("{} {}", 1 + groups_.block2region[block_of(mesh_, elem)], geometry_types[dim]);
      for (int corner = 0; corner < 1 << dim; ++corner) print_corner(elem, corner);
      print("\n");
    }
  }

  /// Attributes from 1 by their names, one each.
  void write_sets(const char* title, const std::vector<std::string>& names) {
    print("\n{}\n{}\n", title, names.size());
    for (std::size_t k = 0; k < names.size(); ++k) print("{} 1 {}\n", mfem_quoted(names[k]), k + 1);
  }

  /// MFEM's boundary may have elements inside the mesh: periodic sides, and interfaces with attributes after those of
  /// the boundary.
  void write_boundary() {
    const std::vector<GroupSide> sides = group_sides(mesh_, groups_, numbering_);
    print("\nboundary\n{}\n", sides.size());
    for (const GroupSide& at : sides) {
      print("{} {}", 1 + at.group, geometry_types[dim - 1]);
      for (const int corner : side_corners(mesh_, at.side)) print_corner(at.elem, corner);
      print("\n");
    }
  }

  /// Elements with straight edges are their vertices; others a grid function of nodes, which is discontinuous where
  /// vertices of periodic sides are one.
  void write_geometry() {
    print("\nvertices\n{}\n", num_vertices_);
    if (periodic_.are_identified()) {
      write_space("L2_T1");  // T1: the basis of Gauss-Lobatto nodes
      for (const int node : mesh_.elem_nodes) print_position(node);
      return;
    }
    if (mesh_.order == 1)
      print("{}\n", space_dim_);
    else
      write_space("H1");
    for (const int node : numbering_.vertices) print_position(node);
    if (mesh_.order > 1) write_inner_nodes();
  }

  /// The head of a grid function of nodes. Ordering 1: the coordinates of a node together.
  void write_space(const char* kind) {
    print("\nnodes\nFiniteElementSpace\nFiniteElementCollection: {}_{}D_P{}\nVDim: {}\nOrdering: 1\n\n", kind, dim,
          mesh_.order, space_dim_);
  }

  void print_position(int node) {
    print("{}", positions_[node][0]);
    for (int c = 1; c < space_dim_; ++c) print(" {}", positions_[node][c]);
    print("\n");
  }

  /// In MFEM's own order, after the vertices: edges (each in its own direction), faces as the element of lower number
  /// sees them, elements (the first coordinate fastest).
  void write_inner_nodes() {
    for (const NumberedEdge& edge : numbering_.edges) print_inside(edge_nodes(mesh_, edge).data(), 1);
    if constexpr (dim == 3)
      for (const NumberedHexFace& face : numbering_.faces)
        print_inside(face_nodes(mesh_, face.elem, face.face).data(), 2);
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) print_inside(element_nodes(mesh_, elem), dim);
  }

  void print_inside(const int* nodes, int dimension) {
    int count = 1;
    for (int c = 0; c < dimension; ++c) count *= mesh_.order + 1;
    for (int k = 0; k < count; ++k)
      if (inner_coordinates(mesh_.order, dimension, k) == dimension) print_position(nodes[k]);
  }

  const Mesh& mesh_;
  std::vector<std::array<double, 3>> positions_;  ///< by node
  decltype(number_parts(std::declval<Mesh>())) numbering_;
  Groups groups_;
  PeriodicVertices periodic_;
  std::vector<int> vertex_numbers_;  ///< by vertex of numbering_
  int space_dim_, num_vertices_ = 0;
  bool with_names_;
};

Exported mfem_mesh(const QuadMesh& mesh, const Frame& frame, bool with_names) {
  return MfemWriter(mesh, positions(mesh, frame, ElementPoints::nodes), space_dimension(mesh, frame), with_names)
      .exported();
}

Exported mfem_mesh(const HexMesh& mesh, bool with_names) {
  return MfemWriter(mesh, positions(mesh, ElementPoints::nodes), 3, with_names).exported();
}

}  // namespace

Exported mfem_mesh10(const QuadMesh& mesh, const Frame& frame) { return mfem_mesh(mesh, frame, false); }
Exported mfem_mesh13(const QuadMesh& mesh, const Frame& frame) { return mfem_mesh(mesh, frame, true); }
Exported mfem_mesh10(const HexMesh& mesh) { return mfem_mesh(mesh, false); }
Exported mfem_mesh13(const HexMesh& mesh) { return mfem_mesh(mesh, true); }

}  // namespace quadrille::exports
