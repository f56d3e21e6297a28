#include "outline/wire_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/error.hpp"
#include "base/position_text.hpp"
#include "base/warning_codes.hpp"
#include "curve/nurbs.hpp"
#include "heal/chain_edges.hpp"

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

}  // namespace quadrille::outline
