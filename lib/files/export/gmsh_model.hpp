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

/// What quads and hexahedra have in common.
struct GmshNodes {
  Groups groups;
  std::vector<std::array<double, 3>> positions;               ///< by mesh node, equispaced in each element
  std::array<std::vector<std::vector<int>>, 4> entity_nodes;  ///< mesh nodes by dimension and entity
  std::vector<int> node_tags;                                 ///< by mesh node: its position in entity_nodes, from 1
  int tags_before = 0;                                        ///< tags below that of the first entity of each dimension

  int entity_tag(std::size_t entity) const { return static_cast<int>(entity) + 1 + tags_before; }
  int num_groups() const { return groups.num_boundaries() + groups.num_interfaces() + groups.num_regions(); }

  /// Fills node_tags from entity_nodes.
  void number_nodes();
};

struct GmshModel : GmshNodes {
  Skeleton skeleton;
  std::vector<std::vector<int>> block_elems;  ///< elements of each block
  std::vector<int> quad_node_order;           ///< gmsh_quad_order
  int line_type = 0, quad_type = 0;

  int boundary_group(int cad_curve) const { return 1 + groups.curve2boundary[cad_curve]; }
  int region_group(int block) const {
    return 1 + groups.num_boundaries() + groups.num_interfaces() + groups.block2region[block];
  }
};

/// For orders 1 to 10.
GmshModel gmsh_model(const QuadMesh& mesh, const Frame& frame);

/// A whole file of version 4.1.
std::string gmsh41_text(const GmshModel& model, const QuadMesh& mesh, const Frame& frame);

/// Gmsh's order of the local nodes of a quad of any order from 0, xi1 fastest: corners, then sides counter-clockwise,
/// then the same recursively for the inner nodes.
std::vector<int> gmsh_quad_order(int order);

/// Gmsh's type of quads of orders 1 to 10.
int gmsh_quad_type(int order);

/// The section $PhysicalNames; double quotes in a name become single ones. `dim`: of the boundaries.
std::string gmsh_names(const Groups& groups, int dim = 1);

/// The section $Nodes of versions 4.1 and 2.2.
std::string gmsh_nodes41(const GmshNodes& model);
std::string gmsh_nodes22(const GmshNodes& model);

/// " tag"
void append_tag(int tag, std::string& text);

/// Tags of the nodes of an edge, or of a quad, in Gmsh's order, each after a blank; then the end of the line.
void append_gmsh_line(const GmshModel& model, const QuadMesh& mesh, const SkeletonEdge& edge, std::string& text);
void append_gmsh_quad(const GmshModel& model, const QuadMesh& mesh, int elem, std::string& text);

/// An entity of a second periodic side, and the one of the first that it is the image of.
struct GmshPeriodicLink {
  int dim = 0, entity = 0, master = 0;
  std::array<double, 16> motion{};        ///< of the master onto the entity, row by row
  std::vector<std::array<int, 2>> nodes;  ///< mesh nodes, each with that of the master
};

/// Points, then curves.
std::vector<GmshPeriodicLink> periodic_links(const GmshModel& model, const QuadMesh& mesh, const Frame& frame);

/// The section $Periodic; empty without links. `motion`: the word or number before the motion, which formats differ in.
std::string gmsh_periodic(const GmshNodes& model, const std::vector<GmshPeriodicLink>& links, const char* motion);

/// "x y z", the shortest digits that read back to the same bits.
void append_position(const std::array<double, 3>& x, std::string& text);

/// The corners of a box along the axes.
struct GmshBox {
  std::array<double, 3> lower{1e300, 1e300, 1e300}, upper{-1e300, -1e300, -1e300};

  void add(const std::array<double, 3>& x);
  /// "x y z x y z"
  void append(std::string& text) const;
};

}  // namespace quadrille::exports
