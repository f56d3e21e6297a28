#include "placement/node_ledger.hpp"

#include <gtest/gtest.h>

#include "../support/critical_points.hpp"
#include "../triangulate/faces.hpp"

namespace quadrille::placement {
namespace {

using namespace testing_faces;
using hand_made::node;

/// A square with three nodes; the index sum is stale.
CriticalPoints three_nodes() {
  CriticalPoints points =
      hand_made::points_of(square(), {node({0.2, 0.5}, 3), node({0.5, 0.5}, 5), node({0.8, 0.5}, 3)});
  points.index_sum = -99;
  return points;
}

/// Removes the first node and adds one, against a corner's valence.
NodeEdit some_edit() { return {ChangeKind::corner, "because", {{2, 2}}, {{{0.3, 0.3}, 3}, {{0.4, 0.3}, 3}}, {0}}; }

TEST(NodeLedger, CarriesOutAChangeAndKeepsAllBooks) {
  CriticalPoints points = three_nodes();
  apply({some_edit()}, points);
  ASSERT_EQ(points.critical_points.size(), 4u);
  EXPECT_EQ(points.critical_points[0].position, (Vec2{0.5, 0.5}));
  EXPECT_EQ(points.critical_points[0].source, NodeSource::zero);
  EXPECT_EQ(points.critical_points[2].position, (Vec2{0.3, 0.3}));
  EXPECT_EQ(points.critical_points[2].index, 1);
  EXPECT_EQ(points.critical_points[2].source, NodeSource::corner);
  EXPECT_EQ(points.corners[2].valence, 2);
  EXPECT_EQ(points.corners[2].source, NodeSource::corner);
  EXPECT_EQ(points.form, NodeForm::phase);
  EXPECT_EQ(points.index_sum, points.index_sum_expected);
  EXPECT_EQ(points.zeros.size(), 3u);
}

TEST(NodeLedger, RecordsCornersBeforeNodesWithTheirValencesBeforeAndAfter) {
  CriticalPoints points = three_nodes();
  apply({some_edit()}, points);
  ASSERT_EQ(points.changes.size(), 1u);
  const NodeChange& change = points.changes[0];
  EXPECT_EQ(change.kind, ChangeKind::corner);
  EXPECT_EQ(change.reason, "because");
  ASSERT_EQ(change.before.size(), 2u);
  EXPECT_EQ(change.before[0].location, NodeLocation::corner);
  EXPECT_EQ(change.before[0].valence, 1);
  EXPECT_EQ(change.before[1].position, (Vec2{0.2, 0.5}));
  ASSERT_EQ(change.after.size(), 3u);
  EXPECT_EQ(change.after[0].valence, 2);
  EXPECT_EQ(change.after[2].position, (Vec2{0.4, 0.3}));
  hand_made::expect_sound_changes(points.changes);
}

TEST(NodeLedger, RefersToTheNodesBeforeAllChanges) {
  CriticalPoints points = three_nodes();
  const NodeEdit first{ChangeKind::cancel, "a", {}, {{{0.1, 0.1}, 3}}, {0}};
  const NodeEdit second{ChangeKind::cancel, "b", {}, {{{0.9, 0.1}, 3}}, {2}};
  apply({first, second}, points);
  ASSERT_EQ(points.critical_points.size(), 3u);
  EXPECT_EQ(points.critical_points[0].valence, 5);
  EXPECT_EQ(points.critical_points[2].position, (Vec2{0.9, 0.1}));
  EXPECT_EQ(points.changes[1].before[0].position, (Vec2{0.8, 0.5}));
}

TEST(NodeLedger, KeepsTheZerosOfTheFieldOnlyBeforeTheFirstChangeOfNodes) {
  CriticalPoints points = three_nodes();
  apply({{ChangeKind::divide, "a", {}, {{{0.1, 0.1}, 3}}, {0}}}, points);
  apply({{ChangeKind::divide, "b", {}, {{{0.2, 0.1}, 5}}, {0}}}, points);
  ASSERT_EQ(points.zeros.size(), 3u);
  EXPECT_EQ(points.zeros[0].position, (Vec2{0.2, 0.5}));
  CriticalPoints tilted = three_nodes();
  tilted.form = NodeForm::phase;  // as after ties
  apply({{ChangeKind::divide, "a", {}, {{{0.1, 0.1}, 3}}, {0}}}, tilted);
  EXPECT_EQ(tilted.zeros.size(), 3u);
  CriticalPoints exchanged = three_nodes();
  apply({{ChangeKind::corner, "c", {{0, 2}, {1, 0}}}}, exchanged);
  EXPECT_EQ(exchanged.form, NodeForm::phase);
  EXPECT_TRUE(exchanged.zeros.empty());
}

TEST(NodeLedger, LeavesTheFormWhereCornersOnlyAbsorbZeros) {
  CriticalPoints points = three_nodes();
  apply({{ChangeKind::absorb, "near", {{0, 0}}, {}, {}, {{{0.01, 0.01}, 3}}}}, points);
  EXPECT_EQ(points.form, NodeForm::harmonic);
  EXPECT_EQ(points.corners[0].source, NodeSource::absorb);
  EXPECT_EQ(points.critical_points.size(), 3u);
  hand_made::expect_sound_changes(points.changes);
}

TEST(NodeLedger, RecordsNoValenceBeforeWhereTheFieldDecidesNone) {
  CriticalPoints points = three_nodes();
  apply({{ChangeKind::line, "by rule", {{1, 2}}}}, points);
  EXPECT_TRUE(points.changes[0].before.empty());
  EXPECT_EQ(points.changes[0].after[0].valence, 2);
  EXPECT_EQ(points.corners[1].source, NodeSource::line);
}

TEST(NodeLedger, KeepsTheBooksOfNodesThatRulesReplaced) {
  CriticalPoints points = three_nodes();
  NodeSet nodes{points.critical_points, points.corners, {}};
  nodes.critical_points[0] = changed_node(nodes.critical_points[0], {0.2, 0.6}, 3, NodeSource::feature);
  nodes.critical_points.pop_back();
  nodes.boundary_nodes.push_back({0, 0.5, {0.5, 0}, 3});
  replace_nodes(nodes, {{ChangeKind::feature, "a", {}, {}}}, points);
  EXPECT_EQ(points.form, NodeForm::phase);
  EXPECT_EQ(points.zeros.size(), 3u);
  EXPECT_EQ(points.index_sum, index_sum_of(points));
  EXPECT_EQ(points.changes.size(), 1u);
  EXPECT_EQ(points.critical_points[0].error, 0);
  EXPECT_EQ(points.critical_points[0].jacobian, (std::array<double, 4>{}));
}

TEST(NodeLedger, RecordsWhatChangesNoNode) {
  CriticalPoints points = three_nodes();
  record({{ChangeKind::feature, "no room", {mark_of(points.critical_points[0])}, {}}}, points);
  EXPECT_EQ(points.changes.size(), 1u);
  EXPECT_EQ(points.form, NodeForm::harmonic);
}

}  // namespace
}  // namespace quadrille::placement
