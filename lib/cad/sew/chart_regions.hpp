#pragma once
// Curves inside the chart of a curved face: cracks, and the common edges of several faces of one surface.

#include <string>
#include <vector>

#include "base/report.hpp"
#include "model/cad_face.hpp"
#include "sew/chart_nodes.hpp"

namespace quadrille::sew {

struct ChartRegionOptions {
  std::string file;                     ///< for messages
  double tolerance = 0;                 ///< a length in space: the most that ends are moved to meet
  double corner_angle = 0;              ///< radians, as in outline::AssembleOptions
  std::vector<std::string> face_names;  ///< of the faces of the file; empty if it has none
  std::vector<int> curve_faces;         ///< of each curve of the boundary: the face on its left
  double slip = MeetOptions{}.slip;     ///< as there
};

/// The face of a chart, which may have regions, with the curves embedded: each is there twice, in opposite directions,
/// in the chart and in space, bit for bit, as CadFace::partners says. Curves that cross, or end on another one, are cut
/// there; what closes is a region, with the name of its face. Joints of the boundary stay as they are. Throws
/// FormatError, with edges, place and remedy, for curves that touch at an angle of zero or end just before another one,
/// and for faces that overlap.
CadFace divided_chart(const CadFace& face, const std::vector<ChartCurve>& curves, const ChartRegionOptions& options,
                      Report& report);

}  // namespace quadrille::sew
