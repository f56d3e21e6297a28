#pragma once
// The writers of the formats, one source for each program; format_table has a row for each of them. They throw
// ComputeError, with the position, for a mesh that the format cannot hold. Writers of hexahedra are overloads, but for
// abaqus_c3d; boundaries are groups of faces there, positions are those of the CAD model.

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "export/exported.hpp"
#include "export/patches.hpp"
#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// What writers of texts have in common.
class TextWriter {
 protected:
  template <class... Args>
  void print(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
  }
  std::string out_;
};

/// Gmsh MSH (ASCII), versions 4.1 and 2.2: physical groups for boundaries and blocks, orders 1-10, equispaced nodes.
Exported gmsh_msh41(const QuadMesh& mesh, const Frame& frame);
Exported gmsh_msh22(const QuadMesh& mesh, const Frame& frame);
Exported gmsh_msh41(const HexMesh& mesh);  ///< orders 1-9
Exported gmsh_msh22(const HexMesh& mesh);

/// MSH 4.1 as PyFR reads it: orders 1-4, one group "fluid" of all elements, no lines inside, periodic sides in groups
/// periodic_0_l and periodic_0_r, periodic_1_l ... Names are single words in which upper and lower case are the same.
Exported gmsh_pyfr(const QuadMesh& mesh, const Frame& frame);

/// VTK's XML for ParaView, VisIt and PyVista: Lagrange or Bezier cells of orders 1-10, with the blocks, the names and
/// the quality of the elements; curves of the boundary and of the interfaces in a side file.
Exported vtu_lagrange(const QuadMesh& mesh, const Frame& frame);
Exported vtu_bezier(const QuadMesh& mesh, const Frame& frame);
Exported vtu_lagrange(const HexMesh& mesh);  ///< faces of boundaries and interfaces in a side file
Exported vtu_bezier(const HexMesh& mesh);

/// Nektar++ XML: vertices, edges, quads, curved edges and, where the sides do not determine the element, curved faces;
/// composites with names for boundaries and regions; a default expansion. Any order; the nodes are those of the quad
/// mesh (GaussLobattoLegendre). Lossless but for control characters in names, which XML cannot represent. SPACE="3" if
/// the frame is not the plane z = 0.
Exported nektar_xml(const QuadMesh& mesh, const Frame& frame);
Exported nektar_xml(const HexMesh& mesh);  ///< nodes inside elements are lost, which it reports

/// MFEM mesh v1.0 and v1.3 (named attribute sets): any order, the nodes of the quad mesh (H1, Gauss-Lobatto), regions
/// and boundaries as attributes counted from 1 each. Positions are lossless; v1.0 has no names, they are written to a
/// table beside it. Three coordinates if the frame is not the plane z = 0. MFEM identifies edges by their ends: no two
/// may join the same two vertices.
Exported mfem_mesh10(const QuadMesh& mesh, const Frame& frame);
Exported mfem_mesh13(const QuadMesh& mesh, const Frame& frame);
Exported mfem_mesh10(const HexMesh& mesh);  ///< faces too must differ by their vertices
Exported mfem_mesh13(const HexMesh& mesh);

/// HOHQMesh ISM-V2 (Trixi.jl's UnstructuredMesh2D, SELF): corners, edges with their elements, curved sides at
/// Chebyshev-Lobatto points, names of sides. ISM-MM has the materials of elements, and no edges. Any order. No element
/// may be folded once its interior is rebuilt from its sides.
Exported hohqmesh_ism(const QuadMesh& mesh, const Frame& frame);
Exported hohqmesh_ism_mm(const QuadMesh& mesh, const Frame& frame);

/// Abaqus .inp in HOHQMesh's flavour (Trixi.jl's P4estMesh and T8codeMesh): straight quads in Abaqus' own words, which
/// p4est reads, then curved sides at Chebyshev-Lobatto points and names of sides in comments. Any order; elements as
/// for ISM, edges as for MFEM.
Exported abaqus_inp(const QuadMesh& mesh, const Frame& frame);
Exported abaqus_inp(const HexMesh& mesh);  ///< curved faces at Chebyshev-Lobatto points; nodes inside are lost

/// Nek5000 .re2: corners, quadratic sides, numbers of boundaries; beside it the geometry of full order as a field file
/// NAME0.f00000 to start from (.par: startFrom = "NAME0.f00000 X") and the table of names. Any order; elements as for
/// ISM, edges as for MFEM.
Exported nek_re2(const QuadMesh& mesh, const Frame& frame);
Exported nek_re2(const HexMesh& mesh);  ///< edges and faces must differ by their vertices

/// OpenFOAM's blockMeshDict: one hexahedral block for each block of the layout, one cell thick, its sides as splines
/// with one graded section for each cell, boundaries as patches, regions as cell zones. Any order; cells have straight
/// sides and must be convex. `types`: of patches, where they shall not follow from the names.
Exported block_mesh_dict(const QuadMesh& mesh, const Frame& frame, const std::vector<PatchType>& types = {});
/// Straight sweeps of planar faces, with their layers; others are refused.
Exported block_mesh_dict(const HexMesh& mesh, const std::vector<PatchType>& types = {});

/// OpenFOAM's polyMesh: points, and beside them faces, owner, neighbour, boundary and cellZones. A cell for each
/// hexahedron, with straight edges; of a quad mesh a plate one cell thick, its ends `frontAndBack` of type empty.
Exported poly_mesh(const QuadMesh& mesh, const Frame& frame, const std::vector<PatchType>& types = {});
Exported poly_mesh(const HexMesh& mesh, const std::vector<PatchType>& types = {});

/// Abaqus .inp for Abaqus and CalculiX: plane stress (CPS), plane strain (CPE) or axisymmetric elements (CAX) of 4
/// nodes for order 1, of 8 for order 2; higher orders are split into elements of order 2. Regions are element sets,
/// boundaries and interfaces node sets and surfaces. No element may be folded; x of CAX, the radius, is not negative.
Exported abaqus_cps(const QuadMesh& mesh, const Frame& frame);
Exported abaqus_cpe(const QuadMesh& mesh, const Frame& frame);
Exported abaqus_cax(const QuadMesh& mesh, const Frame& frame);
Exported abaqus_c3d(const HexMesh& mesh);  ///< C3D8 and C3D20, orders 1 and 2

/// PLOT3D, multi-grid, ASCII: a grid of points for each block, its boundaries and neighbours in a neutral map beside
/// it. Any order; cells must be convex.
Exported plot3d(const QuadMesh& mesh, const Frame& frame);
Exported plot3d(const HexMesh& mesh);  ///< the grids of the quads times the layers; no cell may be folded

/// CGNS, as the request from which quadexport-cgns makes the file (export/cgns_request.hpp): one unstructured zone of
/// orders 1-4 with sections for regions, boundaries and interfaces, or a structured zone for each block with its
/// boundaries and neighbours, of any order; cells must be convex then. Boundaries and regions are families.
Exported cgns_unstructured(const QuadMesh& mesh, const Frame& frame);
Exported cgns_structured(const QuadMesh& mesh, const Frame& frame);
Exported cgns_unstructured(const HexMesh& mesh);
Exported cgns_structured(const HexMesh& mesh);

/// Exodus II, as the request from which quadexport-netcdf makes the file (export/netcdf_request.hpp): QUAD4 for order
/// 1, QUAD9 for order 2; higher orders are split into elements of order 2. Regions are blocks, boundaries and
/// interfaces side sets. No element may be folded.
Exported exodus(const QuadMesh& mesh, const Frame& frame);
Exported exodus(const HexMesh& mesh);  ///< HEX8 and HEX27, orders 1 and 2
/// The same with nodes on edges alone: QUAD8 and HEX20.
Exported exodus_serendipity(const QuadMesh& mesh, const Frame& frame);
Exported exodus_serendipity(const HexMesh& mesh);

/// SPECFEM2D's text files: elements of 4 nodes for order 1, of 9 for order 2; higher orders are split into elements of
/// order 2. Nodes, numbers of materials, and the free and absorbing sides in files beside them. No element may be
/// folded.
Exported specfem2d(const QuadMesh& mesh, const Frame& frame);

/// SU2's mesh: quads with straight sides between the nodes of the mesh, N^2 for an element of order N; boundaries as
/// markers. Any order; the quads must be convex.
Exported su2_mesh(const QuadMesh& mesh, const Frame& frame);
Exported su2_mesh(const HexMesh& mesh);  ///< N^3 hexahedra with straight edges, each proved not to be folded

}  // namespace quadrille::exports
