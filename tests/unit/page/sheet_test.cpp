#include "page/sheet.hpp"

#include <gtest/gtest.h>

#include "../region_samples.hpp"
#include "sheet_samples.hpp"

namespace quadrille::page {
namespace {

TEST(BoundaryLayer, HasTheNamesOfCurvesAndNoRegionsOfOneFace) {
  const std::string layer = boundary_layer(samples::face(), frame).str();
  expect_contains(layer, R"("names":["side 0","side 1","side 2","side 3"])");
  expect_contains(layer, member("offsets", {0, 4, 8, 12, 16}));
  expect_counts(layer, {{"\"regions\":", 0}, {"\"partners\":", 0}});
}

TEST(BoundaryLayer, RegionsHaveAPlaceForTheirNames) {
  const std::string layer = boundary_layer(samples::two_regions_face(), page_frame({{0, 0}, {2, 1}})).str();
  expect_contains(layer, R"("regions":[["fluid",-0.5,0,0.5],["solid",0.5,0,0.5]])");
  expect_contains(layer, member("partners", {-1, 7, -1, -1, -1, -1, -1, 1}));
}

TEST(BoundsOfJacobian, OnlyThoseThatProveNothingAreBad) {
  const Quantity good = bounds_of_jacobian({0.5, 0.25});
  EXPECT_EQ(good.low, 0);
  EXPECT_EQ(good.high, 0) << "from less to more";
  const Quantity bad = bounds_of_jacobian({0.5, -0.25});
  EXPECT_EQ(bad.low, -0.25);
  EXPECT_EQ(bad.high, 0.25);
  EXPECT_EQ(bounds_of_jacobian({}).high, 0);
}

TEST(QuantitiesJson, QuantitiesWithoutValuesAreLeftOut) {
  const std::string json = quantities_json({{"none", "low", 0, 1, {}}, {"some", "high", 1, 2, {1.5}, true}});
  expect_counts(json, {{"none", 0}, {R"("title":"some")", 1}, {R"("worst":"high")", 1}, {R"("log":true)", 1}});
  EXPECT_EQ(quantities_json({}), "[]");
}

/// Kinds decide shapes: crossings are dots, which are shown with lines only.
TEST(MarksOf, IrregularNodesAndCornersStandOut) {
  ArcGraph graph;
  const auto add = [&](NodeKind kind, int valence, int curve = -1) {
    graph.nodes.push_back({{0.5, 0.5}, kind, valence, curve, 0});
  };
  add(NodeKind::irregular, 3), add(NodeKind::corner, 1, 0), add(NodeKind::crossing, 4);
  add(NodeKind::boundary, 2, 0), add(NodeKind::boundary, 3, 0), add(NodeKind::junction, 4, 0);
  add(NodeKind::junction, 5, 0);
  EXPECT_EQ(marks_of(graph, frame, true).kinds,
            (std::vector<std::string>{"node", "corner", "dot", "dot", "boundary", "dot", "node"}));
  const Marks few = marks_of(graph, frame, false);
  EXPECT_EQ(few.kinds, (std::vector<std::string>{"node", "corner", "boundary", "node"}));
  EXPECT_EQ(few.texts[2], "node 4: boundary, valence 3");
  expect_contains(few.layer("nodes", "irregular nodes", false).str(), member("valences", {3, 1, 3, 5}));
}

}  // namespace
}  // namespace quadrille::page
