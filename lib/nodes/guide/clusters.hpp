#pragma once
// Clusters of zeros (lib/method.md §5): a multiple zero that noise or round-off may have split, and zeros nearer to
// each other than any block could be.
//
// Two zeros are in one cluster if
//   (a) |v| stays within the field's own error between them, so that they cannot be distinguished from a multiple zero:
//       at 1/4, 1/2 and 3/4 of the segment it is at most max(10 noise, 1.5 e), e the error estimate of their elements
//       (zeros of z^n split by a constant e have 5/4 e there), and their distance is at most a twentieth of the
//       diameter; or
//   (b) their distance is at most `distance`; or
//   (c) a region connects them in which |v| is below the field's error, however far they are from each other and
//       however it is bent (zeros/undecided_zeros): the field does not decide whether they exist; or
//   (d) their indices are opposite, they are far from the boundary for their distance, and fewer nodes can replace them
//       (guide/zeros_in_circle). Not if `distance` is 0.
// In (a), (b) and (d) the segment between them lies in the domain, and lengths equal within 1e-6 count as equal. Zeros
// linked through others are in one cluster, so that a symmetric set of zeros has a symmetric set of clusters. Cells
// that the search classified as open (|v| below noise all over) are parts of clusters too; neighbouring cells are
// linked. The index of a cluster is the sum over its members; with open cells it is the winding number round the whole
// cluster. It may be 0: a pair of opposite index. Open cells of index 0 without any zero that was found are not a
// cluster, because there is no zero. Clusters that (c) alone holds together are marked as undecided.

#include <vector>

#include "model/critical_points.hpp"
#include "zeros/zero_search.hpp"

namespace quadrille::guide {

struct ClusterCriterion {
  double distance = 0;                ///< (b), in the file's unit; 0: multiple zeros only, without (d)
  double noise = zeros::field_noise;  ///< of |v|
};

struct Clustering {
  std::vector<Cluster> clusters;
  std::vector<zeros::FoundZero> simple;  ///< the zeros that are in no cluster
};

/// Sorts the zeros into clusters and simple ones. The centre of a cluster with |index| >= 2 is the centre of the
/// corresponding multiple zero (guide/zeros_in_circle), else the mean of its members; if that lies outside the domain,
/// the member nearest to it. Throws ComputeError if the index of open cells is unknown because no contour about them
/// stays in the domain and away from the other zeros. Quadratic in the number of zeros and open cells.
Clustering find_clusters(const field::FieldEvaluator& evaluator, const std::vector<zeros::FoundZero>& zeros,
                         const std::vector<zeros::OpenCell>& open_cells, const ClusterCriterion& criterion);

}  // namespace quadrille::guide
