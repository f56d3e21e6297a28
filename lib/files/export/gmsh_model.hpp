#pragma once
// What both versions of Gmsh's MSH have in common, of quads and of hexahedra: entities, groups, types and orders of
// nodes. Private to gmsh*.
//
// Points, curves and surfaces of quads are taken from the skeleton; surfaces and volumes of hexahedra are the groups of
// faces and the regions. A node belongs to the first entity of lowest dimension that contains it. Every tag is
// positive: physical groups count from 1 through both dimensions (some readers require them to be unique), the
// boundaries first, then interfaces, then regions; entity e has tag e + 1, in version 2.2 above the tags of all groups,
// because PETSc looks for both in one list there.

#include <array>
#include <string>
#include <vector>

#include "export/exported.hpp"
#include "export/groups.hpp"
#include "model/hex_mesh.hpp"

namespace quadrille::exports {

struct GmshEntity {
  int group = 0;                     ///< its physical group, from 1; 0: none, its elements are not written
  std::vector<int> bounds = {};      ///< tags of what bounds it, with signs; of hexahedra readers do not need them
  std::vector<int> elem_nodes = {};  ///< mesh nodes of its elements, each in the order of the mesh
  std::vector<int> own_nodes = {};   ///< those that no entity before it has
  bool is_inside = false;            ///< of a curve of quads: it lies between blocks
};

/// An entity of a second periodic side, and the one of the first that it is the image of.
struct GmshPeriodicLink {
  int dim = 0, entity = 0, master = 0;
  std::array<double, 16> motion{};        ///< of the master onto the entity, row by row
  std::vector<std::array<int, 2>> nodes;  ///< mesh nodes, each with that of the master
};

struct GmshModel {
  int dimension = 2;
  Groups groups;
  std::vector<std::array<double, 3>> positions;     ///< by mesh node, equispaced in each element
  std::array<std::vector<GmshEntity>, 4> entities;  ///< by dimension
  std::vector<int> node_tags;                       ///< by mesh node: its position among own_nodes, from 1
  std::array<int, 4> types{};                       ///< Gmsh's types of elements by dimension
  std::array<std::vector<int>, 4> node_orders;      ///< Gmsh's order of the local nodes by dimension
  std::vector<GmshPeriodicLink> links;              ///< points, then curves, or surfaces

  int num_groups() const { return groups.num_boundaries() + groups.num_interfaces() + groups.num_regions(); }
};

/// For orders 1 to 10, of hexahedra to 9.
GmshModel gmsh_model(const QuadMesh& mesh, const Frame& frame);
GmshModel gmsh_model(const HexMesh& mesh);

/// A whole file of version 4.1.
std::string gmsh41_text(const GmshModel& model);

}  // namespace quadrille::exports
