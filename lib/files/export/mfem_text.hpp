#pragma once
// What MFEM meshes of quads and of hexahedra have in common. Private to mfem*.

#include <string>
#include <utility>
#include <vector>

#include "export/groups.hpp"
#include "export/hex_periodic.hpp"
#include "export/periodic_edges.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {

/// The table of names beside a mesh of v1.0, and a sentence about it.
void add_mfem_names(const Groups& groups, Exported& exported);

class MfemText : protected TextWriter {
 public:
  virtual ~MfemText() = default;

 protected:
  /// The title, of v1.3 with names or of v1.0, and the dimension.
  void begin(bool with_names, int dim);

  /// Attributes from 1 by their names, one each.
  void write_sets(const char* title, const std::vector<std::string>& names);

  /// The head of a grid function of nodes. `kind`: H1, or L2_T1 (the discontinuous basis of Gauss-Lobatto nodes).
  void write_space(const char* kind, int dim, int order, int space_dim);
};

/// A mesh of quads or hexahedra with its numbering, whose vertices on periodic sides are one in the file.
template <typename Mesh, typename Numbering>
class MfemWriter : public MfemText {
 public:
  /// The file, and the loss of periodic sides if it does not store them. The numbering is checked to be one that MFEM
  /// knows by vertices.
  Exported exported() {
    begin(with_names_, dimension_);
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

 protected:
  MfemWriter(const Mesh& mesh, Numbering numbering, int dimension, bool with_names)
      : mesh_(mesh),
        numbering_(std::move(numbering)),
        groups_(mesh_groups(mesh)),
        periodic_(periodic_vertices(mesh_, numbering_, Motions::all, "MFEM")),
        dimension_(dimension),
        with_names_(with_names) {
    for (int v = 0; v < numbering_.num_vertices(); ++v)
      vertex_numbers_.push_back(periodic_(v) == v ? num_vertices_++ : vertex_numbers_[periodic_(v)]);
  }

  virtual void write_elements() = 0;
  /// MFEM's boundary may have elements inside the mesh: periodic sides, and interfaces with attributes after those of
  /// the boundary.
  virtual void write_boundary() = 0;
  virtual int space_dim() const = 0;
  virtual void print_position(int node) = 0;
  /// In MFEM's own order, after the vertices.
  virtual void write_inner_nodes() = 0;

  const Mesh& mesh_;
  Numbering numbering_;
  Groups groups_;
  PeriodicVertices periodic_;
  std::vector<int> vertex_numbers_;  ///< by vertex of numbering_

 private:
  /// Elements with straight edges are their vertices; others a grid function of nodes, which is discontinuous where
  /// vertices of periodic sides are one.
  void write_geometry() {
    print("\nvertices\n{}\n", num_vertices_);
    if (periodic_.are_identified()) {
      write_space("L2_T1", dimension_, mesh_.order, space_dim());  // T1: the basis of Gauss-Lobatto nodes
      for (const int node : mesh_.elem_nodes) print_position(node);
      return;
    }
    if (mesh_.order == 1)
      print("{}\n", space_dim());
    else
      write_space("H1", dimension_, mesh_.order, space_dim());
    for (const int node : numbering_.vertices) print_position(node);
    if (mesh_.order > 1) write_inner_nodes();
  }

  int dimension_, num_vertices_ = 0;
  bool with_names_;
};

}  // namespace quadrille::exports
