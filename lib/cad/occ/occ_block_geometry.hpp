#pragma once
// What blocks are as OpenCASCADE shapes: in a plane (occ_blocks) or on a curved face (occ_surface_blocks). The shell of
// the blocks, which occ_blocks builds, knows neither.

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <memory>
#include <vector>

#include "model/block_layout.hpp"

namespace quadrille::occ {

/// A step of the boundary of a block: an edge in one of its two directions.
struct EdgeUse {
  TopoDS_Edge edge;  ///< in its own direction
  bool is_backwards = false;
};

class BlockGeometry {
 public:
  virtual ~BlockGeometry() = default;
  /// Of the graph node n.
  virtual TopoDS_Vertex vertex(int n) = 0;
  /// Of the end of a piece inside an arc.
  virtual TopoDS_Vertex vertex_at_end(const ArcPiece& piece) = 0;
  /// Of a piece of an arc, between two of these vertices. Throws ComputeError if it does not end there.
  virtual TopoDS_Edge edge(int arc, const ArcPiece& piece, const TopoDS_Vertex& from, const TopoDS_Vertex& to) = 0;
  /// Of a block with this counter-clockwise boundary.
  virtual TopoDS_Face face(int block, const std::vector<EdgeUse>& loop) = 0;
};

/// For a layout whose face has a chart. `scale`: factor from its length unit to the unit of the shapes. Throws
/// ComputeError if the face has several surfaces.
std::unique_ptr<BlockGeometry> surface_blocks(const BlockLayout& layout, double scale);

}  // namespace quadrille::occ
