#include "couple/rotate_circular_regions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "curve/chain.hpp"
#include "rectangles.hpp"

namespace quadrille::couple {
namespace {

/// Four ends at right angles, from `first` on.
std::vector<double> cross_from(double first) { return {first, first + pi / 2, first + pi, first - pi / 2}; }

double quarter(double angle) {
  const double turned = std::fmod(angle, pi / 2);
  return turned < 0 ? turned + pi / 2 : turned;
}

TEST(BestRotation, WithoutNeighboursNothingTurns) { EXPECT_EQ(best_rotation({{cross_from(0.3), {}}}), 0); }

TEST(BestRotation, BringsEachEndToTheNearestOther) {
  EXPECT_NEAR(best_rotation({{cross_from(0.3), cross_from(0.5)}}), 0.2, 1e-12);
  EXPECT_NEAR(best_rotation({{cross_from(0.3), cross_from(0.2)}}), -0.1, 1e-12);
}

TEST(BestRotation, LoopsAreDecidedTogether) {
  EXPECT_NEAR(best_rotation({{cross_from(0), cross_from(0.1)}, {cross_from(0), cross_from(0.3)}}), 0.2, 1e-12);
}

// Two lines at equal angles from the axis x: an end on either is as good as on the other, one on the axis symmetric.
TEST(BestRotation, NeighboursThatAreSymmetricGetASymmetricTurn) {
  for (const double own : {0.0, 0.1, 0.35, 0.7, 1.2})
    for (const double half : {0.2, 0.3, 0.5}) {
      const double turn = best_rotation({{cross_from(own), {half, -half}}});
      const double end = quarter(own + turn);
      EXPECT_TRUE(std::min(end, pi / 2 - end) < 1e-9 || std::abs(end - pi / 4) < 1e-9) << own << ", " << half;
    }
}

// Five lines that are symmetric about an axis, as those of a wall that three round regions share.
TEST(BestRotation, DependsOnNothingButTheNeighbours) {
  const std::vector<double> others{pi, 0.8, -0.8, 2.1, -2.1};
  const double first = quarter(best_rotation({{cross_from(0), others}}));
  for (const double own : {0.05, 0.4, 0.8, 1.5}) {
    const double end = quarter(own + best_rotation({{cross_from(own), others}}));
    EXPECT_LT(std::min(std::abs(end - first), pi / 2 - std::abs(end - first)), 1e-9) << own;
  }
}

using namespace testing_faces;

/// The parameter at an angle of the only curve of a loop, a unit circle from the angle 0.
double parameter(const CadFace& face, int curve, double angle) {
  const double along = face.curves[curve].poles[1].y > 0 ? angle : 2 * pi - angle;
  return curve::ArcLength(face.curves[curve]).parameter(along);
}

/// Five blocks: four lines from the circle, from the angle `first` on, to the corners of a block in the middle.
SeparatrixGraph disc_layout(const CadFace& face, double first) {
  SeparatrixGraph g;
  g.face = face;
  for (int k = 0; k < 4; ++k) hand_made::add_boundary_node(g, 0, parameter(face, 0, first + k * half_pi));
  for (int k = 0; k < 4; ++k) hand_made::add_node(g, 0.5 * unit(first + k * half_pi), NodeKind::irregular, 3);
  for (int k = 0; k < 4; ++k) {
    const double t0 = g.nodes[k].t, t1 = g.nodes[(k + 1) % 4].t, begin = face.curves[0].begin();
    std::vector<ArcPiece> pieces{{0, t0, t1 > t0 ? t1 : face.curves[0].end()}};
    if (t1 < t0) pieces.push_back({0, begin, t1});
    hand_made::add_arc(g, k, (k + 1) % 4, true, pieces);
  }
  for (int k = 0; k < 4; ++k) {
    g.lines.push_back({4 + k, k, LineKind::traced, {hand_made::add_cut(g, 4 + k, k)}});
    g.lines.push_back({4 + k, 4 + (k + 1) % 4, LineKind::traced, {hand_made::add_cut(g, 4 + k, 4 + (k + 1) % 4)}});
  }
  return g;
}

/// Four blocks: lines from the corners of the square to the hole.
SeparatrixGraph frame_layout(const CadFace& face) {
  SeparatrixGraph g;
  g.face = face;
  for (int j = 0; j < 4; ++j) hand_made::add_joint_node(g, j, 2);
  const std::vector<double> angles{1.25 * pi, 1.75 * pi, 0.25 * pi, 0.75 * pi};
  for (const double angle : angles) hand_made::add_boundary_node(g, 4, parameter(face, 4, angle));
  for (int j = 0; j < 4; ++j) hand_made::add_arc(g, j, (j + 1) % 4, true, {hand_made::whole(g, j)});
  for (int j = 0; j < 4; ++j) {  // the hole runs clockwise
    const int from = 4 + (j + 1) % 4, to = 4 + j;
    const double t0 = g.nodes[from].t, t1 = g.nodes[to].t, begin = face.curves[4].begin();
    std::vector<ArcPiece> pieces{{4, t0, t1 > t0 ? t1 : face.curves[4].end()}};
    if (t1 < t0) pieces.push_back({4, begin, t1});
    hand_made::add_arc(g, from, to, true, pieces);
  }
  for (int j = 0; j < 4; ++j) g.lines.push_back({j, 4 + j, LineKind::traced, {hand_made::add_cut(g, j, 4 + j)}});
  return g;
}

RegionLayouts disc_in_frame(double first) {
  RegionLayouts regions;
  regions.face = disc_in_square();
  const std::vector<CadFace> faces = regions::split(regions.face);
  regions.layouts.push_back(graph::candidate_layout(frame_layout(faces[0])));
  regions.layouts.push_back(graph::candidate_layout(disc_layout(faces[1], first)));
  regions.first_curves = {0, 5};
  return regions;
}

TEST(RotateCircularRegions, BringsLineEndsToThoseOfTheNeighbour) {
  RegionLayouts regions = disc_in_frame(0.6);
  EXPECT_EQ(rotate_circular_regions(regions), 1);
  EXPECT_NEAR(regions.rotations[1].angle, pi / 4 - 0.6, 1e-9);
  EXPECT_EQ(regions.rotations[0].angle, 0) << "a square is not circular";
  const ArcGraph& disc = regions.layouts[1].graph();
  for (int k = 0; k < 4; ++k) {
    EXPECT_NEAR(distance(disc.nodes[k].position, unit(pi / 4 + k * half_pi)), 0, 1e-9);
    EXPECT_NEAR(distance(curve::point(disc.face.curves[0], disc.nodes[k].t), disc.nodes[k].position), 0, 1e-9);
    EXPECT_NEAR(distance(disc.nodes[4 + k].position, 0.5 * unit(pi / 4 + k * half_pi)), 0, 1e-9);
  }
  EXPECT_EQ(regions.layouts[1].subdivision.num_faces(), 5);
}

TEST(RotateCircularRegions, LinesThatMeetStay) {
  RegionLayouts regions = disc_in_frame(pi / 4);
  rotate_circular_regions(regions);
  EXPECT_NEAR(regions.rotations[1].angle, 0, 1e-9);
}

TEST(RotateCircularRegions, OneRegionIsNotRotated) {
  RegionLayouts one;
  one.face = make_face({circle({0, 0}, 1)});
  one.layouts.push_back(graph::candidate_layout(disc_layout(one.face, 0.6)));
  one.first_curves = {0};
  EXPECT_EQ(rotate_circular_regions(one), 0);
  EXPECT_NEAR(distance(one.layouts[0].graph().nodes[0].position, unit(0.6)), 0, 1e-9);
}

}  // namespace
}  // namespace quadrille::couple
