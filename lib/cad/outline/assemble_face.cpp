#include "outline/assemble_face.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/warning_codes.hpp"
#include "curve/chain.hpp"
#include "curve/pole_box.hpp"
#include "heal/blunt_cusps.hpp"
#include "heal/touching_loops.hpp"
#include "outline/extent.hpp"
#include "outline/face_of_loops.hpp"
#include "outline/outline_checks.hpp"

namespace quadrille::outline {
namespace {

// Joints, which healing leaves with rounding errors, are in contact if they are nearer than this part of the size.
constexpr double joint_share = 1e-7;

// Distance below which points coincide: the tolerance of the file, clamped in case it is wrong.
double gap_tolerance(const heal::RawFace& raw, double size) {
  return std::clamp(raw.tolerance, 1e-7 * size, 1e-5 * size);
}

std::vector<Nurbs> finite_curves(const heal::RawFace& raw) {
  std::vector<Nurbs> curves;
  for (const auto& wire : raw.wires)
    for (const heal::RawEdge& edge : wire) curves.push_back(edge.curve);
  if (curves.empty()) throw FormatError(raw.file + ": the face has no boundary");
  for (const Nurbs& curve : curves)
    for (const Vec2 p : curve.poles)
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) throw FormatError(raw.file + ": a coordinate is not a number");
  return curves;
}

// Refuses a degenerate face whose boundary is a line traversed forth and back; otherwise it would be reported as
// touching itself everywhere.
void require_width(const heal::RawFace& raw, const std::vector<Nurbs>& curves, double size) {
  const Vec2 a = curves.front().poles.front();
  Vec2 b = a;
  for (const Nurbs& curve : curves)
    for (const Vec2 p : curve.poles)
      if (distance(a, p) > distance(a, b)) b = p;
  double width = 0;
  for (const Nurbs& curve : curves)
    for (const Vec2 p : curve.poles) width = std::max(width, std::abs(cross(b - a, p - a)) / distance(a, b));
  if (!(width > 1e-9 * size))
    throw FormatError(fmt::format("{}: the face has no area: all of it lies on the line from {} to {}", raw.file,
                                  rounded_position_text(a), rounded_position_text(b)));
}

// Where the loops touch themselves or each other first.
Vec2 first_contact(const std::vector<Loop>& loops) {
  const auto contacts = heal::contacts_at_starts(loops);
  for (size_t l = 0; l < loops.size(); ++l)
    for (size_t i = 0; i < loops[l].size(); ++i)
      if (contacts[l][i]) return loops[l][i].curve.poles.front();
  return {};
}

void warn_of_common_lines(const heal::RawFace& raw, const std::vector<heal::CommonLine>& common, Report& report) {
  for (const heal::CommonLine& line : common)
    report.warn(warning::tip_cut_off,
                fmt::format("{}: edges {} and {} run along each other from {} to {}, {:.3g} long, with no width of the "
                            "face between them, and were cut off there; --blunt 0 refuses such faces",
                            raw.file, line.edge_a, line.edge_b, rounded_position_text(line.start),
                            rounded_position_text(line.end), line.length));
}

// The outline first, the other loops in the order of the file; each with the face on its left.
std::vector<Loop> sorted_loops(std::vector<Loop> loops) {
  std::vector<double> areas;
  for (const Loop& loop : loops) areas.push_back(signed_area(curves_of(loop)));
  const auto larger = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const size_t outer = std::max_element(areas.begin(), areas.end(), larger) - areas.begin();
  std::vector<Loop> sorted;
  sorted.push_back(areas[outer] > 0 ? std::move(loops[outer]) : reversed(loops[outer]));
  for (size_t l = 0; l < loops.size(); ++l)
    if (l != outer) sorted.push_back(areas[l] < 0 ? std::move(loops[l]) : reversed(loops[l]));
  return sorted;
}

double distance_to_end(const Nurbs& curve, double t) {
  const curve::ArcLength length(curve);
  return std::min(length.at(t), length.total() - length.at(t));
}

std::string size_text(double size, double diameter) {
  return fmt::format("{:.3g} ({:.2g} diameters)", size, size / diameter);
}

/// "the outline" or "hole 1".
std::string loop_name(size_t loop) { return loop == 0 ? "the outline" : fmt::format("hole {}", loop); }

/// Edges and place of a contact, its size, and what to do. The size is how far the place lies from the nearest end of
/// the two edges, or, if an edge meets itself, the length of the edge between both passes.
std::string contact_text(const std::vector<heal::Loop>& loops, const Contact& c, double diameter) {
  const heal::LoopCurve &a = loops[c.loop_a][c.curve_a], &b = loops[c.loop_b][c.curve_b];
  const std::string place = rounded_position_text(c.position);
  const std::string of_loop = c.loop_a == c.loop_b ? " of " + loop_name(c.loop_a) : "";
  if (&a == &b) {
    const double length = std::abs(curve::ArcLength(a.curve).between(c.t_a, c.t_b));
    return fmt::format("edge {}{} at {}, with {} of its length in between: draw it anew", a.cad_edge, of_loop, place,
                       size_text(length, diameter));
  }
  const double size = std::min(distance_to_end(a.curve, c.t_a), distance_to_end(b.curve, c.t_b));
  const std::string edges = a.cad_edge == b.cad_edge ? fmt::format("parts of edge {}", a.cad_edge)
                                                     : fmt::format("edges {} and {}", a.cad_edge, b.cad_edge);
  return fmt::format("{}{} at {}, {} from the nearest of their ends: trim them, or draw them apart", edges, of_loop,
                     place, size_text(size, diameter));
}

// The loops without the corners in which they touch.
std::vector<Loop> without_contacts(std::vector<Loop> loops, const heal::BluntOptions& options) {
  std::vector<Repair> unused;
  Report unused_report;
  heal::blunt_cusps(loops, {options.file, options.diameter, heal::automatic_width}, unused, unused_report);
  return loops;
}

void require_no_contact(const heal::RawFace& raw, const std::vector<Loop>& loops, double size, double diameter) {
  std::vector<std::vector<Nurbs>> curves;
  for (const Loop& loop : loops) curves.push_back(curves_of(loop));
  const auto c = find_contact(curves, contact_share * size);
  if (!c) return;
  const auto [first, second] = std::minmax(c->loop_a, c->loop_b);
  const std::string what = first == second
                               ? "the wire intersects itself"
                               : fmt::format("{} crosses or touches {}", loop_name(second), loop_name(first));
  throw FormatError(fmt::format("{}: {}: {}", raw.file, what, contact_text(loops, *c, diameter)));
}

void require_nested(const heal::RawFace& raw, const std::vector<Loop>& loops) {
  std::vector<std::vector<Nurbs>> curves;
  for (const Loop& loop : loops) curves.push_back(curves_of(loop));
  std::vector<curve::PoleBox> boxes;
  for (const auto& loop : curves) boxes.push_back(curve::pole_box(loop));
  const auto refuse = [&](size_t hole, const std::string& where) {
    throw FormatError(fmt::format(
        "{}: {} at {} lies {}; it is {:.3g} across: draw it elsewhere, or as a face of its own", raw.file,
        loop_name(hole), rounded_position_text(curves[hole].front().poles.front()), where, boxes[hole].diagonal()));
  };
  for (size_t hole = 1; hole < loops.size(); ++hole) {
    const Vec2 x = curves[hole].front().poles.front();
    if (winding_number(curves[0], x) != 1) refuse(hole, "outside the outline");
    for (size_t other = 1; other < loops.size(); ++other)
      if (other != hole && boxes[other].contains(x) && winding_number(curves[other], x) != 0)
        refuse(hole, "inside " + loop_name(other));
  }
}

// The loops of the piece of the face that is asked for, or of its only piece.
std::vector<Loop> chosen_piece(const heal::RawFace& raw, const std::vector<Loop>& loops, const FacePiece& choice) {
  std::vector<std::vector<Loop>> pieces = face_pieces(loops);
  const int count = static_cast<int>(pieces.size());
  if (choice.number < count && (choice.number >= 0 || count == 1)) return pieces[std::max(choice.number, 0)];
  if (count == 1)
    throw FormatError(
        fmt::format("{}: --face {}.{}: the face has one piece, number 0", raw.file, choice.face, choice.number));
  throw FormatError(
      fmt::format("{}: the boundary of the face touches itself, with no width in between, at {}, and separates {} "
                  "pieces: choose one "
                  "with --face {}.0 to {}.{}, the largest first",
                  raw.file, rounded_position_text(first_contact(loops)), count, choice.face, choice.face, count - 1));
}

}  // namespace

double raw_diameter(const heal::RawFace& raw) { return diameter(finite_curves(raw)); }

AssembledLoops assembled_loops(const heal::RawFace& raw, const AssembleOptions& options, std::vector<Repair>& repairs,
                               Report& report) {
  const double size = curve::pole_box(finite_curves(raw)).diagonal(), tol = gap_tolerance(raw, size);
  std::vector<Loop> loops;
  for (const auto& wire : raw.wires) loops.push_back(wire_loop(raw, wire, tol, report));
  loops = sorted_loops(std::move(loops));
  require_width(raw, curves_of(loops.front()), size);
  std::vector<heal::CommonLine> common;
  loops = heal::separated_loops(loops, {joint_share * size, contact_share * size},
                                options.blunt_width == 0 ? nullptr : &common);
  warn_of_common_lines(raw, common, report);
  loops = chosen_piece(raw, loops, options.piece);
  const heal::BluntOptions blunt{raw.file, diameter(curves_of(loops.front())), options.blunt_width,
                                 options.keeps_contacts};
  heal::blunt_cusps(loops, blunt, repairs, report);
  if (!options.keeps_contacts) heal::refuse_contacts(loops, blunt);
  const double fit_distance = simplify_loops(loops, options.fit_tolerance, blunt.diameter, repairs, report);
  require_no_contact(raw, options.keeps_contacts ? without_contacts(loops, blunt) : loops, size, blunt.diameter);
  require_nested(raw, loops);
  heal::refuse_cusps(loops, blunt);
  return {loops, fit_distance};
}

CadFace assemble_face(const heal::RawFace& raw, const AssembleOptions& options, std::vector<Repair>& repairs,
                      Report& report) {
  const AssembledLoops assembled = assembled_loops(raw, options, repairs, report);
  CadFace face = face_of_loops(raw, assembled.loops, curves_of(assembled.loops.front()), options.corner_angle);
  face.name = raw.name;
  face.fit_distance = assembled.fit_distance;
  report.set("face.area", area(face));
  return face;
}

}  // namespace quadrille::outline
