#include "simplify/chord_judge.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include "base/angle.hpp"
#include "curve/chain.hpp"
#include "mesh/transfinite.hpp"
#include "spectral/quad_map.hpp"

namespace quadrille::simplify {
namespace {

constexpr int block_order = 8;  // as blocks are judged everywhere

class Judge {
 public:
  explicit Judge(const SeparatrixGraph& graph)
      : graph_(graph), table_(graph.face, graph.splines), chains_(graph.arcs.size()) {}

  void add(const std::vector<HalfEdge>& cycle, BlockShape& worst) {
    std::array<const curve::Chain*, 4> sides{};
    std::array<bool, 4> backwards{};
    for (int k = 0; k < 4; ++k) {
      sides[k] = &chain(cycle[k].arc);
      backwards[k] = cycle[k].is_backwards;
      const double angle =
          wrap_two_pi(graph::start_angle(graph_, cycle[(k + 3) % 4].reversed()) - graph::start_angle(graph_, cycle[k]));
      worst.least_angle = std::min(worst.least_angle, angle);
      worst.greatest_angle = std::max(worst.greatest_angle, angle);
    }
    const std::vector<Vec2> nodes = mesh::TransfiniteMap(sides, backwards).sampled(block_order);
    const double scaled = spectral::quad_scaled_jacobian(block_order, nodes.data());
    worst.least_scaled_jacobian = std::min(worst.least_scaled_jacobian, scaled);
    if (scaled <= 0 || spectral::quad_jacobian_lower_bound(block_order, nodes.data()) <= 0) worst.is_valid = false;
  }

 private:
  const curve::Chain& chain(int arc) {
    if (!chains_[arc]) chains_[arc] = std::make_unique<curve::Chain>(table_, graph_.arcs[arc].pieces);
    return *chains_[arc];
  }

  const SeparatrixGraph& graph_;
  curve::CurveTable table_;
  std::vector<std::unique_ptr<curve::Chain>> chains_;
};

}  // namespace

BlockShape worst_shape(const SeparatrixGraph& graph, const graph::PlanarFaces& faces, const std::vector<int>& chosen) {
  Judge judge(graph);
  BlockShape worst;
  for (const int f : chosen) judge.add(faces.cycles[f], worst);
  return worst;
}

std::vector<int> faces_beside(const graph::PlanarFaces& faces, const std::vector<bool>& is_marked) {
  std::vector<int> beside;
  for (int f = 0; f < static_cast<int>(faces.cycles.size()); ++f)
    if (std::any_of(faces.cycles[f].begin(), faces.cycles[f].end(), [&](HalfEdge d) { return is_marked[d.arc]; }))
      beside.push_back(f);
  return beside;
}

}  // namespace quadrille::simplify
