#include "topology/layer_corners.hpp"

#include <gtest/gtest.h>

#include "../support/critical_points.hpp"
#include "far_field_faces.hpp"
#include "topology/apply_topology.hpp"

namespace quadrille::topology {
namespace {

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
