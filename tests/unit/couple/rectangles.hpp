#pragma once
// Layouts of unit squares side by side, by hand: each has lines across it, from its left to its right side.

#include <memory>
#include <utility>
#include <vector>

#include "../hand_made.hpp"
#include "../regions/faces_of_regions.hpp"
#include "../support/square_field.hpp"
#include "couple/region_layouts.hpp"
#include "regions/split.hpp"

namespace quadrille::couple {

/// A line from one height on the left side of a square to one on its right side.
struct Across {
  double left = 0, right = 0;
  LineKind kind = LineKind::traced;
};

/// Curves of a square: bottom, right, top, left. `lines`: from the lowest on.
inline SeparatrixGraph square_with_lines(const CadFace& face, const std::vector<Across>& lines) {
  SeparatrixGraph g;
  g.face = face;
  for (int j = 0; j < 4; ++j) hand_made::add_joint_node(g, j);
  std::vector<int> lefts, rights;
  for (const Across& line : lines) {
    const NodeKind kind = line.kind == LineKind::cut ? NodeKind::cut : NodeKind::boundary;
    lefts.push_back(hand_made::add_boundary_node(g, 3, 1 - line.left));
    rights.push_back(hand_made::add_boundary_node(g, 1, line.right));
    g.nodes[lefts.back()].kind = g.nodes[rights.back()].kind = kind;
  }
  const auto add_side = [&](int curve, const std::vector<int>& inner) {
    int from = curve;
    double t = 0;
    for (const int node : inner) {
      hand_made::add_arc(g, from, node, true, {{curve, t, g.nodes[node].t}});
      from = node, t = g.nodes[node].t;
    }
    hand_made::add_arc(g, from, (curve + 1) % 4, true, {{curve, t, 1}});
  };
  add_side(0, {});
  add_side(1, rights);
  add_side(2, {});
  add_side(3, {lefts.rbegin(), lefts.rend()});
  for (std::size_t i = 0; i < lines.size(); ++i)
    g.lines.push_back({lefts[i], rights[i], lines[i].kind, {hand_made::add_cut(g, lefts[i], rights[i])}});
  return g;
}

/// Squares [i, i + 1] x [0, 1] with these lines, in a field of crosses along the axes.
struct Rectangles {
  explicit Rectangles(const std::vector<std::vector<Across>>& lines) {
    std::vector<CadFace> squares;
    for (int i = 0; i < static_cast<int>(lines.size()); ++i)
      squares.push_back(testing_faces::rectangle({1.0 * i, 0}, {1.0 * i + 1, 1}));
    layouts.face = lines.size() > 1 ? testing_faces::face_of_regions(squares) : squares.front();
    const std::vector<CadFace> faces = regions::split(layouts.face);
    for (int r = 0; r < static_cast<int>(lines.size()); ++r) {
      fields.push_back(std::make_unique<Field>(interpolated_field(square_mesh({1.0 * r, 0}, 1, 3), 1, [](Vec2) {
        return Vec2{1, 0};
      })));
      evaluators.push_back(std::make_unique<field::FieldEvaluator>(*fields.back()));
      layouts.layouts.push_back(graph::candidate_layout(square_with_lines(faces[r], lines[r])));
      layouts.fields.push_back(evaluators.back().get());
      layouts.first_curves.push_back(regions::curves_of(layouts.face, r).begin);
    }
  }

  const ArcGraph& graph(int region) const { return layouts.layouts[region].graph(); }
  /// Whether a node of a region's graph is at a position.
  bool has_node(int region, Vec2 x) const {
    for (const GraphNode& node : graph(region).nodes)
      if (distance(node.position, x) < 1e-9) return true;
    return false;
  }

  std::vector<std::unique_ptr<Field>> fields;
  std::vector<std::unique_ptr<field::FieldEvaluator>> evaluators;
  RegionLayouts layouts;
};

/// One square whose left side is mapped onto its right side.
struct PeriodicSquare : Rectangles {
  explicit PeriodicSquare(const std::vector<Across>& lines) : Rectangles({lines}) {
    layouts.face.periodic_pairs = {{{3, 1}, 0, {1, 0}}};
    SeparatrixGraph graph = graph::separatrix_graph(std::move(layouts.layouts.front()));
    graph.face = layouts.face;
    layouts.layouts.front() = graph::candidate_layout(std::move(graph));
  }
};

}  // namespace quadrille::couple
