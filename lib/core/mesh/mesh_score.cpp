#include "mesh/mesh_score.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "mesh/edge_growth.hpp"

namespace quadrille::mesh {
namespace {

constexpr double significant = 0.05;
constexpr double good_quality = 0.7;  ///< a block this good is not skew
constexpr double same_growth = 1e-6;  ///< relative difference of growth

double log_excess(double value, double limit) { return limit > 0 && value > limit ? std::log(value / limit) : 0; }

double greatest_edge_ratio(const QuadMesh& mesh, const std::vector<bool>& is_thin) {
  double greatest = 1;
  for (int e = 0; e < mesh.num_elems(); ++e)
    if (is_thin.empty() || !is_thin[e]) greatest = std::max(greatest, mesh.elem_edge_ratio[e]);
  return greatest;
}

}  // namespace

bool exceeds(double a, double b) { return a > b + significant || (a > 0 && b == 0); }

bool is_better(const MeshScore& a, const MeshScore& b) {
  for (const auto value : {&MeshScore::unproved, &MeshScore::distance, &MeshScore::elongation, &MeshScore::skewness})
    if (exceeds(a.*value, b.*value) || exceeds(b.*value, a.*value)) return a.*value < b.*value;
  return a.growth < b.growth * (1 - same_growth);
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
