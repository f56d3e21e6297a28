#include "refine/lifted_split.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../chart_samples.hpp"
#include "check/check.hpp"
#include "mesh/element_sizes.hpp"
#include "refine/refine.hpp"
#include "refine/validity.hpp"
#include "spectral/quad_map.hpp"
#include "surface/space_extent.hpp"

namespace quadrille::refine {
namespace {

/// Two blocks on a patch of the unit sphere.
BlockLayout patch_layout() {
  BlockLayout layout = samples::block_layout();
  layout.face = samples::sphere_face(4, 8);
  for (Nurbs& spline : layout.splines)
    for (Vec2& pole : spline.poles) pole = pole / 2;
  for (GraphNode& node : layout.nodes) node.position = node.position / 2;
  return layout;
}

QuadMesh refined(const RefineOptions& options, Report& report) { return refine(patch_layout(), options, report); }

/// The greatest distance from the unit sphere, at points between the nodes.
double distance_from_sphere(const QuadMesh& mesh) {
  double worst = 0;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const std::vector<Vec3> nodes = element_space_nodes(mesh, elem);
    for (const double a : {-0.9, -0.35, 0.1, 0.77})
      for (const double b : {-0.8, -0.2, 0.4, 0.95})
        worst = std::max(worst, std::abs(norm(spectral::quad_position(mesh.order, nodes.data(), {a, b})) - 1));
  }
  return worst;
}

TEST(LiftedSplit, NodesAreOnTheSurfaceAndElementsProved) {
  RefineOptions options;
  options.size = 0.1;
  Report report;
  const QuadMesh mesh = refined(options, report);
  ASSERT_EQ(mesh.space_nodes.size(), mesh.nodes.size());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    EXPECT_NEAR(norm(mesh.space_nodes[i]), 1, 1e-14);
    EXPECT_NEAR(distance(mesh.space_nodes[i], samples::on_sphere(mesh.nodes[i])), 0, 1e-8);
  }
  for (const check::Violation& v : check::check_stage(mesh, check::CheckDepth::full))
    ADD_FAILURE() << v.rule << ": " << v.text;
  EXPECT_TRUE(mesh.is_valid);
  EXPECT_GT(least_scaled_jacobian(mesh), 0.9);
  EXPECT_LE(distance_from_sphere(mesh), 5e-7 * mesh.face.diameter);
}

TEST(LiftedSplit, AnglesAreThoseOfTheChart) {
  RefineOptions options;
  options.size = 0.1;
  Report report;
  QuadMesh mesh = refined(options, report);
  const std::vector<double> there = mesh.elem_scaled_jacobian;
  mesh.space_nodes.clear();
  measure_elements(mesh);
  for (std::size_t e = 0; e < there.size(); ++e) EXPECT_NEAR(there[e], mesh.elem_scaled_jacobian[e], 5e-4);
}

TEST(LiftedSplit, BoundaryNodesAreOnTheCurvesInSpace) {
  RefineOptions options;
  options.size = 0.2;
  options.levels = 1;
  Report report;
  const QuadMesh mesh = refined(options, report);
  for (const QuadBoundaryEdge& edge : mesh.boundary_edges) {
    if (edge.curve != 0) continue;
    for (const int node : side_nodes(mesh, edge.elem, edge.side)) EXPECT_NEAR(mesh.space_nodes[node].y, 0, 1e-15);
  }
}

TEST(LiftedSplit, SizesAreLengthsInSpace) {
  // Lengths in space are 1.33 to 2 times those of the chart.
  RefineOptions options;
  options.size = 0.05;
  options.size_rule = sizing::SizeRule::nearest;
  Report report;
  const QuadMesh mesh = refined(options, report);
  double sum = 0, least = 1, greatest = 0;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    EXPECT_NEAR(mesh.elem_prescribed_length[elem], 0.05, 1e-5);
    const double size = mesh::relative_sizes(mesh)[elem];
    sum += std::log(size), least = std::min(least, size), greatest = std::max(greatest, size);
  }
  EXPECT_NEAR(std::exp(sum / mesh.num_elems()), 1, 0.08);
  EXPECT_LT(greatest / least, 1.5) << "2.25 with equal sizes in the chart";
}

TEST(LiftedSplit, ElementsAreShorterWhereTheyWouldLeaveTheSurface) {
  RefineOptions options;
  options.size = 0.5;
  options.order = 1;
  options.geometry_tol = 0.1;
  Report coarse_report;
  const QuadMesh coarse = refined(options, coarse_report);
  options.geometry_tol = 2e-3;
  Report report;
  const QuadMesh mesh = refined(options, report);
  EXPECT_GT(mesh.num_elems(), 2 * coarse.num_elems());
  const double diameter = surface::diameter(*mesh.face.chart);
  EXPECT_GT(distance_from_sphere(coarse), 2e-3 * diameter);
  EXPECT_LE(distance_from_sphere(mesh), 2e-3 * diameter);
  EXPECT_TRUE(report.warnings().empty());
}

TEST(LiftedSplit, TheToleranceIsOfTheDiameterInSpace) {
  Report report;
  const QuadMesh mesh = refined({}, report);
  const auto entry = std::ranges::find(report.entries(), "surface.tolerance", [](const auto& e) { return e.first; });
  ASSERT_NE(entry, report.entries().end());
  const double diameter = surface::diameter(*mesh.face.chart);
  EXPECT_GT(diameter, 1.2 * mesh.face.diameter);
  EXPECT_DOUBLE_EQ(std::get<double>(entry->second), 5e-7 * diameter);
}

TEST(LiftedSplit, TheNearestMeshHasTheFewestUnprovedElements) {
  const auto with = [](double bound, double distance) {
    LiftedMesh lifted;
    lifted.mesh.elem_jacobian_bound = {1, bound};
    lifted.distance.elem = {distance, 0};
    lifted.is_at_tip = {false, false};
    return lifted;
  };
  EXPECT_TRUE(is_nearer(with(1, 1e-6), with(1, 2e-6)));
  EXPECT_FALSE(is_nearer(with(1, 2e-6), with(1, 1e-6)));
  EXPECT_TRUE(is_nearer(with(1, 1), with(0, 1e-6)));
  EXPECT_FALSE(is_nearer(with(1, 1e-6), with(1, 1e-6)));
}

TEST(LiftedSplit, ANodeBesideAJointIsTheJoint) {
  Report report;
  QuadMesh mesh = refined({}, report);
  const mesh::ChartMap map(mesh.face);
  const Nurbs& curve = mesh.face.curves.front();
  const auto corner = std::ranges::min_element(
      mesh.nodes, [&](Vec2 a, Vec2 b) { return norm2(a - curve.poles.front()) < norm2(b - curve.poles.front()); });
  *corner += 2e-9 * normalized(curve.poles[1] - curve.poles[0]);
  mesh::lift_nodes(map, mesh);
  const Vec3 there = mesh.face.chart->space_curves.front().poles.front();
  EXPECT_EQ(distance(mesh.space_nodes[corner - mesh.nodes.begin()], there), 0);
  EXPECT_LT(distance(*corner, curve.poles.front()), 1e-15);
}

TEST(LiftedSplit, ElementsAtATipAreNotShorter) {
  RefineOptions options;
  options.order = 1;
  options.geometry_tol = 0.1;
  Report report;
  const QuadMesh mesh = refined(options, report);
  const mesh::ChartMap map(mesh.face);
  const Vec3 tip = mesh.space_nodes[side_start(mesh, 0, 0)];
  const LiftedMesh at_tip = lifted(map, mesh, {.tips = {tip}}, nullptr), smooth = lifted(map, mesh, {}, nullptr);
  EXPECT_EQ(std::ranges::count(smooth.is_at_tip, true), 0);
  EXPECT_TRUE(at_tip.is_at_tip[0]);
  const auto num_at_tip = std::ranges::count(at_tip.is_at_tip, true);
  EXPECT_LT(num_at_tip, mesh.num_elems() / 4);
  const sizing::SizeField sizes(0.1);
  const double tolerance = smooth.distance.elem[0] / 100;
  EXPECT_EQ(finer_sizes(map, smooth, sizes, tolerance, 2).size(), mesh.num_elems());
  EXPECT_EQ(finer_sizes(map, at_tip, sizes, tolerance, 2).size(), mesh.num_elems() - num_at_tip);
  EXPECT_FALSE(at_tip.is_at_tip[at_tip.farthest()]);
}

TEST(LiftedSplit, TheWarningNamesATip) {
  Report report;
  LiftedMesh lifted{refined({}, report), {}, {}};
  lifted.distance.elem.assign(lifted.mesh.num_elems(), 1e-9);
  lifted.distance.elem[0] = 1e-3;
  lifted.is_at_tip.assign(lifted.mesh.num_elems(), false);
  lifted.is_at_tip[0] = true;
  report_surface(lifted, 1e-6, report);
  ASSERT_EQ(report.warnings().size(), 1U);
  EXPECT_NE(report.warnings().back().message.find("elements at a tip of the surface deviate"), std::string::npos);
}

TEST(LiftedSplit, TrialsAreOnlyProved) {
  RefineOptions options;
  options.size = 0.5;
  options.order = 1;
  options.geometry_tol = 0.1;
  Report report;
  const QuadMesh coarse = refined(options, report);
  options.geometry_tol = 2e-3;
  options.keeps_to_surface = false;
  const QuadMesh trial = refined(options, report);
  EXPECT_EQ(trial.num_elems(), coarse.num_elems());
  EXPECT_TRUE(trial.is_valid);
  EXPECT_TRUE(report.warnings().empty());
}

TEST(LiftedSplit, PlanarFacesHaveNoNodesInSpace) {
  Report report;
  EXPECT_TRUE(refine(samples::block_layout(), {}, report).space_nodes.empty());
}

// Edges of 0.4 times the length are 0.4^(N + 1) times as far from a smooth surface, 0.4^2 times where curvatures jump,
// and 0.4 times at a kink.
TEST(LiftedSplit, DistancesFallSlowlyAtAKink) {
  const auto at_distance = [](double distance, double bound, double size = 0.4) {
    LiftedMesh lifted;
    lifted.mesh.order = 1;
    lifted.mesh.space_nodes = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {size, size, 0}};
    lifted.mesh.elem_nodes = {0, 1, 2, 3, 0, 1, 2, 3};
    lifted.mesh.elem_jacobian_bound = {1, bound};
    lifted.distance.elem = {0, distance};
    lifted.is_at_tip = {false, false};
    return lifted;
  };
  const double tolerance = 1e-6;
  for (const int power : {expected_power(0, 4), expected_power(1, 4)}) {
    EXPECT_FALSE(fell_slowly(at_distance(1e-3, 1, 1), at_distance(1e-3 * std::pow(0.4, 5), 1), tolerance, power));
    EXPECT_FALSE(fell_slowly(at_distance(1e-3, 1, 1), at_distance(1.6e-4, 1), tolerance, power));
    EXPECT_TRUE(fell_slowly(at_distance(1e-3, 1, 1), at_distance(4e-4, 1), tolerance, power));
    // Halved, as counts are integers: 0.5^2 times as far.
    EXPECT_FALSE(fell_slowly(at_distance(1e-3, 1, 1), at_distance(2.6e-4, 1, 0.5), tolerance, power));
    EXPECT_TRUE(fell_slowly(at_distance(1e-3, 1, 1), at_distance(2.6e-4, 1), tolerance, power));
    EXPECT_FALSE(fell_slowly(at_distance(2e-6, 1, 1), at_distance(1e-6, 1), tolerance, power));
    // No fewer elements are unproved.
    EXPECT_TRUE(fell_slowly(at_distance(1e-3, 0, 1), at_distance(1e-6, 0), tolerance, power));
    EXPECT_FALSE(fell_slowly(at_distance(1e-3, 0, 1), at_distance(1e-3, 1), tolerance, power));
  }
  EXPECT_FALSE(fell_slowly(at_distance(2e-6, 1, 1), at_distance(1.2e-6, 1), tolerance, 5));  // near the tolerance
}

// On the unit sphere: an element of order 1 longer than its radius, and as short after one more round.
TEST(LiftedSplit, ABendIsApproachedWhileElementsAreLongerThanItsRadius) {
  RefineOptions options;
  options.order = 1;
  options.geometry_tol = 1;
  Report report;
  const auto with = [mesh = refined(options, report)](double diagonal, double distance) {
    LiftedMesh lifted{mesh, {}, std::vector<bool>(mesh.num_elems(), false)};
    lifted.distance.elem.assign(mesh.num_elems(), 0);
    lifted.distance.elem[0] = distance;
    for (int side = 0; side < 4; ++side)
      lifted.mesh.space_nodes[side_start(mesh, 0, side)] = {side % 2 == 0 ? 0 : diagonal, side < 2 ? 0 : diagonal, 0};
    return lifted;
  };
  const LiftedMesh far = with(4, 0.2), next = with(1.5, 0.1);
  const mesh::ChartMap map(next.mesh.face);
  EXPECT_TRUE(is_resolving_bend(map, far, next, 1));
  EXPECT_FALSE(is_resolving_bend(map, far, next, 0)) << "no round is left";
  EXPECT_FALSE(is_resolving_bend(map, with(4, 0.05), next, 1)) << "the distance rose";
  EXPECT_FALSE(is_resolving_bend(map, far, with(0.5, 0.1), 1)) << "the bend is resolved";
}

}  // namespace
}  // namespace quadrille::refine
