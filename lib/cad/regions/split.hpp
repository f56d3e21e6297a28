#pragma once
// One struct for each region of a face of several regions, as if each were alone: loops, curves, joints, elements and
// vertices count from 0, curves have partners in the same region only, and lengths in diameters refer to the diameter
// of the region. The origin stays that of the whole. For one region: the struct itself.

#include <vector>

#include "model/critical_points.hpp"
#include "model/field.hpp"

namespace quadrille::regions {

std::vector<CadFace> split(const CadFace& face);

/// The repairs stay with the first mesh.
std::vector<TriMesh> split(const TriMesh& mesh);

std::vector<Field> split(const Field& field);

/// Nodes belong to the region that contains their position: after an edit, their elements need not. The parts have what
/// later stages need: nodes, corners and windings, without history and certificate. `mesh`: of the field. Throws
/// FormatError with the position of a node that is in no region.
std::vector<CriticalPoints> split(const CriticalPoints& points, const TriMesh& mesh);

}  // namespace quadrille::regions
