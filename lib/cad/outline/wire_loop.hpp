#pragma once
// Converts one wire of the file to a closed loop of curves, in the order and direction of the wire.

#include "base/report.hpp"
#include "heal/loop.hpp"
#include "heal/raw_face.hpp"

namespace quadrille::outline {

using heal::Loop;
using heal::LoopCurve;

/// `tol`, a length: gaps up to `tol` are closed, edges shorter than `tol` are dropped with a warning. Throws
/// FormatError for a wider gap and for vertices that do not lie at the ends of their edge.
Loop wire_loop(const heal::RawFace& raw, const std::vector<heal::RawEdge>& wire, double tol, Report& report);

/// The parts of the edge between the tangent jumps inside it.
std::vector<LoopCurve> smooth_pieces(const heal::RawEdge& edge);

/// The same loop in the opposite direction, starting with the same curve.
Loop reversed(const Loop& loop);

/// The curves of a loop without their labels.
std::vector<Nurbs> curves_of(const Loop& loop);

}  // namespace quadrille::outline
