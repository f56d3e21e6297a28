#pragma once
// Hexahedral cells with straight edges, as finite volume programs see them: faces with an owner and a neighbour, their
// centres and area vectors, centres and volumes of cells.
//
// A face is cut into triangles round the mean of its corners. Its area vector S is the sum of theirs, its centre the
// mean of their centroids, weighted by their areas (H. Jasak, Error Analysis and Estimation for the Finite Volume
// Method with Applications to Fluid Flows, Imperial College 1996, section 3.2; OpenFOAM's
// primitiveMeshFaceCentresAndAreas.C, code_saturne's cs_mesh_quantities.c).

#include <array>
#include <vector>

#include "base/vec3.hpp"
#include "model/hex_mesh.hpp"

namespace quadrille::mesh {

struct StraightFace {
  std::array<int, 4> corners{};   ///< in StraightCells::points, the outside of the owner on the reader's side
  int owner = 0, neighbour = -1;  ///< cells; -1: on the boundary
};

/// Two faces of the boundary between cells that a program treats as neighbours.
struct CoupledFaces {
  int first = 0, second = 0;  ///< in StraightCells::faces
  SpaceMotion motion;         ///< rigid, of the first face onto the second
};

struct StraightCells {
  std::vector<Vec3> points;
  std::vector<StraightFace> faces;
  std::vector<CoupledFaces> coupled;
  std::vector<std::vector<int>> planes;  ///< faces that the program requires to lie on one plane, set by set
  int num_cells = 0;
  bool is_plate = false;  ///< one cell thick along z, which no program solves for
};

/// Where the centre of a cell is: the centroid of the pyramids from the mean of the faces' centres (OpenFOAM), or the
/// mean of the faces' centres, weighted by areas (code_saturne's default).
enum class CellCentre { volume, surface };

struct CellGeometry {
  std::vector<Vec3> face_centres, face_areas;  ///< by face; an area points out of its owner
  std::vector<Vec3> centres;                   ///< by cell
  std::vector<double> volumes;
};

/// Linear cost.
CellGeometry cell_geometry(const StraightCells& cells, CellCentre centre);

}  // namespace quadrille::mesh
