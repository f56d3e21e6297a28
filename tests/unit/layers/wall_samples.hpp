#pragma once
// Layouts and planned walls for the tests of lib/quads/layers.

#include <algorithm>
#include <string>
#include <vector>

#include "../hand_made.hpp"
#include "block/extract_blocks.hpp"
#include "layers/wall_layers.hpp"
#include "refine/align_chords.hpp"
#include "refine/divide_arcs.hpp"
#include "sizing/grade_chords.hpp"

namespace quadrille::wall_samples {

using hand_made::row;

/// Radii 0.5 and 1, cut at the angles 0 and pi, where the inner circle's two curves meet: curve 1 below, 2 above.
inline SeparatrixGraph annulus_of_half_circles() {
  SeparatrixGraph g;
  g.face = hand_made::face({{curve::circular_arc({0, 0}, 1, 0, 2 * pi)},
                            {curve::circular_arc({0, 0}, 0.5, 2 * pi, pi), curve::circular_arc({0, 0}, 0.5, pi, 0)}},
                           2);
  const Nurbs& out = g.face.curves[0];
  const double middle = (out.begin() + out.end()) / 2;
  const int right = hand_made::add_boundary_node(g, 0, out.begin());
  const int left = hand_made::add_boundary_node(g, 0, middle);
  const int inner_right = hand_made::add_joint_node(g, 1, 2), inner_left = hand_made::add_joint_node(g, 2, 2);
  for (GraphNode& node : g.nodes) node.kind = NodeKind::cut;
  hand_made::add_arc(g, right, left, true, {{0, out.begin(), middle}});
  hand_made::add_arc(g, left, right, true, {{0, middle, out.end()}});
  hand_made::add_arc(g, inner_left, inner_right, true, {hand_made::whole(g, 2)});
  hand_made::add_arc(g, inner_right, inner_left, true, {hand_made::whole(g, 1)});
  hand_made::add_cut(g, right, inner_right);
  hand_made::add_cut(g, left, inner_left);
  return g;
}

inline std::vector<layers::WallSpec> parse(const std::vector<std::string>& walls) {
  std::vector<layers::WallSpec> specs;
  for (const std::string& wall : walls) specs.push_back(layers::parse_wall_spec(wall));
  return specs;
}

/// The walls of a layout as refine() plans them, up to the division of the arcs.
class PlannedWalls {
 public:
  PlannedWalls(const SeparatrixGraph& graph, double size, const std::vector<std::string>& walls, int order = 4,
               double tolerance = 1e-3)
      : layout(block::extract_blocks(graph, report)),
        specs(parse(walls)),
        sizes(size),
        measured(measure()),
        divisions(refine::divide_arcs(measured, plans(), {order, tolerance})),
        input{measured, specs, sizes, order, tolerance},
        plan(layers::plan_walls(input, divisions)) {
    layers::report_walls(plan, specs, report);
  }
  PlannedWalls(const PlannedWalls&) = delete;
  PlannedWalls& operator=(const PlannedWalls&) = delete;

  int arc_between(Vec2 a, Vec2 b) const {
    for (std::size_t arc = 0; arc < layout.arcs.size(); ++arc) {
      const Vec2 from = layout.nodes[layout.arcs[arc].from].position, to = layout.nodes[layout.arcs[arc].to].position;
      if (std::min(distance(from, a) + distance(to, b), distance(from, b) + distance(to, a)) < 1e-9)
        return static_cast<int>(arc);
    }
    return -1;
  }

  /// Distances from a, along the arc from a to b, at which its intervals end, beginning with the first.
  std::vector<double> steps(Vec2 a, Vec2 b) const {
    const int arc = arc_between(a, b);
    std::vector<double> ends = divisions[arc].ends;
    if (distance(layout.nodes[layout.arcs[arc].from].position, a) > 1e-9) {
      std::reverse(ends.begin(), ends.end());
      for (double& f : ends) f = 1 - f;
    }
    ends.erase(ends.begin());
    for (double& f : ends) f *= measured.length(arc);
    return ends;
  }
  double first_step(Vec2 a, Vec2 b) const { return steps(a, b).front(); }

  /// Names of the sides' specs, by block and side; "-" for none.
  int spec_at(int block, int side) const {
    const int wall = plan.walls.of_block[block][side];
    return wall < 0 ? -1 : plan.walls.sides[wall].spec;
  }
  std::vector<std::string> warnings() const {
    std::vector<std::string> codes;
    for (const auto& warning : report.warnings()) codes.push_back(warning.code);
    return codes;
  }

  Report report;
  BlockLayout layout;
  std::vector<layers::WallSpec> specs;
  sizing::SizeField sizes;
  sizing::MeasuredLayout measured;
  sizing::ArcDivisions divisions;
  layers::WallInput input;
  layers::WallPlan plan;

 private:
  sizing::MeasuredLayout measure() const {
    const sizing::MeasuredLayout equal(layout);
    return equal.with_parameters(refine::align_chords(equal));
  }
  std::vector<sizing::ChordPlan> plans() const {
    return sizing::grade_chords(measured, sizes, sizing::SizeRule::nearest, {});
  }
};

}  // namespace quadrille::wall_samples
