#pragma once
// Zeros that belong together (lib/method.md §5): a multiple zero, however noise or the last digits split it, and zeros
// nearer to each other than any block could be.
//
// Two zeros are of one cluster when
//   (a) |v| stays within the field's own error between them, so that they cannot be distinguished from a multiple zero:
//   at 1/4,
//       1/2 and 3/4 of the way it is at most max(10 noise, 1.5 e), e the error estimate of their elements (zeros of z^n
//       split by a constant e have 5/4 e there), and they are no farther apart than a twentieth of the diameter; or
//   (b) they are no farther apart than `distance`.
// In both cases the segment between them lies in the domain, and lengths equal within 1e-6 count as equal. Zeros linked
// through others are one cluster, so that a symmetric set of zeros gives a symmetric set of clusters. Cells
// that the search left open (|v| below noise all over) are parts of clusters too; neighbouring ones belong together.
// A cluster's index is the sum of its members'; with open cells the winding number round all of it. It may be 0: a pair
// of opposite index. Open cells of index 0 without any zero that was found are no cluster: there is no zero.

#include <vector>

#include "model/critical_points.hpp"
#include "zeros/zero_search.hpp"

namespace quadrille::guide {

struct ClusterCriterion {
  double distance = 0;                ///< (b), in the file's unit; 0: multiple zeros only
  double noise = zeros::field_noise;  ///< of |v|
};

struct Clustering {
  std::vector<Cluster> clusters;
  std::vector<zeros::FoundZero> simple;  ///< the zeros in no cluster
};

/// Whether the segment from a to b lies in the mesh, judged at nine points.
bool is_segment_in_mesh(const field::FieldEvaluator& evaluator, Vec2 a, Vec2 b);

/// Sorts the zeros into clusters and simple ones. The centre of a cluster with |index| >= 2 is that of the multiple
/// zero behind it (guide/cluster_centre), else the mean of its members. Throws ComputeError where the index of open
/// cells is unknown because no contour about them stays in the domain and off the other zeros.
/// Quadratic in the number of zeros and open cells.
Clustering find_clusters(const field::FieldEvaluator& evaluator, const std::vector<zeros::FoundZero>& zeros,
                         const std::vector<zeros::OpenCell>& open_cells, const ClusterCriterion& criterion);

}  // namespace quadrille::guide
