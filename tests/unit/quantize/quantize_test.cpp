#include "quantize/quantize.hpp"

#include <gtest/gtest.h>

#include <random>

#include "../support/square_t_mesh.hpp"
#include "base/error.hpp"
#include "graph/candidate_layout.hpp"
#include "t_faces.hpp"

namespace quadrille::quantize {
namespace {

// Next to a node lines turn fast: the angle at which one stops at another, here 36 degrees, says nothing.
TEST(TMeshFaces, ATJunctionIsOneAtAnyAngle) {
  for (const double y : {0.02, 0.5, 0.98}) {
    const SeparatrixGraph graph = square_t_mesh::make({{{0.3, 0}, {0.3, 1}, 0, 2}, {{1, y}, {0.3, 1 - y}, 1, -1}});
    EXPECT_EQ(graph.t_junctions.size(), 1u);
    EXPECT_EQ(t_mesh_faces(graph::Subdivision(graph)).size(), 3u) << y;
  }
}

TEST(TMeshFaces, ALineThatEndsOnAnotherMakesATJunctionAndFourCorneredFaces) {
  const SeparatrixGraph graph = square_t_mesh::make(square_t_mesh::one_t);
  EXPECT_EQ(graph.t_junctions.size(), 1u);
  const std::vector<TFace> faces = t_mesh_faces(graph::Subdivision(graph));
  ASSERT_EQ(faces.size(), 3u);
  size_t half_edges = 0;
  for (const TFace& f : faces)
    for (const auto& side : f) half_edges += side.size();
  EXPECT_EQ(half_edges, 13u);  // four sides each, and one more where the T-junction is
  const std::vector<FaceCount> histogram = graph::face_valence_histogram(graph::Subdivision(graph));
  ASSERT_EQ(histogram.size(), 1u);
  EXPECT_EQ(histogram[0].corners, 4);
  EXPECT_EQ(histogram[0].faces, 3);
}

TEST(TMeshFaces, FacesOfOtherShapesAreNamed) {
  // The same graph, taken to have a corner of two quarters.
  SeparatrixGraph graph = square_t_mesh::make(square_t_mesh::one_t);
  graph.nodes[0].valence = 2;
  EXPECT_THROW(t_mesh_faces(graph::Subdivision(graph)), ComputeError);
}

void expect_balanced(const std::vector<TFace>& faces, const std::vector<int>& lengths) {
  for (const TFace& face : faces)
    for (const int k : {0, 1}) EXPECT_EQ(sum(face[k], lengths), sum(face[k + 2], lengths));
  for (const int length : lengths) EXPECT_GE(length, 1);
}

double cost(const std::vector<int>& lengths, const std::vector<double>& targets) {
  double total = 0;
  for (std::size_t a = 0; a < lengths.size(); ++a)
    total += (lengths[a] - targets[a]) * (lengths[a] - targets[a]) / std::max(targets[a], 0.5);
  return total;
}

TEST(LengthFlow, AFaceWithAJunctionIsBalanced) {
  const std::vector<TFace> faces{face({{{0, 1, 2}, {3}, {4}, {5}}})};
  const std::vector<double> targets{0.2, 1.0, 2.1, 0.1, 5.2, 0.3};
  const std::vector<int> lengths = flow_lengths(faces, targets).lengths;
  ASSERT_EQ(lengths.size(), 6u);
  expect_balanced(faces, lengths);
  EXPECT_EQ(lengths[3], 1);
  EXPECT_NEAR(lengths[4], 4.5, 0.5);
}

TEST(LengthFlow, AStripThatWindsOntoItselfHasNoLengths) {
  // As in quantize_test.cpp: 0 = 1 and 1 = 0 + 2.
  const std::vector<TFace> spiral{face({{{0}, {3}, {1}, {4}}}), face({{{-2}, {5}, {-1, 2}, {6}}})};
  const FlowLengths found = flow_lengths(spiral, {1, 1, 0.1, 1, 1, 1, 1});
  EXPECT_TRUE(found.lengths.empty());
  EXPECT_EQ(found.strips, (std::vector<std::vector<int>>{{3, 4, 5, 6}}));
}

TEST(LengthFlow, ASurplusIsCarriedToAFaceThatLacksIt) {
  // A strip of three faces, closed at both ends by pairs of arcs: 0 + 1 = 2 = 3 = 4 + 5, of which all but 2 and 3 lie
  // on the boundary; the lengths of 2 and 3 rise together.
  const std::vector<TFace> faces{face({{{0, 1}, {6}, {2}, {7}}}), face({{{-3}, {8}, {3}, {9}}}),
                                 face({{{-4}, {10}, {4, 5}, {11}}})};
  const std::vector<double> targets{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
  EXPECT_EQ(flow_lengths(faces, targets).lengths, (std::vector<int>{1, 1, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1}));
}

// A grid of faces whose sides are divided at random, with boundary all round.
struct RandomMesh {
  std::vector<TFace> faces;
  std::vector<double> targets;

  RandomMesh(int size, std::mt19937& random) {
    const auto below = [&](double most) { return most * static_cast<double>(random()) / 4294967296.0; };
    const auto side = [&] {
      std::vector<HalfEdge> arcs;
      for (int k = below(1) < 0.3 ? 2 : 1; k > 0; --k) {
        arcs.push_back({static_cast<int>(targets.size())});
        targets.push_back(below(3));
      }
      return arcs;
    };
    const auto reversed = [](std::vector<HalfEdge> arcs) {
      std::reverse(arcs.begin(), arcs.end());
      for (HalfEdge& h : arcs) h = h.reversed();
      return arcs;
    };
    std::vector<std::vector<HalfEdge>> tops(size);
    for (auto& top : tops) top = side();
    for (int j = 0; j < size; ++j) {
      std::vector<HalfEdge> right = side();
      for (int i = 0; i < size; ++i) {
        const std::vector<HalfEdge> left = right, bottom = tops[i];
        right = side(), tops[i] = side();
        faces.push_back({bottom, right, reversed(tops[i]), reversed(left)});
      }
    }
  }
};

TEST(LengthFlow, IsNearlyAsGoodAsTheIntegerProgram) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    std::mt19937 random(seed);
    const RandomMesh mesh(6, random);
    const std::vector<int> lengths = flow_lengths(mesh.faces, mesh.targets).lengths;
    ASSERT_EQ(lengths.size(), mesh.targets.size());
    expect_balanced(mesh.faces, lengths);
    EXPECT_LT(cost(lengths, mesh.targets), 1.3 * cost(quantize(mesh.faces, mesh.targets, 1), mesh.targets));
  }
}

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
