// resolve_features on faces made by hand, with nodes where small features put them (lib/method.md §5): a convex right
// angle of radius r has its node of valence 3 at 0.312 r from the arc, a reflex one its node of valence 5 at 0.407 r.
#include "features/resolve_features.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "feature_faces.hpp"

namespace quadrille::features {
namespace {

using namespace testing_features;

using hand_made::node;

/// Without curves from which nodes keep a distance.
void resolve_features(const CadFace& face, double size, CriticalPoints& points) {
  features::resolve_features(face, size, std::vector<bool>(face.curves.size(), false), points);
}

CriticalPoints points_with(const CadFace& face, const std::vector<CriticalPoint>& nodes) {
  CriticalPoints points = hand_made::points_of(face, nodes);
  points.index_sum_expected = 4 * face.euler_characteristic();
  return points;
}

/// The nodes at the four fillets of a rectangle: `depth` radii off the arcs, outside them (side = 1) or inside (-1).
std::vector<CriticalPoint> at_fillets(Vec2 low, Vec2 high, double radius, double depth, double side, int valence) {
  const double off = radius * (1 - std::sqrt(0.5) + side * depth * std::sqrt(0.5));
  return {node({low.x + off, low.y + off}, valence), node({high.x - off, low.y + off}, valence),
          node({high.x - off, high.y - off}, valence), node({low.x + off, high.y - off}, valence)};
}

const CadFace& filleted_frame() {
  static const CadFace face =
      hand_made::face({rectangle({0, 0}, {2, 1}, 0.02), window({0.6, 0.35}, {1.4, 0.65}, 0.01)}, std::sqrt(5.0));
  return face;
}

CriticalPoints frame_points() {
  std::vector<CriticalPoint> nodes = at_fillets({0, 0}, {2, 1}, 0.02, convex_depth, 1, 3);
  const auto inner = at_fillets({0.6, 0.35}, {1.4, 0.65}, 0.01, reflex_depth, -1, 5);
  nodes.insert(nodes.end(), inner.begin(), inner.end());
  return points_with(filleted_frame(), nodes);
}

void expect_sound(const CadFace& face, const CriticalPoints& points) {
  EXPECT_EQ(points.index_sum, points.index_sum_expected);
  EXPECT_EQ(index_sum_of(points), points.index_sum_expected);
  for (const IrregularBoundaryPoint& b : points.boundary_nodes) {
    const Nurbs& curve = face.curves[b.curve];
    EXPECT_LE(distance(curve::point(curve, b.t), b.position), 1e-12 * face.diameter);
    EXPECT_TRUE(b.t > curve.begin() || !face.joints[b.curve].is_corner);
    EXPECT_LT(b.t, curve.end());
  }
  expect_sound_changes(points.changes);
}

bool has_node_at(const CriticalPoints& points, Vec2 x, int valence, double tol) {
  return std::any_of(points.critical_points.begin(), points.critical_points.end(),
                     [&](const CriticalPoint& p) { return p.valence == valence && distance(p.position, x) <= tol; });
}

bool has_boundary_node_at(const CriticalPoints& points, Vec2 x, int valence, double tol) {
  return std::any_of(points.boundary_nodes.begin(), points.boundary_nodes.end(), [&](const IrregularBoundaryPoint& b) {
    return b.valence == valence && distance(b.position, x) <= tol;
  });
}

int count_changes(const CriticalPoints& points, ChangeKind kind) {
  return static_cast<int>(std::count_if(points.changes.begin(), points.changes.end(),
                                        [&](const NodeChange& change) { return change.kind == kind; }));
}

TEST(ResolveFeatures, LeavesEverythingAtSizeZeroAndBelowTheFillets) {
  for (const double size : {0.0, 0.005, 0.01}) {
    CriticalPoints points = frame_points();
    resolve_features(filleted_frame(), size, points);
    EXPECT_EQ(points.form, NodeForm::harmonic) << size;
    EXPECT_TRUE(points.changes.empty());
    EXPECT_TRUE(points.zeros.empty());
    ASSERT_EQ(points.critical_points.size(), 8u);
    EXPECT_EQ(points.critical_points[3].position, frame_points().critical_points[3].position);
    EXPECT_EQ(points.critical_points[3].source, NodeSource::zero);
  }
}

TEST(ResolveFeatures, RefusesSizesThatAreNoLength) {
  CriticalPoints points = frame_points();
  EXPECT_THROW(resolve_features(filleted_frame(), -1, points), UsageError);
  EXPECT_THROW(resolve_features(filleted_frame(), std::numeric_limits<double>::infinity(), points), UsageError);
  EXPECT_THROW(resolve_features(filleted_frame(), std::nan(""), points), UsageError);
}

TEST(ResolveFeatures, PutsNodesOfReflexFilletsInTheMiddleOfTheirArcs) {
  CriticalPoints points = frame_points();
  resolve_features(filleted_frame(), 0.015, points);
  expect_sound(filleted_frame(), points);
  EXPECT_EQ(points.form, NodeForm::phase);
  EXPECT_EQ(points.zeros.size(), 8u);
  EXPECT_EQ(points.critical_points.size(), 4u);
  ASSERT_EQ(points.boundary_nodes.size(), 4u);
  const double off = 0.01 * (1 - std::sqrt(0.5));
  for (const double x : {0.6 + off, 1.4 - off})
    for (const double y : {0.35 + off, 0.65 - off}) EXPECT_TRUE(has_boundary_node_at(points, {x, y}, 3, 1e-13));
  EXPECT_EQ(count_changes(points, ChangeKind::feature), 4);
  EXPECT_EQ(points.critical_points[0].source, NodeSource::zero);  // radius 0.02 is not below the size
}

TEST(ResolveFeatures, LeavesNodesInsideThatKeepADistanceFromTheirFillets) {
  CriticalPoints points = frame_points();
  const CadFace face = filleted_frame();
  features::resolve_features(face, 0.015, std::vector<bool>(face.curves.size(), true), points);
  EXPECT_EQ(points.critical_points.size(), 8u);
  EXPECT_TRUE(points.boundary_nodes.empty());
}

TEST(ResolveFeatures, MovesNodesOfConvexFilletsInwardToTheSize) {
  CriticalPoints points = frame_points();
  resolve_features(filleted_frame(), 0.1, points);
  expect_sound(filleted_frame(), points);
  ASSERT_EQ(points.critical_points.size(), 4u);
  for (const double x : {0.1, 1.9})
    for (const double y : {0.1, 0.9}) EXPECT_TRUE(has_node_at(points, {x, y}, 3, 1e-12)) << x << " " << y;
  for (const CriticalPoint& p : points.critical_points) {
    EXPECT_EQ(p.source, NodeSource::feature);
    EXPECT_EQ(p.jacobian[0], 0);
    EXPECT_EQ(p.error, 0);
  }
}

TEST(ResolveFeatures, StopsWhereTheOtherNodeIsAsNearAsTheWalls) {
  const CadFace face =
      hand_made::face({filleted({{0, 0}, {4, 0}, {4, 1.2}, {0, 1.2}}, {0, 0.1, 0.1, 0})}, std::hypot(4, 1.2));
  const double off = 0.1 * (1 - std::sqrt(0.5) + convex_depth * std::sqrt(0.5));
  CriticalPoints points = points_with(face, {node({4 - off, off}, 3), node({4 - off, 1.2 - off}, 3)});
  resolve_features(face, 0.7, points);
  expect_sound(face, points);
  EXPECT_TRUE(has_node_at(points, {3.6, 0.4}, 3, 1e-9));  // 1.2 - 2 w = w
  EXPECT_TRUE(has_node_at(points, {3.6, 0.8}, 3, 1e-9));
}

TEST(ResolveFeatures, StopsHalfTheWayToTheOppositeWall) {
  const CadFace face = hand_made::face({filleted({{0, 0}, {4, 0}, {4, 1}, {0, 1}}, {0, 0.1, 0, 0})}, std::hypot(4, 1));
  const double off = 0.1 * (1 - std::sqrt(0.5) + convex_depth * std::sqrt(0.5));
  CriticalPoints points = points_with(face, {node({4 - off, off}, 3)});
  resolve_features(face, 0.8, points);
  expect_sound(face, points);
  EXPECT_TRUE(has_node_at(points, {3.5, 0.5}, 3, 1e-9));
}

/// Every point of the loops through `map`, which keeps the orientation.
CadFace moved(const std::vector<Loop>& loops, double diameter, const std::function<Vec2(Vec2)>& map) {
  std::vector<Loop> result = loops;
  for (Loop& loop : result) {
    for (Nurbs& curve : loop) {
      for (Vec2& pole : curve.poles) pole = map(pole);
    }
  }
  return hand_made::face(result, diameter);
}

TEST(ResolveFeatures, TurnsAndScalesWithTheFace) {
  const std::vector<Loop> loops{rectangle({0, 0}, {2, 1}, 0.02), window({0.6, 0.35}, {1.4, 0.65}, 0.01)};
  const double scale = 1e3;
  const auto map = [&](Vec2 x) {
    const Vec2 e = unit(radians(37));
    return scale * Vec2{x.x * e.x - x.y * e.y + 0.3, x.x * e.y + x.y * e.x - 2};
  };
  const CadFace face = moved(loops, scale * std::sqrt(5.0), map);
  for (const double size : {0.015, 0.1, 0.3, 0.7}) {
    CriticalPoints here = frame_points(), there = frame_points();
    for (CriticalPoint& p : there.critical_points) p.position = map(p.position);
    resolve_features(filleted_frame(), size, here);
    resolve_features(face, scale * size, there);
    expect_sound(face, there);
    ASSERT_EQ(here.critical_points.size(), there.critical_points.size()) << size;
    ASSERT_EQ(here.boundary_nodes.size(), there.boundary_nodes.size()) << size;
    for (const CriticalPoint& p : here.critical_points)
      EXPECT_TRUE(has_node_at(there, map(p.position), p.valence, 1e-8 * face.diameter)) << size;
    for (const IrregularBoundaryPoint& b : here.boundary_nodes)
      EXPECT_TRUE(has_boundary_node_at(there, map(b.position), b.valence, 1e-8 * face.diameter)) << size;
  }
}

TEST(ResolveFeatures, KeepsTheSymmetryAndTheRoomOfTheFace) {
  for (const double size : {0.03, 0.1, 0.3, 0.45}) {
    CriticalPoints points = frame_points();
    resolve_features(filleted_frame(), size, points);
    expect_sound(filleted_frame(), points);
    for (const CriticalPoint& p : points.critical_points) {
      EXPECT_TRUE(has_node_at(points, {2 - p.position.x, p.position.y}, p.valence, 1e-12)) << size;
      EXPECT_TRUE(has_node_at(points, {p.position.x, 1 - p.position.y}, p.valence, 1e-12)) << size;
      EXPECT_GE(std::min({p.position.x, 2 - p.position.x, p.position.y, 1 - p.position.y}), size / 2);
      for (const CriticalPoint& q : points.critical_points) {
        EXPECT_TRUE(&p == &q || distance(p.position, q.position) >= size / 2) << size;
      }
      for (const IrregularBoundaryPoint& b : points.boundary_nodes)
        EXPECT_GE(distance(p.position, b.position), size / 2) << size;
    }
  }
}

/// A square of side 4 about the origin with a circular hole, cut into two curves at `angle` and opposite.
CadFace square_with_hole(double radius, double angle) {
  return hand_made::face({rectangle({-2, -2}, {2, 2}, 0),
                          {curve::circular_arc({0, 0}, radius, angle, angle - pi),
                           curve::circular_arc({0, 0}, radius, angle - pi, angle - 2 * pi)}},
                         std::sqrt(32.0));
}

TEST(ResolveFeatures, PutsTheFourNodesOfAHoleAtTheirFeetAlsoOnItsJoints) {
  for (const double angle : {0.0, pi / 4}) {
    const CadFace face = square_with_hole(0.1, angle);
    std::vector<CriticalPoint> nodes;
    for (int k = 0; k < 4; ++k) nodes.push_back(node(0.135 * unit(pi / 4 + k * half_pi), 5));
    CriticalPoints points = points_with(face, nodes);
    resolve_features(face, 0.3, points);
    expect_sound(face, points);
    EXPECT_TRUE(points.critical_points.empty());
    ASSERT_EQ(points.boundary_nodes.size(), 4u);
    for (int k = 0; k < 4; ++k)
      EXPECT_TRUE(has_boundary_node_at(points, 0.1 * unit(pi / 4 + k * half_pi), 3, 1e-12)) << angle;
  }
}

TEST(ResolveFeatures, PutsNodesOnAKnotRatherThanBesideIt) {
  const CadFace face = hand_made::face(
      {rectangle({-2, -2}, {2, 2}, 0), {curve::circular_arc({0, 0}, 0.1, pi / 4, pi / 4 - 2 * pi)}}, std::sqrt(32.0));
  std::vector<CriticalPoint> nodes;
  for (int k = 0; k < 4; ++k) nodes.push_back(node(0.135 * unit(pi / 4 + k * half_pi + 1e-10), 5));
  CriticalPoints points = points_with(face, nodes);
  resolve_features(face, 0.3, points);
  expect_sound(face, points);
  ASSERT_EQ(points.boundary_nodes.size(), 4u);
  for (const IrregularBoundaryPoint& b : points.boundary_nodes) {
    const std::vector<double>& knots = face.curves[b.curve].knots;
    EXPECT_NE(std::find(knots.begin(), knots.end(), b.t), knots.end()) << b.t;
  }
}

TEST(ResolveFeatures, KeepsNodesOfAHoleOffOneSpot) {
  const CadFace face = square_with_hole(0.1, 0);
  CriticalPoints points = points_with(
      face, {node({0.13, 0.001}, 5), node({0.14, -0.001}, 5), node({-0.13, 0.01}, 5), node({-0.13, -0.01}, 5)});
  resolve_features(face, 0.3, points);
  expect_sound(face, points);
  ASSERT_EQ(points.boundary_nodes.size(), 4u);
  for (size_t i = 0; i < 4; ++i) {
    for (size_t j = 0; j < i; ++j)
      EXPECT_GE(distance(points.boundary_nodes[i].position, points.boundary_nodes[j].position), 0.14);
  }
}

TEST(ResolveFeatures, LeavesAHoleThatIsNotSmallerThanTheSize) {
  const CadFace face = square_with_hole(0.1, 0);
  std::vector<CriticalPoint> nodes;
  for (int k = 0; k < 4; ++k) nodes.push_back(node(0.135 * unit(pi / 4 + k * half_pi), 5));
  CriticalPoints points = points_with(face, nodes);
  resolve_features(face, 0.2, points);  // the diameter itself, to round-off
  EXPECT_TRUE(points.boundary_nodes.empty());
  EXPECT_EQ(points.form, NodeForm::harmonic);
}

TEST(ResolveFeatures, CancelsThePairOfASmallStep) {
  const double r = 0.05;
  const std::vector<Vec2> corners{{0, 0}, {4, 0}, {4, 1.2}, {2, 1.2}, {2, 1}, {0, 1}};
  const CadFace face = hand_made::face({filleted(corners, {0, 0, 0, r, r, 0})}, std::hypot(4, 1.2));
  const double out = r * (1 - std::sqrt(0.5) + convex_depth * std::sqrt(0.5)),
               in = r * (1 - std::sqrt(0.5) - reflex_depth * std::sqrt(0.5));
  const std::vector<CriticalPoint> nodes{node({2 + out, 1.2 - out}, 3), node({2 + in, 1 + in}, 5)};
  CriticalPoints kept = points_with(face, nodes), points = kept;
  resolve_features(face, 0.04, kept);
  EXPECT_EQ(kept.critical_points.size(), 2u);
  resolve_features(face, 0.3, points);
  expect_sound(face, points);
  EXPECT_TRUE(points.critical_points.empty());
  EXPECT_TRUE(points.boundary_nodes.empty());
  ASSERT_EQ(points.changes.size(), 1u);
  EXPECT_EQ(points.changes[0].kind, ChangeKind::cancel);
  EXPECT_EQ(points.changes[0].before.size(), 2u);
  EXPECT_TRUE(points.changes[0].after.empty());
}

TEST(ResolveFeatures, DecidesPairsOfEqualDistanceTogether) {
  const CadFace face = hand_made::face({rectangle({-2, -2}, {2, 2}, 0)}, std::sqrt(32.0));
  CriticalPoints points = points_with(face, {node({-0.1, 0}, 5), node({0, 0.03}, 3), node({0.1 + 1e-9, 0}, 5)});
  resolve_features(face, 0.2, points);
  ASSERT_EQ(points.critical_points.size(), 1u);
  EXPECT_TRUE(has_node_at(points, {0, 0.01}, 5, 1e-8));
  EXPECT_EQ(points.critical_points[0].source, NodeSource::cancel);
  // Four about one: no node of the layout could stand for them all.
  std::vector<CriticalPoint> star{node({0, 0}, 3)};
  for (int k = 0; k < 4; ++k) star.push_back(node(0.3 * unit(k * half_pi), 5));
  CriticalPoints kept = points_with(face, star);
  resolve_features(face, 0.4, kept);
  EXPECT_EQ(kept.critical_points.size(), 5u);
  EXPECT_EQ(kept.form, NodeForm::harmonic);
}

TEST(ResolveFeatures, DoesNotCancelThroughAWall) {
  const CadFace face = square_with_hole(0.1, 0);
  CriticalPoints points = points_with(face, {node({0, 0.2}, 5), node({0, -0.2}, 3)});
  resolve_features(face, 0.45, points);
  EXPECT_EQ(count_changes(points, ChangeKind::cancel), 0);
}

TEST(ResolveFeatures, MergesTheNodesAtTheEndsOfANarrowSlot) {
  const CadFace face =
      hand_made::face({rectangle({-4, -4}, {4, 4}, 0), window({-1, -0.1}, {1, 0.1}, 0.05)}, std::sqrt(128.0));
  const auto nodes = at_fillets({-1, -0.1}, {1, 0.1}, 0.05, reflex_depth, -1, 5);
  CriticalPoints apart = points_with(face, nodes), merged = apart;
  resolve_features(face, 0.2, apart);
  EXPECT_EQ(apart.boundary_nodes.size(), 4u);
  resolve_features(face, 0.5, merged);
  expect_sound(face, merged);
  ASSERT_EQ(merged.boundary_nodes.size(), 2u);
  EXPECT_TRUE(has_boundary_node_at(merged, {-1, 0}, 4, 1e-12));
  EXPECT_TRUE(has_boundary_node_at(merged, {1, 0}, 4, 1e-12));
}

TEST(ResolveFeatures, PutsBothNodesOfANoseOntoIt) {
  // An ellipse with half axes 1 and 0.2: radius 0.04 at its ends, 5 on its flanks.
  Loop ellipse{curve::circular_arc({0, 0}, 1, 0, -2 * pi)};
  for (Vec2& pole : ellipse[0].poles) pole.y *= 0.2;
  const CadFace face = hand_made::face({rectangle({-4, -4}, {4, 4}, 0), ellipse}, std::sqrt(128.0));
  const std::vector<CriticalPoint> nodes{node({1.03, 0.04}, 5), node({1.03, -0.04}, 5), node({-1.03, 0.04}, 5),
                                         node({-1.03, -0.04}, 5)};
  CriticalPoints points = points_with(face, nodes);
  resolve_features(face, 0.07, points);
  expect_sound(face, points);
  ASSERT_EQ(points.boundary_nodes.size(), 4u);
  for (const IrregularBoundaryPoint& b : points.boundary_nodes) {
    EXPECT_TRUE(has_boundary_node_at(points, {b.position.x, -b.position.y}, 3, 1e-12));
    EXPECT_TRUE(has_boundary_node_at(points, {-b.position.x, b.position.y}, 3, 1e-12));
    EXPECT_GT(std::abs(b.position.y), 0.01);
  }
}

TEST(ResolveFeatures, LetsACornerOfASmallHoleTakeTheNodeInFrontOfIt) {
  const double s = 0.1;
  const Loop triangle = filleted({{-s, 0}, {0, s * std::sqrt(3.0)}, {s, 0}}, {0, 0, 0});
  const CadFace face = hand_made::face({rectangle({-2, -2}, {2, 2}, 0), triangle}, std::sqrt(32.0));
  CriticalPoints points = points_with(face, {node({0, 0.25}, 5)});
  ASSERT_EQ(points.index_sum, points.index_sum_expected);
  resolve_features(face, 0.5, points);
  expect_sound(face, points);
  EXPECT_TRUE(points.critical_points.empty());
  EXPECT_TRUE(points.boundary_nodes.empty());
  const auto taken = std::find_if(points.corners.begin(), points.corners.end(),
                                  [](const Corner& corner) { return corner.source == NodeSource::feature; });
  ASSERT_NE(taken, points.corners.end());
  EXPECT_EQ(taken->valence, 4);
  EXPECT_LE(distance(taken->position, {0, s * std::sqrt(3.0)}), 1e-12);
}

TEST(ResolveFeatures, PushesNodesOfOneSignApart) {
  const CadFace face = hand_made::face({rectangle({-2, -2}, {2, 2}, 0)}, std::sqrt(32.0));
  CriticalPoints points = points_with(face, {node({-0.01, 0}, 5), node({0.01, 0}, 5)});
  resolve_features(face, 0.4, points);
  ASSERT_EQ(points.critical_points.size(), 2u);
  const Vec2 a = points.critical_points[0].position, b = points.critical_points[1].position;
  EXPECT_GE(distance(a, b), 0.2);
  EXPECT_LE(distance(a, b), 0.21);
  EXPECT_LE(norm(a + b), 1e-12);
  EXPECT_EQ(points.form, NodeForm::phase);
}

TEST(ResolveFeatures, SaysWhereThereIsNoRoom) {
  const CadFace face = hand_made::face({rectangle({-2, -2}, {2, 2}, 0),
                                        {curve::circular_arc({-0.11, 0}, 0.1, 0, -2 * pi)},
                                        {curve::circular_arc({0.11, 0}, 0.1, pi, -pi)}},
                                       std::sqrt(32.0));
  CriticalPoints points = points_with(face, {node({-0.015, 0.06}, 5), node({0.015, 0.06}, 5)});
  resolve_features(face, 0.25, points);
  ASSERT_EQ(points.boundary_nodes.size(), 2u);
  ASSERT_FALSE(points.changes.empty());
  EXPECT_NE(points.changes.back().reason.find("no room"), std::string::npos);
}

TEST(ResolveFeatures, GivesAFeatureNoMoreNodesThanItCarries) {
  const CadFace face =
      hand_made::face({rectangle({-4, -4}, {4, 4}, 0), window({-1, -1}, {1, 1}, 0.1)}, std::sqrt(128.0));
  const Vec2 corner{0.98, 0.98}, middle = Vec2{0.9, 0.9} + 0.1 * unit(pi / 4);
  CriticalPoints nearest =
      points_with(face, {node(corner + 0.03 * unit(pi / 4), 5), node(corner + 0.2 * unit(pi / 4), 5)});
  resolve_features(face, 0.3, nearest);
  ASSERT_EQ(nearest.boundary_nodes.size(), 1u);
  EXPECT_TRUE(has_boundary_node_at(nearest, middle, 3, 1e-12));
  EXPECT_TRUE(has_node_at(nearest, corner + 0.2 * unit(pi / 4), 5, 1e-15));
  CriticalPoints alike = points_with(face, {node({1.1, 0.9}, 5), node({0.9, 1.1}, 5)});
  resolve_features(face, 0.15, alike);
  EXPECT_TRUE(alike.boundary_nodes.empty());
  EXPECT_EQ(alike.critical_points.size(), 2u);
}

TEST(ResolveFeatures, LeavesANodeHalfwayBetweenTwoFeatures) {
  const CadFace face =
      hand_made::face({rectangle({-4, -4}, {4, 4}, 0), window({-1, -0.2}, {1, 0.2}, 0.1)}, std::sqrt(128.0));
  CriticalPoints points = points_with(face, {node({1.1, 0}, 5)});
  resolve_features(face, 0.3, points);
  EXPECT_TRUE(points.boundary_nodes.empty());
  EXPECT_EQ(points.form, NodeForm::harmonic);
}

TEST(ResolveFeatures, LeavesTheNodeOfALargerFeatureBesideASmallOne) {
  const CadFace face = hand_made::face(
      {rectangle({-4, -4}, {4, 4}, 0), window({-2, -2}, {0, 0}, 1), {curve::circular_arc({0.6, 0.6}, 0.1, 0, -2 * pi)}},
      std::sqrt(128.0));
  CriticalPoints points = points_with(face, {node({0.1, 0.1}, 5)});  // 0.56 off the arc, 0.61 off the hole
  resolve_features(face, 0.9, points);
  EXPECT_TRUE(points.boundary_nodes.empty());
  CriticalPoints nearer = points_with(face, {node({0.2, 0.2}, 5)});
  resolve_features(face, 0.9, nearer);
  EXPECT_EQ(nearer.boundary_nodes.size(), 1u);
}

// Pairs of rules that can meet: each test fails when the two are applied in the other order, or one without the other.

/// The nodes of a part of a layout: the index sum is not that of a face, but it is kept.
CriticalPoints resolved(const CadFace& face, const std::vector<CriticalPoint>& nodes, double size) {
  CriticalPoints points = points_with(face, nodes);
  const int sum = index_sum_of(points);
  resolve_features(face, size, points);
  EXPECT_EQ(index_sum_of(points), sum);
  expect_sound_changes(points.changes);
  return points;
}

/// A right angle of the outline at the origin with a fillet of radius 0.1, its node of valence 3, and others.
CadFace one_fillet() {
  return hand_made::face({filleted({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {0.1, 0, 0, 0})}, std::sqrt(32.0));
}

Vec2 fillet_node(double radius) {
  const double off = radius * (1 - std::sqrt(0.5) + convex_depth * std::sqrt(0.5));
  return {off, off};
}

TEST(RulePairs, CancelBeforeOwn_AFeatureGetsNoNodeThatCancels) {
  const CadFace face = one_fillet();
  const CriticalPoints points = resolved(face, {node(fillet_node(0.1), 3), node({0.2, 0.2}, 5)}, 0.5);
  EXPECT_TRUE(points.critical_points.empty());
  EXPECT_EQ(points.changes.size(), 1u);
}

TEST(RulePairs, CancelThenInward_TheNodeInTheMiddleOfThreeIsOwnedToo) {
  // 3, 5, 3 in a row on the bisector become one of valence 3, which then moves to the size.
  const CadFace face = one_fillet();
  const CriticalPoints points =
      resolved(face, {node({0.05, 0.05}, 3), node({0.08, 0.08}, 5), node({0.11, 0.11}, 3)}, 0.5);
  ASSERT_EQ(points.critical_points.size(), 1u);
  EXPECT_TRUE(has_node_at(points, {0.5, 0.5}, 3, 1e-9));
}

/// A small circular hole before the fillet of the outline.
CadFace fillet_and_hole(Vec2 centre, double radius) {
  return hand_made::face({filleted({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {0.1, 0, 0, 0}), round_hole(centre, radius)},
                         std::sqrt(32.0));
}

TEST(RulePairs, BoundaryBeforeInward_ANodeOnTheBoundaryDoesNotStopAMovingOne) {
  // The hole has one node left, on the bisector: (1, 1) less the radius along it.
  const CadFace face = fillet_and_hole({1, 1}, 0.1);
  const Vec2 on_hole = Vec2{1, 1} - 0.1 * unit(pi / 4);
  const CriticalPoints points =
      resolved(face, {node(fillet_node(0.1), 3), node(Vec2{1, 1} - 0.14 * unit(pi / 4), 5)}, 0.6);
  ASSERT_EQ(points.boundary_nodes.size(), 1u);
  EXPECT_TRUE(has_boundary_node_at(points, on_hole, 3, 1e-9));
  ASSERT_EQ(points.critical_points.size(), 1u);
  // Midway between outline and hole, t = sqrt(2) (1 - t) - 0.1. A node that were still inside would stop it at 0.528.
  const double t = (std::sqrt(2.0) - 0.1) / (1 + std::sqrt(2.0));
  EXPECT_TRUE(has_node_at(points, {t, t}, 3, 1e-6));
}

TEST(RulePairs, InwardThenCancel_AMovedNodeThatMeetsItsOppositeGoesWithIt) {
  // Apart by more than the size at first. The node stops where it is as near to the other as to the boundary, 0.24.
  const CadFace face = one_fillet();
  const Vec2 other{0.41, 0.41};
  ASSERT_GT(distance(fillet_node(0.1), other), 0.5);
  const CriticalPoints points = resolved(face, {node(fillet_node(0.1), 3), node(other, 5)}, 0.5);
  EXPECT_TRUE(points.critical_points.empty());
  EXPECT_EQ(count_changes(points, ChangeKind::feature), 1);
  EXPECT_EQ(count_changes(points, ChangeKind::cancel), 1);
}

TEST(RulePairs, InwardThenSeparate_AMovedNodeIsPushedOffOneOfItsSign) {
  const CadFace face = one_fillet();
  const CriticalPoints points = resolved(face, {node(fillet_node(0.1), 3), node({0.35, 0.35}, 3)}, 0.5);
  ASSERT_EQ(points.critical_points.size(), 2u);
  EXPECT_GE(distance(points.critical_points[0].position, points.critical_points[1].position), 0.25 - 1e-12);
}

TEST(RulePairs, BoundaryThenCancel_ANodeOnTheBoundaryCancelsAnInnerOneThatComesNear) {
  // The reflex fillet's node moves onto its arc; the one of valence 3 was farther than the size from where it was.
  const CadFace face = plate(4, {window({-1, -1}, {1, 1}, 0.1)});
  const Vec2 out = unit(pi / 4), arc = Vec2{0.9, 0.9} + 0.1 * out;
  const Vec2 before = arc + 0.3 * out + 0.2 * left_of(out), other = arc + 0.02 * out - 0.14 * left_of(out);
  ASSERT_GT(distance(before, other), 0.4);
  ASSERT_LT(distance(arc, other), 0.2);
  const CriticalPoints points = resolved(face, {node(before, 5), node(other, 3)}, 0.4);
  EXPECT_TRUE(points.boundary_nodes.empty());
  EXPECT_TRUE(points.critical_points.empty());
}

TEST(RulePairs, BoundaryThenSeparate_AnInnerNodeIsPushedOffOneOnTheBoundary) {
  const CadFace face = plate(4, {window({-1, -1}, {1, 1}, 0.1)});
  const Vec2 out = unit(pi / 4), arc = Vec2{0.9, 0.9} + 0.1 * out;
  const CriticalPoints points = resolved(face, {node(arc + 0.04 * out, 5), node(arc + 0.1 * out, 5)}, 0.4);
  ASSERT_EQ(points.boundary_nodes.size(), 1u);
  EXPECT_TRUE(has_boundary_node_at(points, arc, 3, 1e-12));
  ASSERT_EQ(points.critical_points.size(), 1u);
  EXPECT_GE(distance(points.critical_points[0].position, arc), 0.2 - 1e-12);
}

TEST(RulePairs, OwnThenCorner_ACornerTakesNoMoreThanTheCapacity) {
  // Two nodes before the tip of a triangular hole: the capacity is 1, the corner takes the nearer one.
  const double s = 0.1;
  const CadFace face = plate(2, {filleted({{-s, 0}, {0, s * std::sqrt(3.0)}, {s, 0}}, {0, 0, 0})});
  const CriticalPoints points = resolved(face, {node({0, 0.25}, 5), node({0, 0.6}, 5)}, 0.5);
  EXPECT_TRUE(points.boundary_nodes.empty());
  ASSERT_EQ(points.critical_points.size(), 1u);
  EXPECT_TRUE(has_node_at(points, {0, 0.6}, 5, 1e-12));
}

TEST(RulePairs, MergeBeforeSeparate_AnInnerNodeIsPushedOffTheMergedOne) {
  const CadFace face = plate(4, {window({-1, -0.1}, {1, 0.1}, 0.05)});
  std::vector<CriticalPoint> nodes = at_fillets({-1, -0.1}, {1, 0.1}, 0.05, reflex_depth, -1, 5);
  nodes.push_back(node({1.1, 0}, 5));
  const CriticalPoints points = resolved(face, nodes, 0.5);
  EXPECT_TRUE(has_boundary_node_at(points, {1, 0}, 4, 1e-12));
  ASSERT_EQ(points.critical_points.size(), 1u);
  EXPECT_GE(distance(points.critical_points[0].position, {1, 0}), 0.25 - 1e-12);
  EXPECT_NEAR(points.critical_points[0].position.y, 0, 1e-9);
}

TEST(RulePairs, CancelBeforeSeparate_OppositeNodesAreRemovedAndNotPushedApart) {
  const CadFace face = plate(4);
  const CriticalPoints points = resolved(face, {node({0, 0}, 3), node({0.1, 0}, 5), node({0.3, 0}, 3)}, 0.5);
  ASSERT_EQ(points.critical_points.size(), 1u);
  EXPECT_EQ(points.critical_points[0].valence, 3);
  EXPECT_EQ(count_changes(points, ChangeKind::cancel), static_cast<int>(points.changes.size()));
}

TEST(RulePairs, CornerBeforeInward_ACornerThatTookItsNodeDoesNotStopAMovingOne) {
  // The tip of a triangular hole points at the outline's fillet.
  const Vec2 tip{0.9, 0.9};
  const CadFace face =
      hand_made::face({filleted({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {0.1, 0, 0, 0}),
                       filleted({tip, tip + 0.2 * unit(radians(75)), tip + 0.2 * unit(radians(15))}, {0, 0, 0})},
                      std::sqrt(32.0));
  const CriticalPoints points = resolved(face, {node(fillet_node(0.1), 3), node(tip - 0.08 * unit(pi / 4), 5)}, 0.6);
  EXPECT_TRUE(points.boundary_nodes.empty());
  ASSERT_EQ(points.critical_points.size(), 1u);
  // Midway between outline and tip, t = sqrt(2) (0.9 - t); the node before the tip would stop it at 0.494.
  const double t = 0.9 * std::sqrt(2.0) / (1 + std::sqrt(2.0));
  EXPECT_TRUE(has_node_at(points, {t, t}, 3, 1e-6)) << points.critical_points[0].position.x;
}

TEST(RulePairs, CancelBeforeMerge_ABoundaryNodeThatCancelsIsNotMerged) {
  // Both nodes of a slot's end move onto it, 0.17 apart. Only then one of them is near its opposite.
  const CadFace face = plate(4, {window({-1, -0.1}, {1, 0.1}, 0.05)});
  const Vec2 out_up = unit(pi / 4), out_low = unit(-pi / 4);
  const Vec2 up = Vec2{0.95, 0.05} + 0.05 * out_up, low = Vec2{0.95, -0.05} + 0.05 * out_low;
  const Vec2 before_up = up + 0.3 * out_up - 0.2 * left_of(out_up), before_low = low + 0.3 * out_low;
  const Vec2 other = up + 0.02 * out_up + 0.14 * left_of(out_up);
  ASSERT_GT(std::min(distance(before_up, other), distance(before_low, other)), 0.4);
  ASSERT_LT(std::max(distance(up, other), distance(up, low)), 0.2);
  const CriticalPoints points = resolved(face, {node(before_up, 5), node(before_low, 5), node(other, 3)}, 0.4);
  EXPECT_TRUE(points.critical_points.empty());
  ASSERT_EQ(points.boundary_nodes.size(), 1u);
  EXPECT_TRUE(has_boundary_node_at(points, low, 3, 1e-9));
}

TEST(RulePairs, CornerAndMerge_NodesBesideACornerThatTookANodeAreMergedButNotAcrossIt) {
  const double s = 0.1;
  const CadFace face = plate(2, {filleted({{-s, 0}, {0, s * std::sqrt(3.0)}, {s, 0}}, {0, 0, 0})});
  const int before_tip = 4, behind_tip = 5;  // curves of the hole, each 0.2 long
  const auto resolved_with = [&](int curve, double t) {
    CriticalPoints points = points_with(face, {node({0, 0.25}, 5)});
    for (const auto& [c, u] : {std::pair{curve, t}, {behind_tip, 0.03}})
      points.boundary_nodes.push_back({c, u, curve::point(face.curves[c], u), 3});
    resolve_features(face, 0.5, points);
    EXPECT_TRUE(points.critical_points.empty());
    EXPECT_EQ(std::count_if(points.corners.begin(), points.corners.end(),
                            [](const Corner& corner) { return corner.source == NodeSource::feature; }),
              1);
    return points;
  };
  const CriticalPoints beside = resolved_with(behind_tip, 0.08);
  ASSERT_EQ(beside.boundary_nodes.size(), 1u);
  EXPECT_TRUE(has_boundary_node_at(beside, curve::point(face.curves[behind_tip], 0.055), 4, 1e-12));
  const CriticalPoints across = resolved_with(before_tip, 0.17);
  ASSERT_EQ(across.boundary_nodes.size(), 2u);
  for (const IrregularBoundaryPoint& b : across.boundary_nodes) EXPECT_EQ(b.valence, 3);
}

}  // namespace
}  // namespace quadrille::features
