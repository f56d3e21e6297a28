#include "refine/relax_sizes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/point_grid.hpp"
#include "mesh/boundary_distance.hpp"
#include "refine/validity.hpp"

namespace quadrille::refine {
namespace {

QuadMesh mesh_of(const SeparatrixGraph& graph, double size, int order) {
  return refined(
      graph,
      {.size = size, .order = order, .geometry_tol = 1e-3, .inner_edges = InnerEdges::curved, .relax = Relax::none});
}

/// The unit square in equal squares, with its lines moved.
QuadMesh uneven_square(int order) {
  QuadMesh mesh = mesh_of(hand_made::unit_square(), 0.25, order);
  for (Vec2& x : mesh.nodes) x += {0.1 * std::sin(pi * x.x), -0.08 * std::sin(pi * x.y)};
  measure_elements(mesh);
  return mesh;
}

std::vector<Vec2> corners(const QuadMesh& mesh) {
  std::vector<Vec2> corners;
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    for (int c = 0; c < 4; ++c) corners.push_back(mesh.nodes[side_start(mesh, elem, c)]);
  return corners;
}

TEST(RelaxSizes, UnevenLinesBecomeEven) {
  const sizing::SizeField sizes(0.25);
  const SizeRelaxed relaxed = relax_to_sizes(uneven_square(3), {.sizes = sizes, .tolerance = 1e-3});
  for (const Vec2 x : corners(relaxed.mesh)) {
    EXPECT_NEAR(std::remainder(x.x, 0.25), 0, 2e-3);
    EXPECT_NEAR(std::remainder(x.y, 0.25), 0, 2e-3);
  }
  EXPECT_NEAR(relaxed.energy_after, 2, 1e-3);
  EXPECT_GT(relaxed.energy_before, 2.2);
  EXPECT_NEAR(relaxed.largest_move, 0.1, 0.03);
  EXPECT_TRUE(relaxed.mesh.is_valid);
}

TEST(RelaxSizes, VerticesNearlyInPlaceAreRelaxedFurther) {
  const sizing::SizeField sizes(0.25);
  const QuadMesh mesh = uneven_square(3);
  const SizeRelaxed fine = relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 1e-3});
  SizeRelaxed relaxed = relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 1e-3, .least_progress = coarse_progress});
  EXPECT_LT(relaxed.sweeps, fine.sweeps);
  EXPECT_EQ(relaxed.relaxation->before().nodes, mesh.nodes);
  ASSERT_TRUE(relaxed.relaxation->run(fine_progress, relaxed));
  EXPECT_EQ(relaxed.sweeps, fine.sweeps);
  EXPECT_EQ(relaxed.mesh.nodes, fine.mesh.nodes);
}

TEST(RelaxSizes, VerticesMayBeginInPlace) {
  const sizing::SizeField sizes(0.25);
  const QuadMesh mesh = uneven_square(3), even = mesh_of(hand_made::unit_square(), 0.25, 3);
  const RelaxProblem problem(even, {});
  const PlacedVertices start(problem, VertexMoves(problem.num_vertices()));
  const SizeRelaxed relaxed = relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 1e-3, .start = &start});
  EXPECT_LT(relaxed.sweeps, relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 1e-3}).sweeps);
  EXPECT_NEAR(relaxed.energy_after, 2, 1e-6);
}

TEST(RelaxSizes, VeryThinElementsBecomeEvenInAFewSteps) {
  QuadMesh mesh = mesh_of(hand_made::unit_square(), 1.0 / 24, 1);
  for (Vec2& x : mesh.nodes) x = {std::pow(x.x, 5), std::pow(x.y, 3)};  // the thinnest are 1 : 1e6
  measure_elements(mesh);
  const sizing::SizeField sizes(0.1);
  const SizeRelaxed relaxed = relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 1e-3});
  EXPECT_GT(relaxed.energy_before, 1e5);
  EXPECT_NEAR(relaxed.energy_after, 2, 1e-3);
  EXPECT_LT(relaxed.sweeps, 120);
}

TEST(RelaxSizes, WorkIsBounded) {
  QuadMesh mesh = mesh_of(hand_made::unit_square(), 1.0 / 24, 1);
  for (Vec2& x : mesh.nodes) x = {std::pow(x.x, 5), std::pow(x.y, 3)};
  measure_elements(mesh);
  const sizing::SizeField sizes(0.1);
  const double num_elems = mesh.num_elems();
  const auto sweeps = [&](double steps) {
    return relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 1e-3, .most_work = steps * num_elems}).sweeps;
  };
  EXPECT_GT(sweeps(1e4), 60);
  EXPECT_LE(sweeps(40), 40);
  EXPECT_GT(sweeps(40), 5);
  EXPECT_EQ(sweeps(0), 0);
}

TEST(RelaxSizes, EqualSquaresStayBitForBit) {
  const sizing::SizeField sizes(0.3);
  const QuadMesh mesh = mesh_of(hand_made::unit_square(), 0.25, 3);
  const SizeRelaxed relaxed = relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 1e-3});
  EXPECT_EQ(relaxed.sweeps, 0);
  EXPECT_EQ(corners(relaxed.mesh), corners(mesh));
}

/// The unit square, its first column half as wide as the others, with skew elements.
QuadMesh skew_square(int order) {
  QuadMesh mesh = mesh_of(hand_made::unit_square(), 0.25, order);
  for (Vec2& x : mesh.nodes) {
    x += 0.2 * x.x * (1 - x.x) * x.y * (1 - x.y) * Vec2{4 * x.y, 3 + x.x};
    x.x = x.x * (1 + x.x) / 2;
  }
  measure_elements(mesh);
  return mesh;
}

TEST(RelaxShapes, SkewElementsBecomeRectanglesAsLongAsTheyAre) {
  const sizing::SizeField sizes(0.25);
  for (const int order : {1, 2, 5}) {
    const QuadMesh mesh = skew_square(order);
    const double before = least_scaled_jacobian(mesh);
    ASSERT_LT(before, 0.98);
    const SizeRelaxed relaxed = relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 1e-3, .keeps_lengths = true});
    EXPECT_GT(least_scaled_jacobian(relaxed.mesh), (1 + before) / 2) << order << ": half of what is missing at least";
    const auto width = [&](int elem) {
      return distance(relaxed.mesh.nodes[side_start(mesh, elem, 0)], relaxed.mesh.nodes[side_start(mesh, elem, 1)]);
    };
    EXPECT_LT(width(0), 0.7 * width(3));
  }
}

TEST(RelaxShapes, NoElementBecomesWorseThanTheWorst) {
  const sizing::SizeField sizes(0.4);
  for (const int order : {1, 2, 4, 7})
    for (const SeparatrixGraph& graph : {hand_made::elbow(), hand_made::s_bend(), hand_made::cut_annulus(3)})
      for (const int sweeps : {1, 5, 40}) {
        QuadMesh mesh = mesh_of(graph, 0.4, order);
        shape_inner_edges(mesh, InnerEdges::straight);
        const SizeRelaxed relaxed =
            relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 1e-2, .sweeps = sweeps, .keeps_lengths = true});
        EXPECT_GE(least_scaled_jacobian(relaxed.mesh), least_scaled_jacobian(mesh) - 1e-6);
        EXPECT_TRUE(relaxed.mesh.is_valid);
      }
}

TEST(RelaxSizes, SizesOfAFieldAreObeyed) {
  // Half as long at the left side as at the right one.
  const sizing::SizeField sizes(0.3, {{{{0, 0.5}, 0.15, 0}}, {}, 0}, {}, 1.2);
  const QuadMesh mesh = mesh_of(hand_made::unit_square(), 0.2, 2);
  const SizeRelaxed relaxed = relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 1e-3});
  double shortest = 1, longest = 0;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const double length =
        distance(relaxed.mesh.nodes[side_start(mesh, elem, 0)], relaxed.mesh.nodes[side_start(mesh, elem, 1)]);
    shortest = std::min(shortest, length), longest = std::max(longest, length);
  }
  EXPECT_GT(longest / shortest, 1.3);
}

TEST(RelaxSizes, FrozenElementsKeepTheirVertices) {
  const sizing::SizeField sizes(0.25);
  const QuadMesh mesh = uneven_square(2);
  std::vector<bool> frozen(mesh.num_elems(), false);
  frozen[5] = true;
  const SizeRelaxed relaxed =
      relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 1e-3, .frozen_elems = frozen, .kept_elems = frozen});
  EXPECT_EQ(element_nodes(relaxed.mesh, 5), element_nodes(mesh, 5));
  EXPECT_GT(relaxed.sweeps, 0);
}

TEST(RelaxSizes, TheBoundaryMeetsItsTolerance) {
  // Equal lengths would make the edges of the outer circle as long as those of the inner one.
  const QuadMesh mesh = mesh_of(hand_made::cut_annulus(3), 0.2, 2);
  const double tolerance = mesh::boundary_distance(mesh).worst().distance * 1.01;
  const sizing::SizeField sizes(0.2);
  const SizeRelaxed relaxed = relax_to_sizes(mesh, {.sizes = sizes, .tolerance = tolerance});
  EXPECT_LE(mesh::boundary_distance(relaxed.mesh).worst().distance, tolerance * (1 + 1e-6));
}

/// The number of the vertex at a joint of the face, -1 if none is there.
int vertex_at_joint(const QuadMesh& mesh, int joint) {
  const std::vector<Vec2> x = corners(mesh);
  const auto is_there = [&](Vec2 a) { return distance(a, mesh.face.joints[joint].position) < 1e-9; };
  const auto at = std::ranges::find_if(x, is_there);
  return at == x.end() ? -1 : static_cast<int>(at - x.begin());
}

TEST(RelaxSizes, ACurveEndsAtAVertexAndNotAlwaysAtTheOneBefore) {
  // Shorter elements at the start of the bend pull vertices off its two smooth joints.
  const QuadMesh mesh = mesh_of(hand_made::elbow(), 0.25, 3);
  const sizing::SizeField sizes(0.4, {{{{0, 0.5}, 0.1, 0}}, {}, 0}, {}, 1.2);
  const SizeRelaxed relaxed = relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 1e-3});
  for (const int joint : {1, 4}) {
    ASSERT_FALSE(mesh.face.joints[joint].is_corner);
    EXPECT_GE(vertex_at_joint(relaxed.mesh, joint), 0);
    EXPECT_NE(vertex_at_joint(relaxed.mesh, joint), vertex_at_joint(mesh, joint));
  }
  for (const QuadBoundaryEdge& edge : relaxed.mesh.boundary_edges) {
    for (int k = 0; k <= 3; ++k) {
      const double x = relaxed.mesh.nodes[side_node(relaxed.mesh, edge.elem, edge.side, k)].x;
      EXPECT_TRUE((edge.curve != 0 && edge.curve != 4) || x < 1 + 1e-9) << "beyond the end of a straight curve";
      EXPECT_TRUE((edge.curve != 1 && edge.curve != 3) || x > 1 - 1e-9) << "beyond the end of an arc";
    }
  }
}

/// hand_made::elbow with a straight part of this length.
SeparatrixGraph elbow_behind(double length) {
  SeparatrixGraph graph = hand_made::elbow();
  const Vec2 shift{length - 1, 0}, centre = Vec2{1, 2} + shift;
  CadFace bent = hand_made::face(
      {{curve::segment({0, 0}, {length, 0}), curve::circular_arc(centre, 2, -half_pi, 0),
        curve::segment(centre + Vec2{2, 0}, centre + Vec2{1, 0}), curve::circular_arc(centre, 1, 0, -half_pi),
        curve::segment({length, 1}, {0, 1}), curve::segment({0, 1}, {0, 0})}},
      std::sqrt(13.0));
  bent.curve_names = graph.face.curve_names;
  bent.unnamed_curves = graph.face.unnamed_curves;
  return hand_made::one_block(std::move(bent), {{0, 1}, {2}, {3, 4}, {5}});
}

TEST(RelaxSizes, VerticesAreNotPutAtJointsWhereTheyWouldBeCrowded) {
  // Before the second joint elements would be a hundredth as long as the others, which takes too much energy.
  const sizing::SizeField sizes(0.25);
  for (const double length : {1.0, 0.0025}) {
    const QuadMesh mesh = mesh_of(elbow_behind(length), 0.25, 3);
    const SizeRelaxed relaxed = relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 1e-3});
    EXPECT_GT(relaxed.sweeps, 0);
    EXPECT_EQ(relaxed.relaxation->passes_joints(), length == 1.0) << length;
    EXPECT_EQ(vertex_at_joint(relaxed.mesh, 1) >= 0, length == 1.0 || vertex_at_joint(mesh, 1) >= 0) << length;
  }
}

TEST(RelaxSizes, EdgesThatKeepTheirEndsHaveTheirSizesAgain) {
  // No edge on the circles keeps this tolerance.
  const sizing::SizeField sizes(0.25);
  for (const double centre : {0.2, 0.4}) {
    const QuadMesh mesh = mesh_of(hand_made::cut_annulus(2, 0.5, {centre, 0}), 0.25, 2);
    const SizeRelaxed relaxed = relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 5e-6});
    EXPECT_GT(relaxed.sweeps, 0);
    EXPECT_LT(relaxed.energy_after, relaxed.energy_before);
  }
}

TEST(RelaxSizes, MirrorImagesStayMirrorImages) {
  QuadMesh mesh = mesh_of(hand_made::quarter_annulus(), 0.25, 3);
  const sizing::SizeField sizes(0.25);
  const SizeRelaxed relaxed = relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 1e-3});
  EXPECT_GT(relaxed.sweeps, 0);
  const std::vector<Vec2> all = corners(relaxed.mesh);
  for (const Vec2 x : all) {
    double gap = 1;
    for (const Vec2 y : all) gap = std::min(gap, distance(x, {y.y, y.x}));
    EXPECT_LT(gap, 1e-6);
  }
}

TEST(RelaxSizes, AMeshThatFoldsIsNotMoved) {
  QuadMesh mesh = mesh_of(hand_made::unit_square(), 0.5, 2);
  mesh.nodes[side_start(mesh, 0, 2)] = {1.2, 1.2};  // the vertex in the middle
  measure_elements(mesh);
  const sizing::SizeField sizes(0.5);
  EXPECT_EQ(relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 1e-3}).sweeps, 0);
}

TEST(RelaxSizes, AMeshThatStraightEdgesMakeValidIsMoved) {
  QuadMesh mesh = uneven_square(3);
  mesh.nodes[side_node(mesh, 5, 1, 1)].x += 0.6;
  measure_elements(mesh);
  EXPECT_FALSE(mesh.is_valid);
  const sizing::SizeField sizes(0.25);
  const SizeRelaxed relaxed = relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 1e-3});
  EXPECT_GT(relaxed.sweeps, 0);
  EXPECT_TRUE(relaxed.mesh.is_valid);
}

TEST(ParseRelax, NamesAreGoalsAndANumberIsAnsweredWithItsNewForm) {
  EXPECT_EQ(parse_relax("shape"), Relax::shape);
  EXPECT_EQ(parse_relax("none"), Relax::none);
  try {
    parse_relax("20");
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(), "--relax 20 is now --relax shape --relax-sweeps 20");
  }
  EXPECT_THROW(parse_relax("sizes"), UsageError);
}

sizing::SizeField sizes_of(std::vector<MetricSample> metric) {
  SizeSources sources;
  sources.metric = std::move(metric);
  return {1, sources, {}, 1.2};
}

/// Fine across the lower diagonal, on a grid of points that is symmetric to x = 1/2; mirrored by `side` = -1.
std::vector<MetricSample> oblique_layer(double side) {
  std::vector<MetricSample> samples;
  for (int i = -10; i <= 10; ++i)
    for (int j = 0; j <= 20; ++j) {
      const Vec2 x{0.05 * i, 0.05 * j};
      const double away = std::abs(side * x.x + 0.3 - x.y) / std::sqrt(2);
      samples.push_back({{x.x + 0.5, x.y}, 0.25, 0.05 + 0.2 * away, side * pi / 4});
    }
  return samples;
}

TEST(RelaxSizes, MirroredMetricsGiveMirroredMeshes) {
  const QuadMesh mesh = mesh_of(hand_made::unit_square(), 0.125, 2);
  const sizing::SizeField sizes = sizes_of(oblique_layer(1)), mirrored = sizes_of(oblique_layer(-1));
  const QuadMesh a = relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 1e-3}).mesh,
                 b = relax_to_sizes(mesh, {.sizes = mirrored, .tolerance = 1e-3}).mesh;
  const PointGrid places(b.nodes);
  for (const Vec2 x : a.nodes)
    EXPECT_LT(std::sqrt(places.nearest({1 - x.x, x.y}, [](int) { return true; }).distance2), 1e-6);
  EXPECT_LT(std::ranges::max(a.elem_edge_ratio.empty() ? a.elem_scaled_jacobian : a.elem_edge_ratio), 20);
}

TEST(RelaxSizes, AMeshSymmetricToItsMetricStaysSo) {
  std::vector<MetricSample> both = oblique_layer(1);
  for (const MetricSample& sample : oblique_layer(-1)) both.push_back(sample);
  const QuadMesh mesh = mesh_of(hand_made::unit_square(), 0.125, 2);
  const sizing::SizeField sizes = sizes_of(both);
  const QuadMesh relaxed = relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 1e-3}).mesh;
  const PointGrid places(relaxed.nodes);
  for (const Vec2 x : relaxed.nodes)
    EXPECT_LT(std::sqrt(places.nearest({1 - x.x, x.y}, [](int) { return true; }).distance2), 1e-9);
}

TEST(RelaxSizes, SidesTurnToPrescribedDirections) {
  const sizing::SizeField sizes(0.125);
  const QuadMesh mesh = mesh_of(hand_made::unit_square(), 0.125, 2);
  const auto middle_angle = [](const QuadMesh& of) {
    for (int elem = 0; elem < of.num_elems(); ++elem) {
      const Vec2 a = of.nodes[side_start(of, elem, 0)], b = of.nodes[side_start(of, elem, 1)],
                 c = of.nodes[side_start(of, elem, 2)];
      if (distance((a + c) / 2, {0.4375, 0.4375}) < 0.06) return degrees(angle_of(b - a));
    }
    return 0.0;
  };
  const PrescribedDirections directions = [](Vec2 x) {
    return 20 * std::exp(-norm2(x - Vec2{0.5, 0.5}) / 0.04) * unit(4 * radians(20));
  };
  const QuadMesh relaxed = relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 1e-3, .directions = directions}).mesh;
  EXPECT_NEAR(std::remainder(middle_angle(mesh), 90), 0, 1e-6);
  EXPECT_NEAR(std::remainder(middle_angle(relaxed), 90), 20, 5);
}

}  // namespace
}  // namespace quadrille::refine
