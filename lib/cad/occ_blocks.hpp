#pragma once
// A block layout as an OpenCASCADE shell with shared edges and vertices.

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <string>
#include <utility>
#include <vector>

#include "model/block_layout.hpp"

namespace quadrille::cad {

struct OccBlocks {
  TopoDS_Shell shell;
  std::vector<TopoDS_Face> faces;                          ///< one per block
  std::vector<std::pair<TopoDS_Edge, std::string>> names;  ///< of boundary edges
};

/// `scale`: factor from the length unit of the layout to the unit of the shell.
OccBlocks occ_blocks(const BlockLayout& layout, double scale);

}  // namespace quadrille::cad
