#include <gtest/gtest.h>

#include <algorithm>

#include "sheet_samples.hpp"

namespace quadrille::page {
namespace {

/// A zero of v = (x, -y), whose index is -1: five separatrices.
CriticalPoint saddle() {
  CriticalPoint point;
  point.position = {0.5, 0.5};
  point.index = -1;
  point.valence = 5;
  point.jacobian = {1, 0, 0, -1};
  return point;
}

std::string layer_of(const CriticalPoints& points, const std::string& key) {
  return layer_of(stage_sheet(points, frame), key);
}

TEST(PointsSheet, NothingToShowGivesNoLayer) {
  EXPECT_EQ(stage_sheet(CriticalPoints{}, frame).layers.size(), 2u) << "corners and nodes";
}

TEST(PointsSheet, AtFirstTheNodesAloneAreShown) {
  CriticalPoints points;
  points.critical_points = {saddle()};
  points.critical_points[0].error = 1e-3;
  points.clusters = {{{0.5, 0.5}, 0.1, -2, {{0.4, 0.5}, {0.6, 0.5}}, {-1, -1}}};
  points.certificate.cells = {{7, {0, 0, 1, 0, 0, 1}, CellVerdict::open}};
  for (const JsonObject& layer : stage_sheet(points, frame).layers)
    EXPECT_EQ(count(layer.str(), "\"shown\":true"), count(layer.str(), "\"key\":\"nodes\"")) << layer.str();
}

TEST(PointsSheet, AZeroHasAnArrowForEachSeparatrix) {
  CriticalPoints points;
  points.critical_points = {saddle()};
  EXPECT_EQ(count(layer_of(points, "directions"), "a separatrix starts at"), 5);
  EXPECT_EQ(count(layer_of(points, "directions"), "starts at 0.00°"), 1) << "along the axis, where v is (1, 0)";
}

TEST(PointsSheet, ANodeThatIsNoZeroHasNoArrows) {
  CriticalPoints points;
  points.critical_points = {saddle()};
  points.critical_points[0].source = NodeSource::hand;
  points.critical_points[0].jacobian = {};
  EXPECT_EQ(layer_of(points, "directions"), "");
}

TEST(PointsSheet, ErrorBarsClustersAndTheSearchAreLayers) {
  CriticalPoints points;
  points.critical_points = {saddle()};
  points.critical_points[0].error = 1e-3;
  points.clusters = {{{0.5, 0.5}, 0.1, -2, {{0.4, 0.5}, {0.6, 0.5}}, {-1, -1}}};
  points.certificate.cells = {{7, {0, 0, 1, 0, 0, 1}, CellVerdict::open}};
  points.certificate.disc_centres = {{0, 0}};
  points.certificate.disc_radii = {0.1};
  EXPECT_EQ(count(layer_of(points, "errors"), "error bar of the position: 0.001"), 1);
  EXPECT_EQ(count(layer_of(points, "clusters"), "cluster of index -2, 2 members"), 1);
  EXPECT_EQ(count(layer_of(points, "members"), "zero of a cluster"), 2);
  EXPECT_EQ(count(layer_of(points, "cells"), "in triangle 7: could not be decided"), 1);
  EXPECT_NE(layer_of(points, "left"), "");
}

TEST(PointsSheet, ArrowsLeadFromEveryMarkBeforeToOneAfterAndReachAll) {
  const auto mark = [](double x) { return NodeMark{{x, 0.5}, 3, NodeLocation::inside}; };
  CriticalPoints points;
  points.changes = {{ChangeKind::cluster, "two in place of one", {mark(0.5)}, {mark(0.45), mark(0.55)}},
                    {ChangeKind::cancel, "gone", {mark(0.1), mark(0.2)}, {}}};
  EXPECT_EQ(count(layer_of(points, "arrows"), "cluster: two in place of one"), 2);
  EXPECT_EQ(count(layer_of(points, "arrows"), "gone"), 0);
}

}  // namespace
}  // namespace quadrille::page
