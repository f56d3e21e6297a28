#include "quantize/quantize.hpp"

#include <gtest/gtest.h>

#include "t_faces.hpp"

namespace quadrille::quantize {
namespace {

// Arcs 0, 1, 2 across a strip of two faces that closes on itself: 0 = 1 and 1 = 0 + 2. Arcs 3 to 6 run along it.
const std::vector<TFace> spiral{face({{{0}, {3}, {1}, {4}}}), face({{{-2}, {5}, {-1, 2}, {6}}})};

TEST(Quantize, OppositeSidesAreEqualAndNearTheirTargets) {
  // One face: side 0 of three arcs, the others of one.
  const std::vector<TFace> faces{face({{{0, 1, 2}, {3}, {4}, {5}}})};
  const std::vector<int> lengths = quantize(faces, {0.2, 1.0, 2.1, 0.1, 5.2, 0.3}, 1);
  ASSERT_EQ(lengths.size(), 6u);
  EXPECT_EQ(sum(faces[0][0], lengths), sum(faces[0][2], lengths));
  EXPECT_EQ(sum(faces[0][1], lengths), sum(faces[0][3], lengths));
  for (const int length : lengths) EXPECT_GE(length, 1);
  EXPECT_EQ(lengths[3], 1);
  EXPECT_NEAR(lengths[4], 4.5, 0.5);
}

TEST(Quantize, EqualArcsGetEqualLengths) {
  // 3 + 4 = 7 would be nearest, 3 + 3 = 6 is as symmetric as the face.
  const std::vector<TFace> faces{face({{{0, 1}, {2}, {3}, {4}}})};
  EXPECT_EQ(quantize(faces, {3.4, 3.4, 1, 6.8, 1}, 1), (std::vector<int>{3, 3, 1, 6, 1}));
  EXPECT_EQ(quantize(faces, {3.4, 3.4001, 1, 6.8, 1}, 1)[3], 7);
}

TEST(Quantize, EqualArcsThatCannotBeEqualAreNot) {
  // Opposite sides of one and two arcs, all equally long.
  const std::vector<TFace> faces{face({{{0, 1}, {2}, {3}, {4}}})};
  EXPECT_EQ(quantize(faces, {1, 1, 1, 1, 1}, 1), (std::vector<int>{1, 1, 1, 2, 1}));
}

TEST(Quantize, AStripThatWindsOntoItselfHasNoLengths) {
  EXPECT_TRUE(quantize(spiral, {1, 1, 0.1, 1, 1, 1, 1}, 1).empty());
  EXPECT_EQ(forced_zero_arcs(spiral, 7), std::vector<int>{2});
}

TEST(Quantize, NoArcIsForcedToZeroWhereLengthsExist) {
  EXPECT_TRUE(forced_zero_arcs({face({{{0, 1, 2}, {3}, {4}, {5}}})}, 6).empty());
}

TEST(Quantize, TheCertificateNamesTheArcsAlongTheStrip) {
  // A third face beside the strip has no part in it.
  std::vector<TFace> faces = spiral;
  faces.push_back(face({{{-4}, {7}, {8}, {9}}}));
  EXPECT_EQ(infeasibility_certificate(faces, 10, 2), (std::vector<int>{3, 4, 5, 6}));
}

}  // namespace
}  // namespace quadrille::quantize
