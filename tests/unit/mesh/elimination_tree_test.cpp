#include "mesh/elimination_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "../test_meshes.hpp"

namespace quadrille::mesh {
namespace {

const TriMesh mesh = parallelogram_mesh({0, 0}, {1, 0}, {0.3, 1}, 9);
const TriTopology topology = tri_topology(mesh);
const EliminationTree tree = nested_dissection(mesh, topology);

bool is_permutation_of_all(std::vector<int> numbers, std::size_t n) {
  std::vector<int> all(n);
  std::iota(all.begin(), all.end(), 0);
  std::sort(numbers.begin(), numbers.end());
  return numbers == all;
}

TEST(EliminationTree, HoldsEveryElementVertexAndEdgeOnce) {
  EXPECT_TRUE(is_permutation_of_all(tree.elements, mesh.elem2vertices.size()));
  EXPECT_TRUE(is_permutation_of_all(tree.elimination_order, mesh.vertices.size() + topology.edge2vertices.size()));
}

TEST(EliminationTree, HalvesComeFirstAndMakeUpTheWhole) {
  EXPECT_EQ(tree.nodes.back().parent, -1);
  EXPECT_EQ(tree.nodes.back().end - tree.nodes.back().begin, mesh.num_elems());
  for (int n = 0; n < static_cast<int>(tree.nodes.size()); ++n) {
    const EliminationTree::Node& node = tree.nodes[n];
    if (node.first < 0) continue;
    const EliminationTree::Node &a = tree.nodes[node.first], &b = tree.nodes[node.second];
    EXPECT_TRUE(node.first < n && node.second < n && a.parent == n && b.parent == n);
    EXPECT_TRUE(a.begin == node.begin && a.end == b.begin && b.end == node.end);
    const int least = std::min(a.end - a.begin, b.end - b.begin);
    EXPECT_GE(5 * least, 2 * (node.end - node.begin) - 5);
  }
}

TEST(EliminationTree, EliminatesTheFirstCutLast) {
  // What both halves of the mesh share stands at the end of the elimination order.
  const EliminationTree::Node& root = tree.nodes.back();
  const int num_vertices = static_cast<int>(mesh.vertices.size()), middle = tree.nodes[root.first].end;
  std::vector<bool> in_first(mesh.num_elems(), false);
  for (int position = 0; position < middle; ++position) in_first[tree.elements[position]] = true;
  bool cut_begun = false;
  for (const int entity : tree.elimination_order) {
    if (entity < num_vertices) continue;
    const auto& [a, b] = topology.edge2elems[entity - num_vertices];
    const bool is_cut = b >= 0 && in_first[a] != in_first[b];
    EXPECT_TRUE(is_cut || !cut_begun);
    cut_begun = cut_begun || is_cut;
  }
  EXPECT_TRUE(cut_begun);
}

}  // namespace
}  // namespace quadrille::mesh
