#pragma once
// Where the curves of a chart meet, and the curves cut there.

#include <array>
#include <string>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::sew {

/// An inner curve in the chart and in space, with the same parameters.
struct ChartCurve {
  Nurbs image;
  SpaceCurve space;
  std::string name;            ///< empty if the file has none
  int cad_edge = 0;            ///< number of the edge in the file
  std::array<int, 2> faces{};  ///< of the file, on its left and on its right; -1: unknown
};

/// A part of a curve between two nodes, in the chart and in space. An interface is one curve, that of the partner with
/// the lower number.
struct ChartPiece {
  int curve = 0;  ///< of the boundary, or number of curves of the boundary + inner curve
  Nurbs image;
  SpaceCurve space;
  int from = 0, to = 0;                    ///< nodes
  bool is_first = false, is_last = false;  ///< it starts, or ends, where the curve does
};

struct MeetOptions {
  std::string file;      ///< for messages
  double tolerance = 0;  ///< a length in space
  double slip = 1e-3;    ///< diameters: an end as near to a curve was meant to be on it
};

/// The pieces of all curves, those of the boundary first. Ends of inner curves within the tolerance of a joint, of each
/// other or of another curve are one node with it; crossings are nodes. Positions of nodes are those of the boundary,
/// or of the curve on which the other one ends, bit for bit for all pieces. Of inner curves along the boundary, and
/// along each other, one remains. Throws FormatError, with edges and place, for curves that touch at an angle of zero,
/// and for an end that is just before another curve.
std::vector<ChartPiece> chart_pieces(const CadFace& face, const std::vector<ChartCurve>& curves,
                                     const MeetOptions& options);

}  // namespace quadrille::sew
