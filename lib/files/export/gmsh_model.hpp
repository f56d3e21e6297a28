#pragma once
// The common parts of both versions of Gmsh's MSH: entities, numbers, types and orders of nodes. Private to gmsh*.
//
// Points, curves and surfaces are taken from the skeleton; a node belongs to the entity of lowest dimension that
// contains it. Every tag is positive: physical groups count from 1 through both dimensions (some readers require them
// to be unique), the boundaries first, then interfaces, then regions; entity e has tag e + 1, in version 2.2 above the
// tags of all groups, because PETSc looks for both in one list there.

#include <array>
#include <string>
#include <vector>

#include "export/exported.hpp"
#include "export/groups.hpp"
#include "export/skeleton.hpp"

namespace quadrille::exports {

struct GmshModel {
  Skeleton skeleton;
  Groups groups;
  std::vector<std::array<double, 3>> positions;               ///< by mesh node, equispaced in each element
  std::array<std::vector<std::vector<int>>, 3> entity_nodes;  ///< mesh nodes by dimension and entity
  std::vector<int> node_tags;                                 ///< by mesh node: its position in entity_nodes, from 1
  std::vector<std::vector<int>> block_elems;                  ///< elements of each block
  std::vector<int> quad_node_order;                           ///< Gmsh's order of the local nodes of a quad
  int line_type = 0, quad_type = 0;
  int tags_before = 0;  ///< tags below that of the first entity of each dimension

  int entity_tag(std::size_t entity) const { return static_cast<int>(entity) + 1 + tags_before; }
  int num_groups() const { return groups.num_boundaries() + groups.num_interfaces() + groups.num_regions(); }
  int boundary_group(int cad_curve) const { return 1 + groups.curve2boundary[cad_curve]; }
  int region_group(int block) const {
    return 1 + groups.num_boundaries() + groups.num_interfaces() + groups.block2region[block];
  }
};

/// For orders 1 to 10.
GmshModel gmsh_model(const QuadMesh& mesh, const Frame& frame);

/// A whole file of version 4.1.
std::string gmsh41_text(const GmshModel& model, const QuadMesh& mesh, const Frame& frame);

/// The section $PhysicalNames; double quotes in a name become single ones.
std::string gmsh_names(const Groups& groups);

/// Tags of the nodes of an edge, or of a quad, in Gmsh's order, each after a blank; then the end of the line.
void append_gmsh_line(const GmshModel& model, const QuadMesh& mesh, const SkeletonEdge& edge, std::string& text);
void append_gmsh_quad(const GmshModel& model, const QuadMesh& mesh, int elem, std::string& text);

/// The section $Periodic: points and curves of second periodic sides with their masters, the motion row by row, and
/// pairs of nodes. Empty without periodic sides. `motion`: the word or number before the motion, which formats differ
/// in.
std::string gmsh_periodic(const GmshModel& model, const QuadMesh& mesh, const Frame& frame, const char* motion);

/// "x y z", the shortest digits that read back to the same bits.
void append_position(const std::array<double, 3>& x, std::string& text);

}  // namespace quadrille::exports
