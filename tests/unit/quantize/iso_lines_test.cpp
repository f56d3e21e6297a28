#include "quantize/iso_lines.hpp"

#include <gtest/gtest.h>

#include "t_faces.hpp"

namespace quadrille::quantize {
namespace {

using Numbers = std::set<int>;

ArcGraph arcs(int num, const std::set<int>& inner) {
  ArcGraph graph;
  graph.arcs.resize(num);
  for (int a = 0; a < num; ++a) graph.arcs[a].is_boundary = !inner.contains(a);
  return graph;
}

int num_lines(const IsoLines& lines) {
  std::size_t sum = 0;
  for (const auto& of_face : lines.lines) sum += of_face[0].size() + of_face[1].size();
  return static_cast<int>(sum);
}

TEST(IsoLines, WithoutTJunctionsThereAreNone) {
  const std::vector<TFace> faces{face({{{0}, {1}, {2}, {3}}})};
  const std::vector<int> lengths{3, 2, 3, 2};
  const IsoLines lines = iso_lines(arcs(4, {}), IntegerSides(faces, lengths));
  EXPECT_EQ(num_lines(lines), 0);
  for (const Numbers& crossings : lines.crossings) EXPECT_TRUE(crossings.empty());
}

// Face 0 lies left of face 1 and of face 2 above it; the line between these, arc 5, stops at face 0.
const std::vector<TFace> one_t{face({{{2}, {0, 1}, {3}, {4}}}), face({{{6}, {7}, {-6}, {-1}}}),
                               face({{{5}, {8}, {9}, {-2}}})};

TEST(IsoLines, ALineContinuesToTheOppositeSideOfItsFace) {
  const std::vector<int> lengths{1, 2, 4, 4, 3, 5, 5, 1, 2, 5};
  const IsoLines lines = iso_lines(arcs(10, {0, 1, 5}), IntegerSides(one_t, lengths));
  EXPECT_EQ(num_lines(lines), 1);
  EXPECT_EQ(lines.lines[0][1], Numbers{1});   // from side 1, one above its begin
  EXPECT_EQ(lines.crossings[4], Numbers{2});  // counted downwards
  for (const int a : {0, 1, 2, 3, 5, 6, 7, 8, 9}) EXPECT_TRUE(lines.crossings[a].empty()) << a;
}

TEST(IsoLines, PointsAreNumberedInTheDirectionOfTheirArc) {
  std::vector<TFace> upwards = one_t;
  upwards[0][3] = {HalfEdge{4, true}};
  const std::vector<int> lengths{1, 2, 4, 4, 3, 5, 5, 1, 2, 5};
  EXPECT_EQ(iso_lines(arcs(10, {0, 1, 5}), IntegerSides(upwards, lengths)).crossings[4], Numbers{1});
}

// A face with two faces on its left (arc 10 between them) and two on its right (arc 11): arcs 0, 1 and 2, 3 from below.
const std::vector<TFace> two_ts{face({{{4}, {2, 3}, {5}, {-2, -1}}}), face({{{12}, {0}, {10}, {13}}}),
                                face({{{-11}, {1}, {14}, {15}}}), face({{{16}, {17}, {11}, {-3}}}),
                                face({{{-12}, {18}, {19}, {-4}}})};
const std::set<int> inner_of_two_ts{0, 1, 2, 3, 10, 11};

TEST(IsoLines, TJunctionsThatFaceEachOtherAreOneLine) {
  std::vector<int> lengths(20, 1);
  lengths[4] = lengths[5] = 7;
  const IsoLines lines = iso_lines(arcs(20, inner_of_two_ts), IntegerSides(two_ts, lengths));
  EXPECT_EQ(num_lines(lines), 1);
  EXPECT_EQ(lines.lines[0][1], Numbers{1});
  for (const Numbers& crossings : lines.crossings) EXPECT_TRUE(crossings.empty());
}

TEST(IsoLines, ALineThatMissesATJunctionContinuesBehindTheArc) {
  // The left T-junction is at 1 of 3, the right one at 2.
  std::vector<int> lengths(20, 1);
  lengths[1] = lengths[15] = lengths[2] = lengths[17] = 2;
  const IsoLines lines = iso_lines(arcs(20, inner_of_two_ts), IntegerSides(two_ts, lengths));
  EXPECT_EQ(lines.lines[0][1], (Numbers{1, 2}));
  EXPECT_EQ(lines.crossings[2], Numbers{1});   // the left one's line, on the lower of two arcs
  EXPECT_EQ(lines.crossings[17], Numbers{1});  // and through the face behind it, to the boundary
  EXPECT_EQ(lines.crossings[1], Numbers{1});
  EXPECT_EQ(lines.crossings[15], Numbers{1});
  EXPECT_EQ(num_lines(lines), 4);
}

}  // namespace
}  // namespace quadrille::quantize
