#pragma once
// A snail: the band between the laps of a spiral of pitch 1/2, whose radius after t laps is 1 + t / 2.
//
// The inner wall is the first lap. It ends with a step, at whose reflex corner P (t = 1) a line goes on along the
// spiral, side by side with itself, up to the reflex corner Q (t = 13 / 6) of the step at which the outer wall begins.
// A line from P crosses it outwards after a lap, one from Q inwards: both are rungs of a strip with the two ends of the
// line as rails, 60 degrees long.

#include <cmath>
#include <vector>

#include "../hand_made.hpp"
#include "graph/build_graph.hpp"
#include "graph/candidate_layout.hpp"

namespace quadrille::snail {

inline Vec2 at(double laps) { return (1 + laps / 2) * unit(2 * pi * laps); }
inline Vec2 slope(double laps) {
  return unit(2 * pi * laps) / 2 + 2 * pi * (1 + laps / 2) * left_of(unit(2 * pi * laps));
}

/// The spiral between two numbers of laps, with them as parameter; negative ones run backwards.
inline Nurbs spiral(double from, double to) {
  const int num = static_cast<int>(std::lround(72 * (to - from)));
  const double sign = from < 0 ? -1 : 1;
  std::vector<double> t;
  std::vector<Vec2> x;
  for (int i = 0; i <= num; ++i) {
    t.push_back(from + (to - from) * i / num);
    x.push_back(at(sign * t.back()));
  }
  return curve::cubic_spline(t, x, sign * slope(sign * from), sign * slope(sign * to));
}

inline constexpr double p_laps = 1, q_laps = 13.0 / 6;

/// Curves: outer wall, its step, inner wall (backwards), its step. Joints: Q, the outer step's end, P, the inner one's.
inline CadFace face() {
  const double end = q_laps + 1;
  return hand_made::face({{spiral(q_laps, end), curve::segment(at(end), at(q_laps))},
                          {spiral(-p_laps, 0), curve::segment(at(0), at(p_laps))}},
                         6);
}

inline graph::FinishedLine straight(graph::LineEnd start, graph::LineEnd end, Vec2 a, Vec2 b, LineKind kind) {
  const double length = distance(a, b);
  const Vec2 along = (b - a) / length;
  return {start, end, curve::cubic_spline({0, length / 2, length}, {a, (a + b) / 2, b}, along, along), kind};
}

/// Five blocks; `with_cut`: eight, divided by a line from wall to wall at 30 degrees, across the strip.
inline graph::CandidateLayout layout(bool with_cut = false) {
  const CadFace f = face();
  std::vector<GraphNode> fixed;
  for (int j = 0; j < 4; ++j)
    fixed.push_back({f.joints[j].position, NodeKind::corner, j % 2 == 0 ? 3 : 1, j, f.curves[j].begin()});
  const int q = 0, p = 2;
  std::vector<graph::FinishedLine> lines{
      {{p, -1, 0}, {q, -1, 0}, spiral(p_laps, q_laps), LineKind::traced},
      straight({p, -1, 0}, {-1, 0, 3}, at(1), at(3), LineKind::traced),
      straight({q, -1, 0}, {-1, 2, -1.0 / 6}, at(q_laps), at(1.0 / 6), LineKind::traced)};
  if (with_cut)
    lines.push_back(straight({-1, 2, -1.0 / 12}, {-1, 0, 37.0 / 12}, at(1.0 / 12), at(37.0 / 12), LineKind::cut));
  std::vector<Nurbs> splines;
  for (const graph::FinishedLine& l : lines) splines.push_back(l.spline);
  return graph::candidate_layout(graph::build_graph(f, fixed, lines, graph::find_crossings(splines, 1e-9), 1e-9));
}

/// The angle between the blend from P to Q and the circles about the centre, at the middle of the strip: half of the
/// pitch is covered there at pi / 2 times the mean slope.
inline double deviation_at_middle() {
  const double turn = 2 * pi / 6, radius = 1 + (p_laps + q_laps) / 4;
  return std::atan((0.5 * half_pi + 1.0 / 12) / turn / radius);
}

}  // namespace quadrille::snail
