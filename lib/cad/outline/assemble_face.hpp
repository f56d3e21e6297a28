#pragma once
// From the edges of a face as read from the file to the checked boundary of model/cad_face.hpp.

#include <vector>

#include "base/report.hpp"
#include "heal/raw_face.hpp"
#include "model/repair.hpp"
#include "outline/face_of_loops.hpp"

namespace quadrille::outline {

/// The greatest distance between two points of the edges. Throws FormatError if there are no edges, or a coordinate is
/// not a number.
double raw_diameter(const heal::RawFace& raw);

struct AssembleOptions {
  double corner_angle = 0.017453292519943295;  ///< radians; greater tangent jumps are corners of the layout
  double blunt_width = 0;                      ///< as in heal::BluntOptions
  FacePiece piece = {};
  double fit_tolerance = 0;  ///< diameters: splines with many knots are replaced by ones this near to them; 0: none is
  bool keeps_contacts = false;  ///< as in heal::BluntOptions: the loops may pass a point several times
};

/// The boundary of a face, checked.
struct AssembledLoops {
  std::vector<heal::Loop> loops;  ///< with the face on their left, the outline first
  double fit_distance = 0;        ///< as in CadFace, a length
};

/// Chains the edges of each wire, splits curves at tangent jumps, makes the ends of neighbours identical, orients loops
/// so that the face lies on the left, sorts the outline first, chooses a piece where the boundary touches itself, cuts
/// off cusps and simplifies splines. Throws FormatError, with the error, its position, size and a remedy, for an open
/// or self-intersecting wire, vertices off their edges, holes outside or across the outline, a cusp, or a face without
/// area. Adds what was cut off to `repairs`.
AssembledLoops assembled_loops(const heal::RawFace& raw, const AssembleOptions& options, std::vector<Repair>& repairs,
                               Report& report);

/// The same, with joints, names, diameter and origin (face_of_loops.hpp). Sets `face.area` in the report.
CadFace assemble_face(const heal::RawFace& raw, const AssembleOptions& options, std::vector<Repair>& repairs,
                      Report& report);

}  // namespace quadrille::outline
