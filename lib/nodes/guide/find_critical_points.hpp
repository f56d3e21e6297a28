#pragma once
// The critical points of the field: all zeros, once each, with indices; their clusters; the valences of corners and the
// zeros that corners absorb (lib/method.md §1, §3, §5).
//
// A corner absorbs zeros that are too near to it for a block between, and V becomes V + sum (V_k - 4). A zero no
// farther than `length` from a corner, with the segment between them in the domain, is absorbed if the new valence is
// admissible (guide/valence). Close to a tie both neighbouring valences are admissible, and the result is the count of
// quarter turns along an arc of radius `length`. Only corners of the layout absorb zeros, smooth boundary points do
// not, nor corners whose valence was chosen by rule (source `line`). A zero equally near to two corners is absorbed by
// neither; zeros equally near to one corner are absorbed together or not at all; nearer zeros are decided first.
// Distances within 1e-6 of `length` count as equal.

#include <vector>

#include "base/report.hpp"
#include "field/evaluate.hpp"
#include "guide/valence.hpp"
#include "model/critical_points.hpp"
#include "zeros/zero_search.hpp"

namespace quadrille::guide {

/// Lengths are relative to the face's diameter.
struct SearchOptions {
  /// In [0, 0.1]. Zeros no farther apart are one cluster (guide/clusters); 0: multiple zeros only. On real outlines
  /// zeros that make useful blocks are 5e-3 diameters apart, and the default does not merge them.
  double cluster_distance = 2e-3;
  /// In [0, 0.1]. Corners absorb nodes no farther away; 0: none.
  double corner_absorb = 2e-3;
  /// In [1e-14, 1e-2]. Cells in which |v| stays below are not distinguished from a multiple zero. To resolve a pair of
  /// zeros at a distance d, `noise` must be below |J| d / 4; a value below the residual of the field's solution shows
  /// zeros of the discrete field, not of v.
  double noise = zeros::field_noise;
  bool operator==(const SearchOptions&) const = default;

  /// Throws UsageError if a number is outside its interval.
  void validate() const;
};

/// Every element is subdivided in Bernstein form until each cell is proved empty or proved to contain at most one zero,
/// which is then found or shown to lie elsewhere (zeros/zero_search), or |v| in it is below `noise`.
///   critical_points   simple zeros that are in no cluster and that no corner absorbs; error bars if the field has
///                     elem_error
///   clusters          the other zeros, without absorbed ones: they have no node yet (guide/resolve_clusters)
///   corners           valences of guide/valence, changed by those that absorb zeros, each of which is in `changes`
///   zeros             all simple zeros found, if critical_points are not just these; else empty
///   certificate       counts and cells of the search; the counts are also reported as proof.*
///   index_sum         with clusters
/// Warns of clusters of zeros whose existence the field does not decide (guide/clusters, criterion (c)).
/// Sorted by x, then y (equal within 1e-6 of the diameter counts as equal). Throws ComputeError if the field vanishes
/// on a curve, or if the index of a multiple zero (guide/clusters) or a corner's valence (guide/valence) cannot be
/// decided. Does not check the index sum: see guide/valence.
CriticalPoints find_critical_points(const field::FieldEvaluator& evaluator, const SearchOptions& options,
                                    Report& report);
/// The same with given valences of the corners; corners with the source `line` absorb no zeros.
CriticalPoints find_critical_points(const field::FieldEvaluator& evaluator, const SearchOptions& options,
                                    CornerValences valences, Report& report);
/// The same with what a search of all elements has found.
CriticalPoints find_critical_points(const field::FieldEvaluator& evaluator, const SearchOptions& options,
                                    CornerValences valences, const zeros::SearchResult& search, Report& report);

/// Changes the corners of `points`, each with a change of the kind `absorb`. Returns for each zero whether it was
/// absorbed.
std::vector<bool> absorb_into_corners(const CadFace& face, const std::vector<zeros::FoundZero>& zeros, double length,
                                      CriticalPoints& points);

}  // namespace quadrille::guide
