// resolve_features on faces made by hand, with nodes where small features put them (lib/method.md §5): a convex right
// angle of radius r has its node of valence 3 at 0.312 r from the arc, a reflex one its node of valence 5 at 0.407 r.
#include "features/resolve_features.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "../hand_made.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "features/feature_bends.hpp"

namespace quadrille::features {
namespace {

constexpr double convex_depth = 0.312, reflex_depth = 0.407;

using Loop = std::vector<Nurbs>;

/// A polygon in its own sequence (holes clockwise) with fillets of these radii; 0: a sharp corner.
Loop filleted(const std::vector<Vec2>& corners, const std::vector<double>& radii) {
  const size_t n = corners.size();
  std::vector<Vec2> before(n), after(n);
  std::vector<Nurbs> arcs(n);
  for (size_t i = 0; i < n; ++i) {
    const Vec2 in = normalized(corners[i] - corners[(i + n - 1) % n]),
               out = normalized(corners[(i + 1) % n] - corners[i]);
    const double turn = std::atan2(cross(in, out), dot(in, out)), cut = radii[i] * std::tan(std::abs(turn) / 2);
    before[i] = corners[i] - cut * in;
    after[i] = corners[i] + cut * out;
    if (radii[i] == 0) continue;
    const double side = turn > 0 ? 1 : -1, start = angle_of(in) - side * half_pi;
    arcs[i] = curve::circular_arc(before[i] + side * radii[i] * left_of(in), radii[i], start, start + turn);
  }
  Loop loop;
  for (size_t i = 0; i < n; ++i) {
    if (radii[i] > 0) loop.push_back(arcs[i]);
    loop.push_back(curve::segment(after[i], before[(i + 1) % n]));
  }
  return loop;
}

Loop rectangle(Vec2 low, Vec2 high, double radius) {
  return filleted({low, {high.x, low.y}, high, {low.x, high.y}}, {radius, radius, radius, radius});
}

Loop window(Vec2 low, Vec2 high, double radius) {
  return filleted({low, {low.x, high.y}, high, {high.x, low.y}}, {radius, radius, radius, radius});
}

CriticalPoint node(Vec2 at, int valence) {
  CriticalPoint p;
  p.position = at;
  p.valence = valence;
  p.index = 4 - valence;
  p.jacobian = {1, 0, 0, static_cast<double>(p.index)};
  p.error = 1e-9;
  return p;
}

CriticalPoints points_with(const CadFace& face, const std::vector<CriticalPoint>& nodes) {
  CriticalPoints points;
  points.critical_points = nodes;
  for (int j = 0; j < face.num_curves(); ++j) {
    const Joint& joint = face.joints[j];
    if (joint.is_corner)
      points.corners.push_back({j,
                                joint.position,
                                degrees(joint.interior_angle),
                                static_cast<int>(std::lround(joint.interior_angle / half_pi)),
                                {face.previous_in_loop(j), j}});
  }
  points.index_sum = index_sum_of(points);
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
  for (const NodeChange& change : points.changes) {
    const auto sum = [](const std::vector<NodeMark>& marks) {
      int total = 0;
      for (const NodeMark& m : marks) total += (m.location == NodeLocation::inside ? 4 : 2) - m.valence;
      return total;
    };
    EXPECT_EQ(sum(change.before), sum(change.after)) << change.reason;
    EXPECT_FALSE(change.reason.empty());
  }
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

TEST(SmallFeatures, CountsWhatARunCarries) {
  const CadFace face =
      hand_made::face({filleted({{0, 0}, {4, 0}, {4, 2}, {0, 2}}, {0.1, 0.2, 0, 1.0})}, std::sqrt(20.0));
  const std::vector<SmallFeature> small = small_features(face, 0.5);
  ASSERT_EQ(small.size(), 2u);
  EXPECT_EQ(small[0].kind, FeatureKind::convex);
  EXPECT_NEAR(small[0].extent, 0.1, 1e-12);
  EXPECT_EQ(small[0].capacity, 1);
  EXPECT_NEAR(small[1].stretch.length(), 0.1 * pi, 1e-12);
  EXPECT_EQ(small_features(face, 0.2).size(), 1u);  // 0.2 is not below 0.2
  // Half circles at the ends of a slot carry two each; a circle is a hole or nothing.
  const Loop slot{curve::circular_arc({1, 0}, 0.3, half_pi, -half_pi), curve::segment({1, -0.3}, {-1, -0.3}),
                  curve::circular_arc({-1, 0}, 0.3, -half_pi, -3 * half_pi), curve::segment({-1, 0.3}, {1, 0.3})};
  const CadFace plate = hand_made::face(
      {rectangle({-4, -4}, {4, 4}, 0), slot, {curve::circular_arc({0, 2}, 0.3, 0, -2 * pi)}}, std::sqrt(128.0));
  const std::vector<SmallFeature> ends = small_features(plate, 0.4);
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_EQ(ends[0].kind, FeatureKind::reflex);
  EXPECT_EQ(ends[0].capacity, 2);
  const std::vector<SmallFeature> with_hole = small_features(plate, 0.7);
  ASSERT_EQ(with_hole.size(), 3u);
  EXPECT_EQ(with_hole[2].kind, FeatureKind::hole);
  EXPECT_NEAR(with_hole[2].extent, 0.6, 1e-6);
  EXPECT_EQ(with_hole[2].capacity, 4);
  // A small ellipse is one hole, whatever its ends.
  Loop ellipse{curve::circular_arc({0, 0}, 1, 0, -2 * pi)};
  for (Vec2& pole : ellipse[0].poles) pole.y *= 0.3;
  const CadFace with_ellipse = hand_made::face({rectangle({-9, -9}, {9, 9}, 0), ellipse}, std::sqrt(648.0));
  EXPECT_EQ(small_features(with_ellipse, 1).size(), 2u);
  ASSERT_EQ(small_features(with_ellipse, 2.1).size(), 1u);
  EXPECT_EQ(small_features(with_ellipse, 2.1)[0].kind, FeatureKind::hole);
}

}  // namespace
}  // namespace quadrille::features
