#include "quantize/length_flow.hpp"

#include <gtest/gtest.h>

#include <random>

#include "quantize/quantize.hpp"
#include "t_faces.hpp"

namespace quadrille::quantize {
namespace {

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

}  // namespace
}  // namespace quadrille::quantize
