#include "simplify/block_quality.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "base/angle.hpp"
#include "curve/chain.hpp"
#include "graph/subdivision.hpp"
#include "mesh/transfinite.hpp"

namespace quadrille::simplify {
namespace {

BlockQuality angles_of(const ArcGraph& graph, const std::vector<HalfEdge>& cycle) {
  BlockQuality quality;
  for (int k = 0; k < 4; ++k) {
    const double angle =
        wrap_two_pi(graph::start_angle(graph, cycle[(k + 3) % 4].reversed()) - graph::start_angle(graph, cycle[k]));
    quality.least_angle = std::min(quality.least_angle, angle);
    quality.greatest_angle = std::max(quality.greatest_angle, angle);
  }
  return quality;
}

std::vector<double> key_of(const ArcGraph& graph, const std::vector<HalfEdge>& cycle) {
  std::vector<double> key;
  for (const HalfEdge h : cycle) {
    const std::vector<ArcPiece>& pieces = graph.arcs[h.arc].pieces;
    key.push_back(h.is_backwards ? -static_cast<double>(pieces.size()) : static_cast<double>(pieces.size()));
    for (const ArcPiece& p : pieces) key.insert(key.end(), {static_cast<double>(p.curve), p.t0, p.t1});
  }
  return key;
}

/// Measures faces of one subdivision, with the chains of their sides, which two faces have in common.
class FaceMeasurer {
 public:
  explicit FaceMeasurer(const ArcGraph& graph) : graph_(graph), table_(graph.face, graph.splines) {}

  /// Sets `quad` to the nodes of the face.
  BlockQuality measure(const std::vector<HalfEdge>& cycle, std::vector<Vec2>& quad) {
    std::array<const curve::Chain*, 4> sides{};
    std::array<bool, 4> backwards{};
    for (int k = 0; k < 4; ++k) {
      sides[k] = &chains_.try_emplace(cycle[k].arc, table_, graph_.arcs[cycle[k].arc].pieces).first->second;
      backwards[k] = cycle[k].is_backwards;
    }
    quad = mesh::TransfiniteMap(sides, backwards).sampled(mesh::block_order);
    BlockQuality quality = angles_of(graph_, cycle);
    quality.least_scaled_jacobian = mesh::scaled_jacobian(quad);
    return quality;
  }

 private:
  const ArcGraph& graph_;
  curve::CurveTable table_;
  std::unordered_map<int, curve::Chain> chains_;
};

}  // namespace

void BlockQuality::add(const BlockQuality& other) {
  least_angle = std::min(least_angle, other.least_angle);
  greatest_angle = std::max(greatest_angle, other.greatest_angle);
  least_scaled_jacobian = std::min(least_scaled_jacobian, other.least_scaled_jacobian);
}

BlockQuality worst_quality(const graph::Subdivision& subdivision, const std::vector<int>& faces, BlockQuads& quads) {
  FaceMeasurer measurer(subdivision.graph());
  BlockQuality worst;
  for (const int f : faces) worst.add(measurer.measure(subdivision.cycle(f), quads.emplace_back()));
  return worst;
}

bool are_valid(const BlockQuads& quads) { return std::all_of(quads.begin(), quads.end(), mesh::is_valid_block); }

BlockQuality BlockQualities::worst(const graph::Subdivision& subdivision, const std::vector<int>& faces) {
  FaceMeasurer measurer(subdivision.graph());
  BlockQuality worst;
  std::vector<Vec2> quad;
  for (const int f : faces) {
    const std::vector<HalfEdge> cycle = subdivision.cycle(f);
    const auto [known, is_new] = known_.try_emplace(key_of(subdivision.graph(), cycle));
    if (is_new) known->second = measurer.measure(cycle, quad);
    worst.add(known->second);
  }
  return worst;
}

std::vector<int> all_faces(const graph::Subdivision& subdivision) {
  std::vector<int> all;
  for (int f = 0; f < subdivision.face_bound(); ++f)
    if (subdivision.has_face(f)) all.push_back(f);
  return all;
}

std::vector<int> faces_beside(const graph::Subdivision& subdivision, const std::set<int>& arcs) {
  std::set<int> beside;
  for (const int a : arcs)
    for (const HalfEdge h : {HalfEdge{a}, HalfEdge{a, true}})
      if (subdivision.face(h) >= 0) beside.insert(subdivision.face(h));
  return {beside.begin(), beside.end()};
}

}  // namespace quadrille::simplify
