#include "mesh/mesh_score.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "base/tolerance.hpp"
#include "mesh/side_key.hpp"

namespace quadrille::mesh {

namespace {

/// An edge at one end of an edge that two elements may share.
struct Beside {
  int vertex = 0;     ///< the common vertex
  double length = 0;  ///< from there along the element's next edge
};

/// At both ends of side k, the element's edges that continue a line across it; the lower vertex first.
std::array<Beside, 2> beside_side(const QuadMesh& mesh, int elem, int k) {
  const auto at = [&](int corner, int next) -> Beside {
    const int v = side_start(mesh, elem, corner % 4);
    return {v, distance(mesh.nodes[v], mesh.nodes[side_start(mesh, elem, next % 4)])};
  };
  std::array<Beside, 2> both{at(k, k + 3), at(k + 1, k + 2)};
  if (both[1].vertex < both[0].vertex) std::swap(both[0], both[1]);
  return both;
}

constexpr double significant = 0.05;
constexpr double good_quality = 0.7;  ///< a block this good is not skew

double log_excess(double value, double limit) { return limit > 0 && value > limit ? std::log(value / limit) : 0; }

double greatest_edge_ratio(const QuadMesh& mesh, const std::vector<bool>& is_thin) {
  double greatest = 1;
  for (int e = 0; e < mesh.num_elems(); ++e)
    if (is_thin.empty() || !is_thin[e]) greatest = std::max(greatest, mesh.elem_edge_ratio[e]);
  return greatest;
}

}  // namespace

EdgeGrowth edge_growth(const QuadMesh& mesh, double limit) {
  EdgeGrowth growth;
  std::map<std::pair<int, int>, std::array<Beside, 2>> open;  // sides met once
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    for (int k = 0; k < 4; ++k) {
      const std::array<Beside, 2> own = beside_side(mesh, elem, k);
      const auto [it, is_new] = open.try_emplace(side_key(mesh, elem, k), own);
      if (is_new) continue;
      for (const int end : {0, 1}) {
        const double a = own[end].length, b = it->second[end].length, ratio = std::max(a / b, b / a);
        if (ratio > limit) growth.excess += std::pow(std::log(ratio / limit), 2);
        if (ratio <= growth.greatest * (1 + tolerance::tied)) continue;
        growth.greatest = ratio;
        growth.position = mesh.nodes[own[end].vertex];
      }
      open.erase(it);
    }
  return growth;
}

bool exceeds(double a, double b) { return a > b + significant || (a > 0 && b == 0); }

bool is_better(const MeshScore& a, const MeshScore& b) {
  for (const auto value : {&MeshScore::unproved, &MeshScore::distance, &MeshScore::elongation, &MeshScore::skewness})
    if (exceeds(a.*value, b.*value) || exceeds(b.*value, a.*value)) return a.*value < b.*value;
  return a.growth < b.growth * (1 - tolerance::tied);
}

MeshScore mesh_score(const QuadMesh& mesh, const BoundaryDistance& distance, const ScoreLimits& limits,
                     const std::vector<bool>& is_thin) {
  const std::vector<double> skewness = block_skewness(mesh);
  MeshScore score;
  score.unproved = mesh.num_unproved();
  if (!distance.is_within(limits.distance)) score.distance = log_excess(distance.worst().distance, limits.distance);
  score.elongation = log_excess(greatest_edge_ratio(mesh, is_thin), limits.edge_ratio);
  score.skewness = std::accumulate(skewness.begin(), skewness.end(), 0.0);
  if (limits.growth > 0) score.growth = edge_growth(mesh, limits.growth).excess;
  return score;
}

std::vector<double> block_skewness(const QuadMesh& mesh) {
  std::vector<double> skewness(mesh.block_names.size(), 0);
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const double quality = mesh.elem_jacobian_bound[elem] > 0 ? mesh.elem_scaled_jacobian[elem] : 0;
    double& greatest = skewness[mesh.elem_block[elem]];
    if (quality < good_quality)
      greatest =
          std::max(greatest, quality > 0 ? std::log(good_quality / quality) : std::numeric_limits<double>::infinity());
  }
  return skewness;
}

}  // namespace quadrille::mesh
