#pragma once
// A block layout or a face as an OpenCASCADE shape with shared edges and vertices.

#include <TopoDS_Shape.hxx>
#include <string>
#include <utility>
#include <vector>

#include "model/block_layout.hpp"

namespace quadrille::occ {

struct OccShape {
  TopoDS_Shape shape;
  std::vector<std::pair<TopoDS_Shape, std::string>> names;  ///< of faces and boundary edges
};

/// A shell with one face for each block. `scale`: factor from the length unit of the layout to the unit of the shell.
OccShape occ_blocks(const BlockLayout& layout, double scale);

/// A face with one edge for each curve, or a shell with a face for each region, in which both sides of a common curve
/// are one edge; loops of slits are free edges beside them, in a compound. Only edges and regions with a given name are
/// named.
OccShape occ_face_shape(const CadFace& face, double scale);

}  // namespace quadrille::occ
