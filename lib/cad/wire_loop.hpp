#pragma once
// One wire of the file -> one closed loop of curves, in the sequence and direction in which the wire runs.

#include "base/report.hpp"
#include "cad/raw_face.hpp"

namespace quadrille::cad {

/// A curve of the loop without inner tangent jumps, and where it comes from.
struct LoopCurve {
  Nurbs curve;
  int cad_edge = 0;
  std::string name;
};

using Loop = std::vector<LoopCurve>;

/// `tol`: gaps up to it are closed, edges shorter than it are dropped with a warning. Throws FormatError for a wider
/// gap and for vertices that do not lie at the ends of their edge.
Loop wire_loop(const RawFace& raw, const std::vector<RawEdge>& wire, double tol, Report& report);

/// The same loop walked the other way, beginning with the same curve.
Loop reversed(const Loop& loop);

std::vector<Nurbs> curves_of(const Loop& loop);

/// position_text, with coordinates that are only rounding errors of the other one as 0.
std::string rounded_position_text(Vec2 x);

}  // namespace quadrille::cad
