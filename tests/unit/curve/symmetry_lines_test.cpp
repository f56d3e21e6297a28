#include "curve/symmetry_lines.hpp"

#include <gtest/gtest.h>

#include "../chart_samples.hpp"
#include "../triangulate/faces.hpp"

namespace quadrille::curve {

namespace {

using namespace testing_faces;

/// The face above the x axis between x = -4 and 6, around half a disc of radius 1 and half a square around (3, 0).
CadFace half_channel() {
  Loop loop{segment({-4, 0}, {-1, 0}), circular_arc({0, 0}, 1, pi, 0), segment({1, 0}, {2, 0})};
  const std::vector<Vec2> rest{{2, 0}, {2, 1}, {4, 1}, {4, 0}, {6, 0}, {6, 3}, {-4, 3}};
  for (std::size_t i = 0; i < rest.size(); ++i)
    loop.push_back(segment(rest[i], i + 1 < rest.size() ? rest[i + 1] : Vec2{-4, 0}));
  CadFace face = make_face({loop});
  for (int c = 0; c < face.num_curves(); ++c) face.curve_names[c] = "wall";
  for (const int c : {0, 2, 6}) face.curve_names[c] = "symmetry";
  return face;
}

SymmetryLines lines_of(const CadFace& face) { return symmetry_lines(face, curves_that_fit(face, {"symmetry*"})); }

TEST(SymmetryLines, CurvesOnOneLineMakeAHalf) {
  const SymmetryLines found = lines_of(half_channel());
  EXPECT_TRUE(is_part_of_whole(found.lines));
  ASSERT_EQ(found.lines.size(), 1U);
  EXPECT_EQ(found.lines[0].curves, (std::vector<int>{0, 2, 6}));
  EXPECT_NEAR(found.lines[0].height({7, 2}), 2, 1e-15);
  EXPECT_NEAR(distance(found.lines[0]({7, 2}), {7, -2}), 0, 1e-14);
}

TEST(SymmetryLines, LinesAtRightAnglesMakeAQuarterParallelOnesNothing) {
  CadFace face = square();
  const auto count = [&](int a, int b) {
    face.curve_names.assign(4, "wall");
    face.curve_names[a] = face.curve_names[b] = "symmetry";
    const SymmetryLines found = lines_of(face);
    EXPECT_TRUE(found.fault.empty());
    EXPECT_EQ(found.lines.size(), 2U);
    return is_part_of_whole(found.lines);
  };
  EXPECT_TRUE(count(0, 1));
  EXPECT_FALSE(count(0, 2));
  EXPECT_FALSE(is_part_of_whole({}));
}

TEST(SymmetryLines, BentCurvesAndLinesInsideTheFaceAreFaults) {
  CadFace disc = half_disc();
  disc.curve_names = {"wall", "symmetry"};
  EXPECT_EQ(lines_of(disc).fault,
            "curve 1 \"symmetry\" is not straight: at (0, 1) it is 1 off the line between its ends");
  CadFace round = make_face({circle({0, 0}, 1)});
  round.curve_names = {"symmetry"};
  EXPECT_FALSE(lines_of(round).fault.empty());
  CadFace l = l_shape();
  l.curve_names.assign(6, "wall");
  l.curve_names[2] = "symmetry";
  EXPECT_EQ(lines_of(l).fault,
            "the face lies on both sides of curve 2 \"symmetry\": at (1, 2) it is 1 beyond its line");
}

/// The joints follow from the curves as in any face.
void expect_joints(const CadFace& face) {
  for (int c = 0; c < face.num_curves(); ++c) {
    const Joint expected = make_joint(face, c);
    EXPECT_NEAR(distance(face.joints[c].position, expected.position), 0, 1e-12) << c;
    EXPECT_NEAR(distance(face.curves[face.previous_in_loop(c)].poles.back(), expected.position), 0, 1e-12) << c;
    EXPECT_NEAR(wrap_pi(face.joints[c].tangent_in - expected.tangent_in), 0, 1e-9) << c;
    EXPECT_NEAR(wrap_pi(face.joints[c].tangent_out - expected.tangent_out), 0, 1e-9) << c;
    EXPECT_NEAR(face.joints[c].interior_angle, expected.interior_angle, 1e-9) << c;
    EXPECT_EQ(face.joints[c].is_corner, expected.is_corner) << c;
  }
}

TEST(MirroredFace, BodiesOnTheLineAreHolesOfTheWhole) {
  const CadFace half = half_channel();
  const MirroredFace mirrored = mirrored_face(half, lines_of(half).lines[0]);
  const CadFace& whole = mirrored.whole;
  EXPECT_EQ(whole.loop_offsets, (std::vector<int>{0, 6, 8, 14}));
  EXPECT_EQ(mirrored.copy, (std::vector<int>{-1, 6, -1, 8, 9, 10, -1, 0, 1, 2}));
  EXPECT_EQ(mirrored.image, (std::vector<int>{-1, 7, -1, 13, 12, 11, -1, 5, 4, 3}));
  expect_joints(whole);
  EXPECT_FALSE(whole.joints[6].is_corner) << "the disc meets the line at a right angle";
  EXPECT_NEAR(whole.diameter, std::hypot(10, 6), 1e-12);
  EXPECT_EQ(whole.curve_names, std::vector<std::string>(14, "wall"));
}

TEST(MirroredFace, HolesOffTheLineHaveAnImageAndEdgesOnItACornerOfTwiceTheAngle) {
  const CadFace half = make_face({polygon({{0, 0}, {4, 0}, {2, 2}}), hole({2, 0.7}, 0.2)});
  const CadFace whole = mirrored_face(half, {{0, 0}, {1, 0}, {0}}).whole;
  EXPECT_EQ(whole.loop_offsets, (std::vector<int>{0, 4, 5, 6}));
  expect_joints(whole);
  EXPECT_NEAR(whole.joints[0].interior_angle, half_pi, 1e-12);
}

TEST(MirroredFace, CurvesInSpaceKeepTheirNumbers) {
  CadFace half = samples::sphere_face();
  half.curve_names[0] = "symmetry";
  const std::vector<SymmetryLine> lines = symmetry_lines(half, {0}).lines;
  ASSERT_EQ(lines.size(), 1u);
  const MirroredFace mirrored = mirrored_face(half, lines.front());
  const std::vector<SpaceCurve>&of_half = half.chart->space_curves, &of_whole = mirrored.whole.chart->space_curves;
  ASSERT_EQ(of_whole.size(), mirrored.whole.curves.size());
  for (int c = 1; c < half.num_curves(); ++c) {
    EXPECT_EQ(of_whole[mirrored.copy[c]].poles, of_half[c].poles);
    EXPECT_EQ(of_whole[mirrored.image[c]].poles.front(), of_half[c].poles.back());
  }
}

TEST(MirroredFace, ALineInAnyDirection) {
  const CadFace half = moved(half_channel(), 2, 2.5, {3, -7});
  const MirroredFace mirrored = mirrored_face(half, symmetry_lines(half, {0, 2, 6}).lines[0]);
  expect_joints(mirrored.whole);
  EXPECT_EQ(mirrored.whole.num_loops(), 3);
}

TEST(MirroredFace, TheWholeOfAQuarterIsMirroredTwice) {
  CadFace quarter = square();
  quarter.curve_names = {"symmetry_x", "wall", "wall", "symmetry_y"};
  const CadFace whole = whole_of(quarter, {"symmetry*"});
  EXPECT_EQ(whole.num_curves(), 8);
  EXPECT_NEAR(whole.diameter, std::sqrt(8), 1e-12);
  expect_joints(whole);
  EXPECT_EQ(whole_of(quarter, {}).num_curves(), 4);
}

}  // namespace

}  // namespace quadrille::curve
