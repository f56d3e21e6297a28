#include "mesh/elimination_tree.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace quadrille::mesh {

namespace {

constexpr int leaf_size = 4;
constexpr std::array<Vec2, 4> directions{Vec2{1, 0}, Vec2{0, 1}, Vec2{1, 1}, Vec2{1, -1}};

class Dissection {
 public:
  Dissection(const TriMesh& mesh, const TriTopology& topology);
  /// Appends the tree nodes of elements [begin, end) and returns the number of the last one.
  int dissect(int begin, int end);
  EliminationTree& tree() { return tree_; }

 private:
  struct Cut {
    int num_edges = 0, direction = 0, position = 0;
  };
  Cut best_cut(int begin, int end);
  void divide(int begin, int end, const Cut& cut);

  const TriTopology* topology_;
  EliminationTree tree_;
  std::array<std::vector<int>, 4> sorted_;  ///< elements sorted along each direction; the range of a part is common
  std::vector<int> part_;                   ///< for each element: the `begin` of its part
  std::vector<int> swept_;                  ///< for each element: number of the last sweep that passed it
  int sweep_ = 0;
};

Dissection::Dissection(const TriMesh& mesh, const TriTopology& topology)
    : topology_(&topology), part_(mesh.num_elems(), 0), swept_(mesh.num_elems(), 0) {
  std::vector<double> positions(mesh.num_elems());
  for (std::size_t d = 0; d < directions.size(); ++d) {
    for (int e = 0; e < mesh.num_elems(); ++e) {
      positions[e] = 0;
      for (const int v : mesh.elem2vertices[e]) positions[e] += dot(directions[d], mesh.vertices[v]);
    }
    sorted_[d].resize(mesh.num_elems());
    std::iota(sorted_[d].begin(), sorted_[d].end(), 0);
    std::stable_sort(sorted_[d].begin(), sorted_[d].end(), [&](int a, int b) { return positions[a] < positions[b]; });
  }
}

Dissection::Cut Dissection::best_cut(int begin, int end) {
  const int size = end - begin, low = begin + (2 * size + 4) / 5, high = end - (2 * size + 4) / 5;
  Cut best{4 * size, 0, begin + size / 2};
  for (int d = 0; d < static_cast<int>(directions.size()); ++d) {
    ++sweep_;
    int num_edges = 0;
    for (int i = begin; i < high; ++i) {
      const int elem = sorted_[d][i];
      for (const int neighbor : topology_->elem2neighbors[elem]) {
        if (neighbor >= 0 && part_[neighbor] == begin) num_edges += swept_[neighbor] == sweep_ ? -1 : 1;
      }
      swept_[elem] = sweep_;
      if (i + 1 >= low && num_edges < best.num_edges) best = {num_edges, d, i + 1};
    }
  }
  return best;
}

void Dissection::divide(int begin, int end, const Cut& cut) {
  for (int i = cut.position; i < end; ++i) part_[sorted_[cut.direction][i]] = cut.position;
  for (std::vector<int>& elements : sorted_) {
    std::stable_partition(elements.begin() + begin, elements.begin() + end,
                          [&](int e) { return part_[e] != cut.position; });
  }
}

int Dissection::dissect(int begin, int end) {
  EliminationTree::Node node{begin, end};
  if (end - begin > leaf_size) {
    const Cut cut = best_cut(begin, end);
    divide(begin, end, cut);
    node.first = dissect(begin, cut.position);
    node.second = dissect(cut.position, end);
  } else {
    tree_.elements.insert(tree_.elements.end(), sorted_[0].begin() + begin, sorted_[0].begin() + end);
  }
  const int number = static_cast<int>(tree_.nodes.size());
  for (const int half : {node.first, node.second}) {
    if (half >= 0) tree_.nodes[half].parent = number;
  }
  tree_.nodes.push_back(node);
  return number;
}

// The positions in tree.elements of the first and the last element of each entity.
struct Span {
  int first = -1, last = -1;
};

std::vector<Span> spans(const EliminationTree& tree, const TriMesh& mesh, const TriTopology& topology) {
  const int num_vertices = static_cast<int>(mesh.vertices.size());
  std::vector<Span> spans(num_vertices + topology.edge2vertices.size());
  for (int position = 0; position < static_cast<int>(tree.elements.size()); ++position) {
    const int elem = tree.elements[position];
    for (int k = 0; k < 3; ++k) {
      for (const int entity : {mesh.elem2vertices[elem][k], num_vertices + topology.elem2edges[elem][k]}) {
        if (spans[entity].first < 0) spans[entity].first = position;
        spans[entity].last = position;
      }
    }
  }
  return spans;
}

// Entities sorted by the smallest part that contains all their elements.
std::vector<int> elimination_order(const EliminationTree& tree, const TriMesh& mesh, const TriTopology& topology) {
  const std::vector<Span> entity2span = spans(tree, mesh, topology);
  std::vector<int> leaf(tree.elements.size()), owner(entity2span.size(), 0);
  for (int n = 0; n < static_cast<int>(tree.nodes.size()); ++n) {
    const EliminationTree::Node& node = tree.nodes[n];
    if (node.first < 0) std::fill(leaf.begin() + node.begin, leaf.begin() + node.end, n);
  }
  for (std::size_t i = 0; i < owner.size(); ++i) {
    if (entity2span[i].first < 0) continue;  // no element contains it
    int node = leaf[entity2span[i].first];
    while (entity2span[i].last >= tree.nodes[node].end) node = tree.nodes[node].parent;
    owner[i] = node;
  }
  std::vector<int> order(owner.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return owner[a] < owner[b]; });
  return order;
}

}  // namespace

EliminationTree nested_dissection(const TriMesh& mesh, const TriTopology& topology) {
  Dissection dissection(mesh, topology);
  dissection.dissect(0, mesh.num_elems());
  EliminationTree tree = std::move(dissection.tree());
  tree.elimination_order = elimination_order(tree, mesh, topology);
  return tree;
}

}  // namespace quadrille::mesh
