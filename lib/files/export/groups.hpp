#pragma once
// Named groups, as solvers address them: boundaries, interfaces and regions by name. Curves, and blocks, of equal name
// are one group; curves without a name are called curve_<number>; all blocks without a given name are one region,
// "domain", or have the name of their region of the face.
//
// For formats that have numbers only, allow single words only, or have no names for regions: words, sentences about
// what is lost, and a table of the names beside the mesh: x.re2.names.json = {"boundaries": [{"id": 1, "name": "wall"},
// ...], "regions": [{"id": 1, "name": "block_0"}, ...]}, with "interfaces" between them where the file has interfaces.

#include <string>
#include <vector>

#include "export/exported.hpp"
#include "model/block_regions.hpp"
#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

struct Groups {
  std::vector<std::string> boundary_names;   ///< in the order of their first curves
  std::vector<std::string> interface_names;  ///< of the curves that lie between elements and have no boundary's name
  std::vector<std::string> inner_names;      ///< of all curves that lie between elements
  /// By CAD curve, of hexahedra by group of faces: interfaces are numbered after the boundaries. -1: the curve has no
  /// edges, so that its name is no group: some readers refuse empty ones.
  std::vector<int> curve2boundary;
  std::vector<std::string> region_names;  ///< in the order of their first blocks
  std::vector<int> block2region;          ///< by block
  std::vector<bool> is_region_named;      ///< by region: the name was given

  int num_boundaries() const { return static_cast<int>(boundary_names.size()); }
  int num_interfaces() const { return static_cast<int>(interface_names.size()); }
  int num_regions() const { return static_cast<int>(region_names.size()); }
};

/// The region of the blocks without a name is "domain", followed by as many "_" as are necessary to differ from all
/// given names.
Groups mesh_groups(const QuadMesh& mesh);

/// Of hexahedra: the names of their groups of faces and of their regions.
Groups mesh_groups(const HexMesh& mesh);

/// The names of all boundaries, then of all interfaces.
std::vector<std::string> boundary_and_interface_names(const Groups& groups);

/// The same with the interfaces as further boundaries, for formats whose sets of sides may lie inside the mesh.
Groups lines_as_boundaries(Groups groups);

/// Whether a curve lies between elements: an interface that is not open.
std::vector<bool> inner_curves(const QuadMesh& mesh);

/// The edges on interfaces, each once: from the side whose curve has the lower number.
std::vector<QuadBoundaryEdge> interface_edges_once(const QuadMesh& mesh);

/// Gives the name block_<number> to each block without a name of its own (it has none, or that of the face or of its
/// region), so that it becomes a region of its own.
void separate_blocks(const CadFace& face, const std::vector<int>& block_region, std::vector<std::string>& block_names,
                     std::vector<int>& unnamed_blocks);

/// The region of each block of a mesh or a layout, and separate_blocks of it.
template <typename Stage>
std::vector<std::string> region_of_blocks(const Stage& stage) {
  return quadrille::region_of_blocks(stage.face, stage.block_region, stage.block_names, stage.unnamed_blocks);
}
template <typename Stage>
void separate_blocks(Stage& stage) {
  separate_blocks(stage.face, stage.block_region, stage.block_names, stage.unnamed_blocks);
}

using NameList = std::vector<std::string>;  ///< names of groups in a file, group by group

/// The words that a format allows as names.
struct WordRules {
  NameList taken{};              ///< words that mean something else
  std::size_t max_length = 0;    ///< 0: any
  bool is_case_ignored = false;  ///< words that differ in upper and lower case only are one
};

/// Each name by ASCII letters, digits and _ . - alone, the first one a letter or _ ; any other character becomes _ .
/// Names that are too long are cut; those that would coincide, also with one of the words taken, are numbered (_2, _3,
/// ...). Names that are such words already are not changed.
NameList plain_names(const NameList& names, const WordRules& rules = {});

/// "1 name is written in plain letters: \"outer wall\" as outer_wall" for the first few, "in at most 32 plain letters"
/// where the rules limit that; empty if none is.
std::string renamed_loss(const NameList& names, const NameList& plain, const WordRules& rules = {});

/// The table as a side file: .names.json behind the name of the main file, so that those of two formats differ. Groups
/// count from 1, in the order of the mesh, interfaces after the boundaries. `boundaries` and `regions` are what the
/// main file calls them: a word that is not the name is listed as its "tag"; regions are omitted if `regions` is empty.
SideFile names_table(const Groups& groups, const NameList& boundaries, const NameList& regions,
                     bool with_interfaces = false);

/// Single words for the names of all groups, and a report of the loss with the table of the names, if there is one.
/// Without regions, those have no words and no loss.
struct PlainNames {
  NameList boundaries, regions;
};
PlainNames add_plain_names(const Groups& groups, bool with_regions, const WordRules& rules, Exported& exported);

/// "2 interfaces are not stored: \"fluid-solid\", \"wake\"" for formats that name the boundary alone; empty if there is
/// none.
std::string interface_loss(const Groups& groups);

/// "3 region names are not stored". Empty if nothing is lost: one name for all, or only the default names
/// block_<number>.
std::string region_loss(const Groups& groups);

}  // namespace quadrille::exports
