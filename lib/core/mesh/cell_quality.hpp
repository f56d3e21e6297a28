#pragma once
// How well suited straight cells are for finite volumes, as the programs measure it that compute on them.
//
// d is the line from the centre of a face's owner to that of its neighbour, S the area vector of the face, F its
// centre, O the point where the line of d meets the plane of the face, V the volume of a cell. Sources: OpenFOAM,
// primitiveMeshTools.C and polyMeshTools.C; symmetryPlanePolyPatch.C; code_saturne, cs_mesh_bad_cells.c.

#include <vector>

#include "base/vec3.hpp"
#include "mesh/straight_cells.hpp"

namespace quadrille::mesh {

/// A value of a cell, or of a face of it.
struct CellSample {
  double value = 0;
  int cell = 0;   ///< of a face its owner
  Vec3 position;  ///< the centre of the face or cell
};

/// Angle between d and S in degrees, of faces between two cells and of coupled faces.
std::vector<CellSample> face_angles(const StraightCells& cells, const CellGeometry& geometry);

/// Angle between S and the line from the centre of the cell to F in degrees, of faces of the boundary.
std::vector<CellSample> boundary_face_angles(const StraightCells& cells, const CellGeometry& geometry);

/// |FO| over the half width of the face along FO: the greatest |e . (x - F)| of its corners x, e = FO / |FO|, but at
/// least 0.2 |d|. On the boundary O is the foot of the perpendicular from the cell's centre on the face, at the
/// distance h, and the least half width 0.4 h.
std::vector<CellSample> face_skewness(const StraightCells& cells, const CellGeometry& geometry);

/// Of the sums of |S_x|, |S_y| and |S_z| over the faces of a cell, the greatest over the least; at least a sixth of
/// their sum over V^(2/3). Of a plate those of x and y alone.
std::vector<CellSample> cell_aspects(const StraightCells& cells, const CellGeometry& geometry);

/// Volume of the pyramid from a face to the centre of each of its cells, times the cell's number of faces over V:
/// of a cube 1, not positive if the face cannot be seen from there.
std::vector<CellSample> face_pyramids(const StraightCells& cells, const CellGeometry& geometry);

/// |n - m| of the faces of each set of StraightCells::planes, n the normal of the face, m their mean in the set.
std::vector<CellSample> plane_deviations(const StraightCells& cells, const CellGeometry& geometry);

/// The greater V over the smaller one, of faces between two cells.
std::vector<CellSample> volume_ratios(const StraightCells& cells, const CellGeometry& geometry);

/// 1 - (|FO| |S| / V)^(1/3), of the smaller V, of faces between two cells.
std::vector<CellSample> face_offsets(const StraightCells& cells, const CellGeometry& geometry);

/// The least over the greatest eigenvalue of the sum of e e^T over the faces of a cell, e = d / |d|, on the boundary
/// S / |S|: how well least squares determine a gradient.
std::vector<CellSample> gradient_conditions(const StraightCells& cells, const CellGeometry& geometry);

}  // namespace quadrille::mesh
