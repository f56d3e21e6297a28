#include "topology/grid_kind.hpp"

#include <gtest/gtest.h>

#include "../support/critical_points.hpp"
#include "base/error.hpp"
#include "far_field_faces.hpp"
#include "topology/apply_topology.hpp"

namespace quadrille::topology {
namespace {

using namespace testing_faces;

TEST(GridKind, OfAFarFieldFollowsFromItsCorners) {
  EXPECT_EQ(kind_of_outline(in_far_field(make_face({c_outline(), sharp_body()}))), GridKind::c);
  EXPECT_EQ(kind_of_outline(in_far_field(make_face({circle({0, 0}, 8), sharp_body()}))), GridKind::o);
  EXPECT_EQ(kind_of_outline(in_far_field(make_face({box(), sharp_body()}))), GridKind::h);
  EXPECT_EQ(kind_of_outline(in_far_field(make_face({polygon({{-8, -8}, {8, -8}, {0, 8}}), sharp_body()}))),
            GridKind::none);
}

TEST(GridKind, OtherGridsAreThoseThatTheOutlineDoesNotMean) {
  using Kinds = std::vector<GridKind>;
  EXPECT_EQ(other_grids(in_far_field(make_face({box(), sharp_body()}))), (Kinds{GridKind::c, GridKind::o}));
  EXPECT_EQ(other_grids(in_far_field(make_face({c_outline(), sharp_body()}))), (Kinds{GridKind::h, GridKind::o}));
  EXPECT_TRUE(other_grids(make_face({box(), sharp_body()})).empty()) << "no far field";
}

TEST(GridKind, ACircleAroundTwoBodiesMeansNoOGrid) {
  const auto second = polygon({{3, 3}, {3.5, 4}, {4, 3}});
  EXPECT_EQ(kind_of_outline(in_far_field(make_face({circle({0, 0}, 8), sharp_body(), second}))), GridKind::none);
  EXPECT_EQ(kind_of_outline(in_far_field(make_face({c_outline(), sharp_body(), second}))), GridKind::c);
}

TEST(GridKind, IsNoneWithoutAHoleOrWithAnotherName) {
  EXPECT_EQ(kind_of_outline(in_far_field(square())), GridKind::none);
  CadFace face = in_far_field(make_face({c_outline(), sharp_body()}));
  face.curve_names[1] = "outlet";
  EXPECT_EQ(kind_of_outline(face), GridKind::none);
  EXPECT_THROW(require_holes(square(), GridKind::o), UsageError);
  EXPECT_NO_THROW(require_holes(square(), GridKind::by_outline));
  EXPECT_NO_THROW(require_holes(face, GridKind::c));
}

TEST(GridKind, TheWakePointsAwayFromTheSharpestCorner) {
  EXPECT_NEAR(distance(downstream(make_face({box(), sharp_body()})), {1, 0}), 0, 1e-12);
  EXPECT_NEAR(distance(downstream(make_face({box(), blunt_body()})), {1, 0}), 0, 1e-12);
  const CadFace turned = moved(make_face({box(), sharp_body()}), 1, 1.0, {0, 0});
  EXPECT_NEAR(distance(downstream(turned), unit(1.0)), 0, 1e-12);
  EXPECT_NEAR(distance(downstream(annulus()), {1, 0}), 0, 1e-12);
}

/// The changed valences, corner by corner; 0 where nothing changes.
std::vector<int> changed(const CadFace& face, GridKind kind) {
  std::vector<int> valences(face.num_curves(), 0);
  for (const guide::CornerOverride& o : grid_corners(face, kind, hand_made::points_of(face)))
    valences[o.curve_b] = o.valence;
  return valences;
}

TEST(GridKind, ACGridTurnsTheUpstreamCornersOfABox) {
  EXPECT_EQ(changed(make_face({box(), sharp_body()}), GridKind::c), (std::vector<int>{2, 0, 0, 2, 0, 0, 0}));
  EXPECT_EQ(changed(make_face({c_outline(), sharp_body()}), GridKind::c), (std::vector<int>{0, 0, 0, 0, 0, 0, 0}));
}

/// A blunt body with a round front, turned by an angle around the front; the tail is cut obliquely.
Loop turned_body(double angle, double skew) {
  std::vector<Vec2> points;
  for (const Vec2 p : {Vec2{1 + skew, 0.01}, Vec2{1 - skew, -0.01}, Vec2{0, -0.2}, Vec2{0, 0.2}})
    points.push_back(p.x * unit(angle) + p.y * unit(angle + half_pi));
  Loop body = polygon(points);
  body[2] = curve::circular_arc({0, 0}, 0.2, angle - half_pi, angle - 3 * half_pi);
  return body;
}

TEST(GridKind, BothOutflowCornersOfACGridKeepTheirBlocksBehindABodyAtIncidence) {
  // Corners of an oblique tail differ; the sharper of them points past a corner of the outline.
  for (const double angle : {-0.26, 0.0, 0.26})
    for (const double skew : {-0.001, 0.001}) {
      const Loop body = turned_body(angle, skew);
      EXPECT_EQ(changed(make_face({c_outline(), body}), GridKind::c), std::vector<int>(8, 0)) << angle << " " << skew;
      EXPECT_EQ(changed(make_face({box(), body}), GridKind::c), (std::vector<int>{2, 0, 0, 2, 0, 0, 0, 0}))
          << angle << " " << skew;
    }
}

TEST(GridKind, TheOutflowIsSeenFromTheCentreOfTheOutline) {
  // A body at an incidence of 11 degrees, 1 before the outflow.
  const Loop body = polygon({{7, -0.2}, {6, -0.1}, {6, 0.1}});
  EXPECT_EQ(changed(make_face({box(), body}), GridKind::c), (std::vector<int>{2, 0, 0, 2, 0, 0, 0}));
}

TEST(GridKind, ASquareBodyHasItsWakeInTheDirectionOfX) {
  const Loop body = polygon({{1, -1}, {-1, -1}, {-1, 1.001}, {1, 1}});
  EXPECT_NEAR(distance(downstream(make_face({box(), body})), {1, 0}), 0, 1e-12);
}

TEST(GridKind, AnOGridTurnsAllCornersAndNeedsTheFewestBlocksAtTheBody) {
  // The front corners of 281 degrees have 2 blocks, the tail of 338 degrees has 3.
  EXPECT_EQ(changed(make_face({box(), wedge()}), GridKind::o), (std::vector<int>{2, 2, 2, 2, 3, 2, 2}));
  EXPECT_EQ(changed(make_face({circle({0, 0}, 8), blunt_body()}), GridKind::o), (std::vector<int>{0, 2, 2, 0, 0}));
}

TEST(GridKind, ASlitJoinsTheBodyToTheOutline) {
  // The outline runs along the slit to the body, around it and back: only its curves called farfield count.
  Loop loop = c_outline();
  loop[1] = curve::segment({9, -8}, {9, 0});
  const Nurbs slit = curve::segment({9, 0}, {1, 0});
  const Loop body = sharp_body();
  Loop joined{loop[0], loop[1], slit, body[0], body[1], body[2], curve::reversed(slit), curve::segment({9, 0}, {9, 8})};
  joined.insert(joined.end(), {loop[2], loop[3]});
  CadFace face = make_face({joined});
  for (const int c : {0, 1, 7, 8, 9}) face.curve_names[c] = "farfield";
  EXPECT_EQ(kind_of_outline(face), GridKind::none);
  face.partners.assign(face.num_curves(), -1);
  face.partners[2] = 6;
  face.partners[6] = 2;
  EXPECT_EQ(kind_of_outline(face), GridKind::c);
  EXPECT_NO_THROW(require_holes(face, GridKind::c));
  EXPECT_TRUE(grid_corners(face, GridKind::c, hand_made::points_of(face)).empty());
}

TEST(GridKind, AnHGridChangesNothing) {
  EXPECT_EQ(changed(make_face({box(), sharp_body()}), GridKind::h), std::vector<int>(7, 0));
}

TEST(GridKind, PrescribedCornersStay) {
  const CadFace face = make_face({box(), sharp_body()});
  CriticalPoints points = hand_made::points_of(face);
  for (Corner& c : points.corners) c.source = NodeSource::corner;
  EXPECT_TRUE(grid_corners(face, GridKind::o, points).empty());
}

using namespace testing_faces;

/// Clockwise: a body from (0, 0) to (width, 1).
Loop block_body(double width) { return polygon({{0, 0}, {0, 1}, {width, 1}, {width, 0}}); }

/// Between a body and the curve at the distance 0.2 from it.
CadFace ring(double width) {
  CadFace face =
      make_face({polygon({{-0.2, -0.2}, {width + 0.2, -0.2}, {width + 0.2, 1.2}, {-0.2, 1.2}}), block_body(width)});
  for (int c = 0; c < 8; ++c) face.curve_names[c] = c < 4 ? "body_offset" : "body";
  return face;
}

TEST(LayerCorners, CloseAroundABodyWithOneLineAtEachCorner) {
  const CadFace face = ring(1);
  CriticalPoints points = hand_made::points_of(face);
  EXPECT_EQ(closed_layer_corners(face, points).size(), 8U);
  EXPECT_TRUE(apply_topology(face, {.layer_corners = LayerCorners::close}, points));
  for (const Corner& c : points.corners) EXPECT_EQ(c.valence, 2);
  EXPECT_TRUE(points.critical_points.empty());
  EXPECT_EQ(index_sum_of(points), 0);
  hand_made::expect_sound_changes(points.changes);
}

TEST(LayerCorners, PassTheCornersOfABodyByDefault) {
  const CadFace face = ring(1);
  CriticalPoints points = hand_made::points_of(face);
  apply_topology(face, {}, points);
  for (const Corner& c : points.corners) EXPECT_EQ(c.valence, face.loop_of(c.joint) == 0 ? 1 : 3);
}

TEST(LayerCorners, KeepRightAnglesAroundAShortSide) {
  const CadFace face = ring(0.2);  // shorter than from corner to corner, 0.2 sqrt(2)
  EXPECT_TRUE(closed_layer_corners(face, hand_made::points_of(face)).empty());
}

TEST(LayerCorners, OfOpenWallsAndPrescribedOnesStay) {
  CadFace face = ring(1);
  CriticalPoints points = hand_made::points_of(face);
  for (Corner& c : points.corners)
    if (c.joint == 4) c.source = NodeSource::corner;
  EXPECT_EQ(closed_layer_corners(face, points).size(), 6U);
  face.curve_names[4] = "symmetry";
  EXPECT_TRUE(closed_layer_corners(face, hand_made::points_of(face)).empty()) << "the wall is no loop";
}

TEST(LayerCorners, CloseByDefaultAroundSeveralBodies) {
  const CadFace one = make_face({box(), block_body(1)});
  const CadFace two = make_face({box(), block_body(1), polygon({{3, 3}, {3.5, 4}, {4, 3}})});
  EXPECT_EQ(layer_corners(one, LayerCorners::by_bodies), LayerCorners::pass);
  EXPECT_EQ(layer_corners(two, LayerCorners::by_bodies), LayerCorners::close);
  EXPECT_EQ(layer_corners(one, LayerCorners::close), LayerCorners::close);
  EXPECT_EQ(layer_corners(two, LayerCorners::pass), LayerCorners::pass);
}

TEST(LayerCorners, KindsOfGridAreNotOfRegionsWithLayers) {
  const CadFace face = ring(1);
  CriticalPoints points = hand_made::points_of(face);
  apply_topology(face, {.grid = GridKind::c}, points);
  for (const Corner& c : points.corners) EXPECT_EQ(c.valence, face.loop_of(c.joint) == 0 ? 1 : 3);
  apply_topology(face, {.grid = GridKind::o}, points);
  for (const Corner& c : points.corners) EXPECT_EQ(c.valence, 2) << "an O-grid closes layers too";
}

}  // namespace
}  // namespace quadrille::topology
