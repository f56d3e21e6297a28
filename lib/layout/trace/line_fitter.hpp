#pragma once
// Splines that follow traced lines and merged pairs, each fitted once.

#include <map>

#include "graph/build_graph.hpp"
#include "graph/crossing_cache.hpp"
#include "trace/merged_curve.hpp"

namespace quadrille::trace {

/// Splines follow their lines within this, relative to the diameter.
inline constexpr double relative_fit_tol = 2e-9;

/// A line, or a pair that was merged into one, with its curve.
struct MergedLine {
  graph::FinishedLine line;  ///< an endless line ends on no node and no curve
  double length = 0;         ///< arc length; for a pair the mean of both
  int merge = -1;            ///< candidate of the plan; -1: a single line
  int streamline = 0;        ///< its number; for a pair the number of the first line
  graph::CurveKey key{};     ///< lines with equal keys are the same curve
};

class LineFitter {
 public:
  /// `evaluator` and `lines` must outlive it. Lines may be added and continued later.
  LineFitter(const field::FieldEvaluator& evaluator, const std::vector<Streamline>& lines)
      : evaluator_(evaluator), lines_(lines) {}

  MergedLine single(int line);
  /// `merge`: the candidate's number in its plan.
  MergedLine pair(const MergeCandidate& candidate, int merge);

 private:
  const Nurbs& fitted(const graph::CurveKey& key, const curve::CurveFunction& curve, double length);

  const field::FieldEvaluator& evaluator_;
  const std::vector<Streamline>& lines_;
  std::map<graph::CurveKey, Nurbs> fitted_;
};

}  // namespace quadrille::trace
