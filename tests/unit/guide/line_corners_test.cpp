#include "guide/line_corners.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"

namespace quadrille::guide {
namespace {

using namespace testing_faces;

LineCorners corners_of(const CadFace& face) { return line_corners(face, curve::symmetries(face)); }

std::vector<int> valences(const LineCorners& chosen) {
  std::vector<int> list;
  for (const Corner& c : chosen.corners) list.push_back(c.valence);
  return list;
}

int index_of(const LineCorners& chosen) {
  int sum = 0;
  for (const Corner& c : chosen.corners) sum += 2 - c.valence;
  return sum;
}

TEST(LineCorners, OfARectangleAreRightAnglesAndNoTies) {
  const LineCorners chosen = corners_of(make_face({polygon({{0, 0}, {2, 0}, {2, 1}, {0, 1}})}));
  EXPECT_EQ(valences(chosen), (std::vector<int>{1, 1, 1, 1}));
  EXPECT_EQ(chosen.missing_index, 0);
  for (const Corner& c : chosen.corners) EXPECT_EQ(c.source, NodeSource::angle);
}

TEST(LineCorners, OfOneChamferTakeOneOfBothAtItsEnds) {
  // Three right angles leave index 1 for the two corners of 135 degrees: one takes valence 1, where sides are longest.
  const LineCorners chosen = corners_of(make_face({polygon({{0, 0}, {4, 0}, {4, 0.5}, {3.5, 1}, {0, 1}})}));
  EXPECT_EQ(chosen.missing_index, 0);
  EXPECT_EQ(index_of(chosen), 4);
  EXPECT_EQ(valences(chosen), (std::vector<int>{1, 1, 2, 1, 1}));  // at (3.5, 1): the side of length 3.5 is longer
  EXPECT_EQ(chosen.corners[3].source, NodeSource::line);
}

TEST(LineCorners, DecideMirrorImagesTogetherAndReportWhatIsMissing) {
  // The mirror image of the first chamfer's end is its other end: both or none.
  const LineCorners both = corners_of(make_face({polygon({{0, 0}, {1, 0}, {1, 0.7}, {0.7, 1}, {0, 1}})}));
  EXPECT_EQ(both.missing_index, 1);
  EXPECT_EQ(valences(both), (std::vector<int>{1, 1, 2, 2, 1}));
}

TEST(LineCorners, TakeTheLargerValenceAt45Degrees) {
  const LineCorners chosen = corners_of(make_face({polygon({{0, 0}, {2, 0}, {0, 2}})}));
  EXPECT_EQ(valences(chosen), (std::vector<int>{1, 1, 1}));
  EXPECT_EQ(chosen.missing_index, 1);  // a node of valence 3 inside
}

}  // namespace
}  // namespace quadrille::guide
