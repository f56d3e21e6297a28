#include "simplify/block_quality.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "base/angle.hpp"
#include "curve/chain.hpp"
#include "graph/node_rotation.hpp"
#include "mesh/block_shape.hpp"

namespace quadrille::simplify {
namespace {

void add_angles(const ArcGraph& graph, const std::vector<HalfEdge>& cycle, BlockQuality& worst) {
  for (int k = 0; k < 4; ++k) {
    const double angle =
        wrap_two_pi(graph::start_angle(graph, cycle[(k + 3) % 4].reversed()) - graph::start_angle(graph, cycle[k]));
    worst.least_angle = std::min(worst.least_angle, angle);
    worst.greatest_angle = std::max(worst.greatest_angle, angle);
  }
}

}  // namespace

BlockQuality worst_quality(const graph::Subdivision& subdivision, const std::vector<int>& faces) {
  const ArcGraph& graph = subdivision.graph();
  const curve::CurveTable table(graph.face, graph.splines);
  std::unordered_map<int, curve::Chain> chains;
  BlockQuality worst;
  for (const int f : faces) {
    const std::vector<HalfEdge> cycle = subdivision.cycle(f);
    std::array<const curve::Chain*, 4> sides{};
    std::array<bool, 4> backwards{};
    for (int k = 0; k < 4; ++k) {
      sides[k] = &chains.try_emplace(cycle[k].arc, table, graph.arcs[cycle[k].arc].pieces).first->second;
      backwards[k] = cycle[k].is_backwards;
    }
    add_angles(graph, cycle, worst);
    const mesh::BlockShape shape = mesh::block_shape(mesh::TransfiniteMap(sides, backwards));
    worst.least_scaled_jacobian = std::min(worst.least_scaled_jacobian, shape.scaled_jacobian);
    worst.is_valid = worst.is_valid && shape.is_valid();
  }
  return worst;
}

BlockQuality worst_quality(const graph::Subdivision& subdivision) {
  std::vector<int> all;
  for (int f = 0; f < subdivision.face_bound(); ++f)
    if (subdivision.has_face(f)) all.push_back(f);
  return worst_quality(subdivision, all);
}

std::vector<int> faces_beside(const graph::Subdivision& subdivision, const std::set<int>& arcs) {
  std::set<int> beside;
  for (const int a : arcs)
    for (const HalfEdge h : {HalfEdge{a}, HalfEdge{a, true}})
      if (subdivision.face(h) >= 0) beside.insert(subdivision.face(h));
  return {beside.begin(), beside.end()};
}

}  // namespace quadrille::simplify
