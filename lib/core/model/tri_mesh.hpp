#pragma once
// The curved triangle mesh on which the field is solved (formats/tri-mesh.md).
//
// Reference triangle: xi1, xi2 >= -1, xi1 + xi2 <= 0, vertices (-1,-1), (1,-1), (-1,1), counter-clockwise. Local edge
// k runs from local vertex k to local vertex k+1 (mod 3). Elements are counter-clockwise. An element that is not in
// `curved_elems` is the affine image of the reference triangle. Curved ones have geometry nodes at
// spectral/tri_map(order), Gauss-Lobatto-Legendre on the edges.

#include <array>
#include <vector>

#include "base/vec2.hpp"
#include "model/cad_face.hpp"
#include "model/provenance.hpp"
#include "model/repair.hpp"

namespace quadrille {

/// An element edge on the boundary: local edge `edge` of `elem` follows `curve` from parameter t0 to t1 (t0 < t1: the
/// element lies on the left of the curve). Its geometry nodes lie on the curve, at Gauss-Lobatto-Legendre fractions of
/// the ARC LENGTH between t0 and t1.
struct BoundaryEdge {
  int elem = 0;
  int edge = 0;
  int curve = 0;
  double t0 = 0, t1 = 0;
};

struct TriMesh {
  Provenance provenance;
  CadFace face;
  int order = 1;  ///< shape order N
  std::vector<Vec2> vertices;
  std::vector<std::array<int, 3>> elem2vertices;
  std::vector<int> curved_elems;             ///< ascending
  std::vector<Vec2> curved_nodes;            ///< (N+1)(N+2)/2 per curved element, in the order of spectral/tri_map
  std::vector<BoundaryEdge> boundary_edges;  ///< sorted by curve, then t0: each loop in turn
  std::vector<Repair> repairs;               ///< what healing changed in the boundary of the CAD file
  /// Of several regions, which share no vertex: region r has the elements [region_elems[r], region_elems[r+1]). Empty
  /// for one region.
  std::vector<int> region_elems;
  std::vector<int> elem_layer;  ///< -1, or the layer of the corner fan of the element: 0 is at the apex

  int num_elems() const { return static_cast<int>(elem2vertices.size()); }
};

}  // namespace quadrille
