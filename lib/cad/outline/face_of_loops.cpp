#include "outline/face_of_loops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/name_text.hpp"
#include "base/tolerance.hpp"
#include "base/warning_codes.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "curve/simplify_spline.hpp"
#include "heal/blunt_cusps.hpp"
#include "heal/heal_rules.hpp"
#include "heal/wire_edges.hpp"
#include "outline/extent.hpp"
#include "outline/outline_checks.hpp"

namespace quadrille::outline {

namespace {

// Smaller tangent jumps are rounding errors of the decimal numbers in a text file.
constexpr double smallest_jump = 1e-9;

void require_vertices_on_ends(const heal::RawFace& raw, const heal::RawEdge& edge, double tol) {
  for (const auto& [vertex, end] :
       {std::pair{edge.start, edge.curve.poles.front()}, std::pair{edge.end, edge.curve.poles.back()}}) {
    const double gap = distance(vertex, end);
    if (!(gap <= tol))
      throw FormatError(fmt::format("{}: edge {}: its vertex at {} lies {:.3g} off its curve", raw.file, edge.cad_edge,
                                    rounded_position_text(vertex), gap));
  }
}

// Inner knots at which the tangent jumps. Below full multiplicity the tangent can jump only where the derivative
// vanishes.
std::vector<double> jumps(const Nurbs& curve) {
  std::vector<double> result;
  const double scale = 1e-9 * curve::polygon_length(curve) / (curve.end() - curve.begin());
  for (size_t k = curve.degree + 1; k + curve.degree + 1 < curve.knots.size(); ++k) {
    const double t = curve.knots[k];
    if (t == curve.knots[k - 1]) continue;
    const auto multiplicity = std::count(curve.knots.begin(), curve.knots.end(), t);
    if (multiplicity < curve.degree && norm(curve::derivatives(curve, t)[1]) > scale) continue;
    const Vec2 a = curve::tangent(curve, t, true), b = curve::tangent(curve, t);
    if (std::abs(std::atan2(cross(a, b), dot(a, b))) > smallest_jump) result.push_back(t);
  }
  return result;
}

// Moves the ends of neighbours to the middle of the gap caused by rounding.
void close_gaps(Loop& loop) {
  std::vector<Vec2> starts;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 end = loop[(i + loop.size() - 1) % loop.size()].curve.poles.back(), begin = loop[i].curve.poles.front();
    starts.push_back(end == begin ? begin : 0.5 * (end + begin));
  }
  for (std::size_t i = 0; i < loop.size(); ++i)
    loop[i].curve = curve::with_ends(std::move(loop[i].curve), starts[i], starts[(i + 1) % loop.size()]);
}

}  // namespace

std::vector<LoopCurve> smooth_pieces(const heal::RawEdge& edge) {
  std::vector<LoopCurve> pieces;
  double begin = edge.curve.begin();
  for (const double t : jumps(edge.curve)) {
    pieces.push_back({curve::trimmed(edge.curve, begin, t), edge.cad_edge, edge.name});
    begin = t;
  }
  pieces.push_back({curve::trimmed(edge.curve, begin, edge.curve.end()), edge.cad_edge, edge.name});
  return pieces;
}

Loop wire_loop(const heal::RawFace& raw, const std::vector<heal::RawEdge>& wire, double tol, Report& report) {
  std::vector<const heal::RawEdge*> edges;
  for (const heal::RawEdge& edge : wire) {
    require_vertices_on_ends(raw, edge, tol);
    if (curve::polygon_length(edge.curve) > tol)
      edges.push_back(&edge);
    else
      report.warn(warning::short_edge_ignored,
                  fmt::format("{}: ignored edge {} at {}: shorter than the tolerance {:.3g}", raw.file, edge.cad_edge,
                              rounded_position_text(edge.start), tol));
  }
  if (edges.empty())
    throw FormatError(fmt::format("{}: the face has no area: its wire at {} is a point", raw.file,
                                  rounded_position_text(wire.front().start)));
  Loop loop;
  for (const heal::RawEdge* edge : heal::chain_edges(edges, tol, 0, raw.file))
    for (LoopCurve& piece : smooth_pieces(*edge)) loop.push_back(std::move(piece));
  close_gaps(loop);
  return loop;
}

Loop reversed(const Loop& loop) {
  Loop back;
  for (size_t i = 0; i < loop.size(); ++i) {
    const LoopCurve& c = loop[(loop.size() - i) % loop.size()];
    back.push_back({curve::reversed(c.curve), c.cad_edge, c.name});
  }
  return back;
}

std::vector<Nurbs> curves_of(const Loop& loop) {
  std::vector<Nurbs> curves;
  for (const LoopCurve& c : loop) curves.push_back(c.curve);
  return curves;
}

double simplify_loops(std::vector<heal::Loop>& loops, double tolerance, double diameter, std::vector<Repair>& repairs,
                      Report& report) {
  if (!(tolerance > 0)) return 0;
  int num_curves = 0, knots_before = 0, knots_after = 0;
  double greatest = 0;
  for (heal::Loop& loop : loops)
    for (heal::LoopCurve& c : loop) {
      auto simplified = curve::simplified_spline(c.curve, tolerance * diameter);
      if (!simplified) continue;
      c.curve = std::move(simplified->curve);
      repairs.push_back({RepairKind::fit, c.cad_edge, c.curve.poles.front(), simplified->distance});
      heal::report_repair(repairs.back(), repairs.size() - 1, report);
      ++num_curves;
      knots_before += simplified->knots_before, knots_after += simplified->knots_after;
      greatest = std::max(greatest, simplified->distance);
    }
  report.set("fit.tolerance", tolerance);
  report.set("fit.curves", num_curves);
  if (num_curves == 0) return 0;
  report.set("fit.knots_before", knots_before);
  report.set("fit.knots_after", knots_after);
  report.set("fit.greatest", greatest / diameter);
  report.set("heal.repairs", repairs.size());
  return greatest;
}

namespace {

using heal::Loop;
using heal::LoopCurve;

// (0, 0), unless the face is so far from it that coordinates lose significant digits; then the centre of the face,
// rounded to a few digits.
Vec2 chosen_origin(const curve::PoleBox& box, double diameter) {
  const Vec2 centre = box.centre();
  if (norm(centre) <= 10 * diameter) return {0, 0};
  const double unit = std::pow(10, std::floor(std::log10(diameter)));
  return {unit * std::round(centre.x / unit), unit * std::round(centre.y / unit)};
}

std::vector<std::string> names_of(const std::vector<Loop>& loops) {
  std::vector<std::string> names;
  for (const Loop& loop : loops)
    for (const LoopCurve& c : loop) names.push_back(c.name);
  return names;
}

}  // namespace

Joint joint_between(const Nurbs& in, const Nurbs& out, double corner_angle) {
  const Vec2 a = curve::tangent(in, in.end(), true), b = curve::tangent(out, out.begin());
  Joint joint{out.poles.front(), wrap_pi(angle_of(a)), wrap_pi(angle_of(b)), heal::interior_angle(in, out), false};
  // The factor ensures that angles equal to the limit up to rounding are treated alike at all corners of a symmetric
  // face.
  joint.is_corner = std::abs(pi - joint.interior_angle) > corner_angle * (1 + 1e-6);
  return joint;
}

CadFace face_of_loops(const heal::RawFace& raw, const std::vector<Loop>& loops, const std::vector<Nurbs>& outline,
                      double corner_angle) {
  CadFace face;
  face.length_unit = raw.length_unit;
  face.metres_per_unit = raw.metres_per_unit;
  face.plane_origin = raw.plane_origin;
  face.plane_x = raw.plane_x;
  face.plane_y = raw.plane_y;
  face.diameter = diameter(outline);
  face.origin = chosen_origin(curve::pole_box(outline), face.diameter);
  face.loop_offsets = {0};
  for (const Loop& loop : loops) {
    for (const LoopCurve& c : loop) {
      face.curves.push_back(c.curve);
      face.curve_cad_edges.push_back(c.cad_edge);
      for (Vec2& pole : face.curves.back().poles) pole -= face.origin;
    }
    face.loop_offsets.push_back(face.num_curves());
  }
  face.curve_names = names_of(loops);
  face.unnamed_curves = replace_empty_names(face.curve_names, "curve");
  for (int i = 0; i < face.num_curves(); ++i)
    face.joints.push_back(joint_between(face.curves[face.previous_in_loop(i)], face.curves[i], corner_angle));
  return face;
}

namespace {

constexpr double same_area = 1e-6;

// A point of the loop at which no other loop touches it.
Vec2 inner_point(const Loop& loop) {
  const Nurbs& curve = loop.front().curve;
  return curve::point(curve, (curve.begin() + curve.end()) / 2);
}

// The number of the smallest piece whose outline contains x; the pieces are in order of falling size. 0 if none does.
size_t smallest_around(const std::vector<std::vector<Loop>>& pieces, Vec2 x) {
  for (size_t p = pieces.size(); p-- > 1;)
    if (winding_number(curves_of(pieces[p].front()), x) != 0) return p;
  return 0;
}

}  // namespace

std::vector<std::vector<Loop>> face_pieces(const std::vector<Loop>& loops) {
  std::vector<std::pair<double, size_t>> outlines;
  std::vector<size_t> holes;
  for (size_t l = 0; l < loops.size(); ++l) {
    const double area = signed_area(curves_of(loops[l]));
    if (area > 0)
      outlines.emplace_back(area, l);
    else
      holes.push_back(l);
  }
  if (outlines.empty()) return {loops};  // crossing curves without area, refused later
  // Rounded logarithms instead of comparisons within a tolerance, which are no order.
  const auto rank = [](double area) { return std::llround(std::log(area) / same_area); };
  std::stable_sort(outlines.begin(), outlines.end(),
                   [&](const auto& a, const auto& b) { return rank(a.first) > rank(b.first); });
  std::vector<std::vector<Loop>> pieces;
  for (const auto& [area, l] : outlines) pieces.push_back({loops[l]});
  for (const size_t l : holes) pieces[smallest_around(pieces, inner_point(loops[l]))].push_back(loops[l]);
  return pieces;
}

namespace {

struct PolylineLimits {
  double longest_curve = 0.02;  ///< diameters
  int fewest_curves = 8;
};
constexpr PolylineLimits limits;

bool is_short_and_straight(const CadFace& face, int curve) {
  const Nurbs& c = face.curves[curve];
  return c.poles.size() == 2 &&
         distance(c.poles[0], c.poles[1]) < limits.longest_curve * face.diameter * (1 - tolerance::tied);
}

/// By curve: whether it belongs to a polyline.
std::vector<bool> curves_of_polylines(const CadFace& face) {
  std::vector<bool> is_part(face.num_curves(), false);
  for (int c = 0; c < face.num_curves(); ++c) {
    if (is_part[c] || !is_short_and_straight(face, c)) continue;
    std::vector<int> chain{c};
    const auto extend = [&](auto&& next) {
      for (int i = next(c); i != c && is_short_and_straight(face, i); i = next(i)) chain.push_back(i);
    };
    extend([&](int i) { return face.next_in_loop(i); });
    const bool is_whole_loop = face.next_in_loop(chain.back()) == c;
    if (!is_whole_loop) extend([&](int i) { return face.previous_in_loop(i); });
    if (std::ssize(chain) >= limits.fewest_curves)
      for (const int i : chain) is_part[i] = true;
  }
  return is_part;
}

}  // namespace

int smooth_polylines(CadFace& face, double kink, int many) {
  if (face.num_regions() > 1) return 0;
  const std::vector<bool> is_part = curves_of_polylines(face);
  std::vector<int> kinks;
  for (int j = 0; j < face.num_curves(); ++j) {
    const Joint& joint = face.joints[j];
    if (joint.is_corner && is_part[j] && is_part[face.previous_in_loop(j)] &&
        std::abs(joint.interior_angle - pi) <= kink * (1 + tolerance::tied))
      kinks.push_back(j);
  }
  if (std::ssize(kinks) < many) return 0;
  for (const int j : kinks) face.joints[j].is_corner = false;
  return static_cast<int>(kinks.size());
}

}  // namespace quadrille::outline
