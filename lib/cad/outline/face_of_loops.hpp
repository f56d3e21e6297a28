#pragma once
// From the wires of the file to loops of curves, with splines of few knots, and from checked loops to the boundary of
// model/cad_face.hpp, and to its pieces where it touches itself; which joints are corners.

#include <string>
#include <vector>

#include "base/report.hpp"
#include "heal/raw_face.hpp"
#include "model/cad_face.hpp"
#include "model/repair.hpp"

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

/// Simplifies the curves of the loops; `tolerance`: the most that they may move, in diameters (0: none is simplified),
/// `diameter`: of the face, a length. Adds a repair of kind `fit` for each curve that was replaced, also to the report,
/// with the keys fit.*. Returns the greatest distance by which a curve moved, a length.
double simplify_loops(std::vector<heal::Loop>& loops, double tolerance, double diameter, std::vector<Repair>& repairs,
                      Report& report);

/// The joint at which `in` ends and `out` starts; `corner_angle`, radians: a greater tangent jump is a corner.
Joint joint_between(const Nurbs& in, const Nurbs& out, double corner_angle);

/// The face with these loops in the plane and the unit of `raw`: origin, diameter, joints, names. Curves without a name
/// are numbered. `outline`: the curves that go around the face, in the coordinates of `loops`; `corner_angle`: radians.
/// Not set: the face's own name, its fit distance, regions.
CadFace face_of_loops(const heal::RawFace& raw, const std::vector<heal::Loop>& loops, const std::vector<Nurbs>& outline,
                      double corner_angle);

/// The piece that is asked for of a face which touches itself.
struct FacePiece {
  std::string face = "0";  ///< name or number of the face, for messages
  int number = -1;         ///< as in face_pieces(); -1: the only piece
};

/// The loops of each piece: one that goes around it counter-clockwise comes first, then its holes in the order of
/// `loops`. The piece with the largest outline comes first; areas within 1e-6 of each other keep the order of `loops`.
/// Each hole belongs to the smallest outline around it. `loops`: with the face on their left (heal::separated_loops).
std::vector<std::vector<heal::Loop>> face_pieces(const std::vector<heal::Loop>& loops);

/// A greater kink, degrees, gives a corner another valence than 2 within the window of ties (lib/method.md §3).
inline constexpr double greatest_polyline_kink = 43;

/// Fewer kinks stay corners: lines from them can be followed to their ends, and elements are better with them.
inline constexpr int many_polyline_kinks = 200;

/// Corners inside polylines whose tangent jumps by at most `kink`, radians, become smooth joints if they are `many` or
/// more: no line of the layout starts there. A polyline is a chain of eight straight curves or more of one loop, each
/// shorter than a fiftieth of the diameter: it samples a curve or a coast, and lines from each of its corners would be
/// far nearer to each other than elements of any useful size. The field keeps its exact boundary data, and elements
/// still end at each joint. For a face of one region; another stays, because its lines must match across interfaces.
/// Returns the number of corners that became smooth.
int smooth_polylines(CadFace& face, double kink, int many = many_polyline_kinks);

}  // namespace quadrille::outline
