#pragma once
// A hall with an arm on either side, whose floors lie at the heights 1 and 1 + `step`: the lines that run along the
// hall from the reflex corners P = (1, 1) and Q = (3, 1 + step) leave a strip of two blocks between them.
//
//     (0,2) ------------------------------- (4,2)
//       |      |                  |           |
//       | .  . | .  .  .  .  .  . Q --------(4,1+step)
//     (0,1) -- P .  .  .  .  .  . |
//              |                  |
//            (1,0) ------------ (3,0)

#include <cmath>
#include <vector>

#include "../hand_made.hpp"
#include "graph/build_graph.hpp"
#include "graph/candidate_layout.hpp"
#include "graph/chord_strip.hpp"

namespace quadrille {

inline graph::CandidateLayout hall(double step) {
  const std::vector<Vec2> corners{{1, 0}, {3, 0}, {3, 1 + step}, {4, 1 + step}, {4, 2}, {0, 2}, {0, 1}, {1, 1}};
  std::vector<Nurbs> loop;
  for (std::size_t i = 0; i < corners.size(); ++i) loop.push_back(curve::segment(corners[i], corners[(i + 1) % 8]));
  const CadFace f = hand_made::face({loop}, std::sqrt(20.0));
  std::vector<GraphNode> fixed;
  for (int j = 0; j < 8; ++j)
    fixed.push_back({corners[j], NodeKind::corner, j == 2 || j == 7 ? 3 : 1, j, f.curves[j].begin()});
  const auto line = [&](int from, int curve, double t) {
    const Vec2 a = corners[from], b = curve::point(f.curves[curve], t), along = normalized(b - a);
    const double length = distance(a, b);
    return graph::FinishedLine{{from, -1, 0},
                               {-1, curve, t},
                               curve::cubic_spline({0, length / 2, length}, {a, (a + b) / 2, b}, along, along),
                               LineKind::traced};
  };
  const std::vector<graph::FinishedLine> lines{line(7, 1, 1), line(7, 4, 3), line(2, 5, 1 - step), line(2, 4, 1)};
  std::vector<Nurbs> splines;
  for (const graph::FinishedLine& l : lines) splines.push_back(l.spline);
  return graph::candidate_layout(graph::build_graph(f, fixed, lines, graph::find_crossings(splines, 1e-9), 1e-9));
}

/// The strip between P's line and Q's, whose blocks have the height of the step.
inline graph::ChordStrip thin_strip_of_hall(const graph::Subdivision& subdivision, double step) {
  for (const graph::ChordStrip& strip : graph::all_strips(subdivision, graph::arc_lengths(subdivision.graph())))
    if (strip.width < 1.5 * step) return strip;
  return {};
}

/// The greatest angle between the blend from P to Q and the hall.
inline double deviation_of_hall(double step) { return std::atan(1.57079632679489661923 * step / 2); }

}  // namespace quadrille
