#include "heal/chain_edges.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "raw_samples.hpp"

namespace quadrille::heal {
namespace {

std::vector<int> order(const std::vector<RawEdge>& edges, double near, double tol) {
  std::vector<const RawEdge*> pointers;
  for (const RawEdge& edge : edges) pointers.push_back(&edge);
  std::vector<int> numbers;
  for (const RawEdge* edge : chain_edges(pointers, near, tol, "f.step")) numbers.push_back(edge->cad_edge);
  return numbers;
}

// A square whose corners are 0.01 apart at edge 2.
std::vector<RawEdge> shuffled() {
  return {raw_edge(curve::segment({0, 0}, {1, 0}), 0), raw_edge(curve::segment({1.01, 1}, {0, 1}), 2),
          raw_edge(curve::segment({1, 0}, {1, 1}), 1), raw_edge(curve::segment({0, 1}, {0, 0}), 3)};
}

TEST(ChainEdges, TakesTheNearestEdgeWithinTheTolerance) {
  EXPECT_EQ(order(shuffled(), 1e-7, 0.02), (std::vector<int>{0, 1, 2, 3}));
}

TEST(ChainEdges, RefusesWiderGaps) {
  EXPECT_THROW(order(shuffled(), 1e-7, 0.005), FormatError);
  EXPECT_THROW(order({shuffled()[0], shuffled()[2]}, 1e-7, 0.02), FormatError);
}

TEST(ChainEdges, ACommonVertexConnectsEdgesThatDoNotReachIt) {
  std::vector<RawEdge> edges = shuffled();
  edges[2].end = edges[1].start = {1, 1.005};
  EXPECT_EQ(order(edges, 1e-7, 1e-6), (std::vector<int>{0, 1, 2, 3}));
}

}  // namespace
}  // namespace quadrille::heal
