#include "zeros/edge_jumps.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"

namespace quadrille::zeros {
namespace {

constexpr std::array<Vec2, 3> reference_vertices{Vec2{-1, -1}, Vec2{1, -1}, Vec2{-1, 1}};

Vec2 on_edge(int edge, double t) {
  const Vec2 a = reference_vertices[edge], b = reference_vertices[(edge + 1) % 3];
  return a + t * (b - a);
}

Vec2 value(const field::FieldEvaluator& evaluator, int elem, Vec2 xi) {
  Vec2 x;
  Mat2 dx_dxi;
  return evaluator.value(elem, xi, x, dx_dxi);
}

double jump(const field::FieldEvaluator& evaluator, int elem, int edge) {
  const mesh::TriTopology& topology = evaluator.topology();
  const int other = topology.elem2neighbors[elem][edge], other_edge = topology.elem2neighbor_edges[elem][edge];
  const std::vector<int>& orders = evaluator.field().elem_order;
  const int n = std::max(orders[elem], orders[other]) + 2;
  double greatest = 0;
  for (int i = 0; i < n; ++i) {
    const double t = 0.5 * (1 - std::cos((2 * i + 1) * pi / (2 * n)));
    greatest = std::max(
        greatest, norm(value(evaluator, elem, on_edge(edge, t)) - value(evaluator, other, on_edge(other_edge, 1 - t))));
  }
  return 2 * greatest;
}

}  // namespace

std::vector<Jumps> edge_jumps(const field::FieldEvaluator& evaluator) {
  const TriMesh& mesh = evaluator.field().mesh;
  const mesh::TriTopology& topology = evaluator.topology();
  if (evaluator.field().method == FieldMethod::cg) return {};
  std::vector<double> by_edge(topology.edge2elems.size(), 0.0), by_vertex(mesh.vertices.size(), 0.0);
  for (int e = 0; e < mesh.num_elems(); ++e)
    for (int k = 0; k < 3; ++k) {
      if (topology.elem2neighbors[e][k] < e) continue;  // also skips the boundary, -1
      const int edge = topology.elem2edges[e][k];
      by_edge[edge] = jump(evaluator, e, k);
      for (const int vertex : topology.edge2vertices[edge]) by_vertex[vertex] += by_edge[edge];
    }
  std::vector<Jumps> result(mesh.num_elems());
  for (int e = 0; e < mesh.num_elems(); ++e)
    for (int k = 0; k < 3; ++k) {
      result[e].edge[k] = by_edge[topology.elem2edges[e][k]];
      result[e].vertex[k] = by_vertex[mesh.elem2vertices[e][k]] / 2;
    }
  return result;
}

}  // namespace quadrille::zeros
