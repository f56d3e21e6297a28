#include "model/arc_graph.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace quadrille {
namespace {

struct Arc {
  int from, to;
};

TEST(HalfEdge, StartsWhereItsReverseEnds) {
  const std::vector<Arc> arcs{{3, 4}, {5, 6}};
  EXPECT_EQ(start_of(arcs, {1}), 5);
  EXPECT_EQ(end_of(arcs, {1}), 6);
  EXPECT_EQ(start_of(arcs, {1, true}), 6);
  EXPECT_EQ(end_of(arcs, {1, true}), 5);
  EXPECT_EQ(HalfEdge{1}.reversed().reversed(), HalfEdge{1});
}

TEST(HalfEdge, IndicesFollowTheOrder) {
  EXPECT_EQ((HalfEdge{2}.index()), 4u);
  EXPECT_EQ((HalfEdge{2, true}.index()), 5u);
  EXPECT_LT(HalfEdge{2}, (HalfEdge{2, true}));
  EXPECT_LT((HalfEdge{2, true}), HalfEdge{3});
}

TEST(HalfEdge, FilesHoldOneInteger) {
  for (const int code : {0, 7, -1, -8, std::numeric_limits<int>::min()})
    EXPECT_EQ(file_code(half_edge_of_code(code)), code);
  EXPECT_EQ(half_edge_of_code(-8), (HalfEdge{7, true}));
}

}  // namespace
}  // namespace quadrille
