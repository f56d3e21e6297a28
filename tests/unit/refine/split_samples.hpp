#pragma once
// Attempts at meshes of small layouts, for tests of what changes them.

#include "../hand_made.hpp"
#include "block/extract_blocks.hpp"
#include "refine/align_chords.hpp"
#include "refine/split_mesh.hpp"

namespace quadrille::refine {

/// A request, and what it refers to. The boundary's tolerance is that of the options, 0.01 if they have none.
struct SplitSample {
  BlockLayout layout;
  RefineOptions options;
  Report report = {};
  sizing::MeasuredLayout equal = sizing::MeasuredLayout(layout);
  sizing::MeasuredLayout aligned = equal.with_parameters(align_chords(equal));
  SplitRequest request = {options,
                          equal,
                          aligned,
                          sizing::SizeField(options.size),
                          {options.geometry_tol > 0 ? options.geometry_tol : 0.01, options.target_edge_ratio,
                           options.walls.empty() ? 0 : options.target_growth},
                          report};

  SplitSample(const SeparatrixGraph& graph, RefineOptions prescribed)
      : layout(block::extract_blocks(graph)), options(std::move(prescribed)) {}
  SplitSample(const SplitSample&) = delete;
  SplitSample& operator=(const SplitSample&) = delete;
};

/// The unit square, cut by a straight line from (0, left) to (1, right).
inline SeparatrixGraph divided_square(double left, double right) {
  SeparatrixGraph g;
  g.face = hand_made::unit_square().face;
  for (int i = 0; i < 4; ++i) hand_made::add_joint_node(g, i);
  const int a = hand_made::add_boundary_node(g, 3, 1 - left), b = hand_made::add_boundary_node(g, 1, right);
  hand_made::add_arc(g, 0, 1, true, {hand_made::whole(g, 0)});
  hand_made::add_arc(g, 1, b, true, {{1, 0, right}});
  hand_made::add_arc(g, b, 2, true, {{1, right, 1}});
  hand_made::add_arc(g, 2, 3, true, {hand_made::whole(g, 2)});
  hand_made::add_arc(g, 3, a, true, {{3, 0, 1 - left}});
  hand_made::add_arc(g, a, 0, true, {{3, 1 - left, 1}});
  hand_made::add_cut(g, a, b);
  return g;
}

/// A chevron whose lower side bulges through the upper one: its map is not valid.
inline SeparatrixGraph folded_block() {
  const std::vector<Nurbs> loop{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {0.1, 0.1}),
                                curve::segment({0.1, 0.1}, {0, 1}), curve::segment({0, 1}, {0, 0})};
  return hand_made::one_block(hand_made::face({loop}, std::sqrt(2.0)), {{0}, {1}, {2}, {3}});
}

/// Layers along the lower side of the unit square.
inline SeparatrixGraph square_with_wall(RefineOptions& options) {
  layers::WallSpec wall;
  wall.names = {"bottom"};
  wall.first = 1e-3;
  wall.layers = 3;
  options.walls = {wall};
  SeparatrixGraph square = hand_made::unit_square();
  square.face.curve_names[0] = "bottom";
  return square;
}

}  // namespace quadrille::refine
