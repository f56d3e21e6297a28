#pragma once
// How much a mesh exceeds what is allowed: the one order by which a change of a mesh, or of one of its blocks, is kept
// or dropped.

#include <vector>

#include "mesh/boundary_distance.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::mesh {

struct EdgeGrowth {
  double greatest = 1;  ///< longer over shorter, of edges that continue each other across an edge of both elements
  Vec2 position;        ///< of their common vertex, relative to the face's origin
  double excess = 0;    ///< sum of ln^2 (ratio / limit) over the ratios above it, on both sides of each line
};

/// Of all lines; lengths are distances of vertices. Of equal ratios (within 1e-6) that of the first element. `limit`:
/// of the excess, at least 1.
EdgeGrowth edge_growth(const QuadMesh& mesh, double limit = 1);

/// What is allowed; of 0 anything is.
struct ScoreLimits {
  double distance = 0;    ///< of the boundary from the CAD curves, a length
  double edge_ratio = 0;  ///< of the sides of an element, at least 1
  double growth = 0;      ///< ratio of adjacent edges, > 1
};

/// All values are 0 where nothing exceeds its limit, in the order of their importance.
struct MeshScore {
  double unproved = 0;    ///< number of elements that are not proved valid
  double distance = 0;    ///< logarithm of the boundary's distance over its limit
  double elongation = 0;  ///< logarithm of the greatest ratio of an element's sides over its limit
  double skewness = 0;    ///< sum of block_skewness
  double growth = 0;      ///< EdgeGrowth::excess
};

/// Whether one excess is greater than another: by more than 0.05 (5 % of a length or a scaled Jacobian), or the other
/// excess is zero.
bool exceeds(double a, double b);

/// Whether `a` has the lower value in the first one in which they differ (`exceeds`); of growth every difference
/// counts. Of equal meshes none is better.
bool is_better(const MeshScore& a, const MeshScore& b);

/// Of a measured mesh (refine/validity, mesh/element_sizes). `is_thin`: by element, whether it is so on purpose, and is
/// not elongated; empty: none is.
MeshScore mesh_score(const QuadMesh& mesh, const BoundaryDistance& distance, const ScoreLimits& limits,
                     const std::vector<bool>& is_thin = {});

/// By block: ln (0.7 / q), q the least scaled Jacobian of its elements; 0 above 0.7, infinite if an element is not
/// proved valid.
std::vector<double> block_skewness(const QuadMesh& mesh);

}  // namespace quadrille::mesh
