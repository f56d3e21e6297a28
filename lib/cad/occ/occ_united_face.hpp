#pragma once
// Faces of one surface as one face of the kernel, with the edges inside it: cracks, and those that two faces share.

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <string>
#include <vector>

#include "heal/raw_face.hpp"
#include "occ/occ_face.hpp"
#include "occ/occ_model.hpp"

namespace quadrille::occ {

struct LabelledEdge {
  TopoDS_Edge edge;      ///< forward
  heal::RawEdge labels;  ///< without its curve
  /// On its left and on its right, seen against the normal of the surface, as numbers in the choice; -1: none.
  std::array<int, 2> faces{0, 0};

  int bounded_face() const { return std::max(faces[0], faces[1]); }
};

struct UnitedFace {
  TopoDS_Face face;                 ///< forward, completed (occ_completed_face.hpp), on the surface of the first face
  std::vector<LabelledEdge> outer;  ///< which bound it, each once, seams among them
  std::vector<LabelledEdge> inner;
};

/// The chosen faces as one. Numbers of edges are those in the file's face, and count on from face to face. An edge that
/// a face has on both sides is an inner one, unless the surface closes there and the face goes all the way round: then
/// it is a seam. Edges of no face that lie inside are inner ones too. Throws FormatError, beginning with `file`, with
/// the faces, the place and a remedy, for faces of different surfaces, that overlap, or that share no edge.
/// `tolerance`: a length, within which edges of different faces are one (occ_shared_edges.hpp).
UnitedFace united_face(const OccModel& model, const std::vector<FaceChoice>& choices, const std::string& file,
                       double tolerance);

}  // namespace quadrille::occ
