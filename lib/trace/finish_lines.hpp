#pragma once
// Splines for what is left after merging, fitted once however often the plan changes.

#include <optional>
#include <vector>

#include "graph/build_graph.hpp"
#include "trace/merge_plan.hpp"

namespace quadrille::trace {

class LineFinisher {
 public:
  /// `tol` (a length): the splines follow their lines within it.
  LineFinisher(const field::FieldEvaluator& evaluator, const std::vector<Streamline>& lines, double tol);

  /// Merged pairs and single lines, in the sequence of the lines. Throws ComputeError where a single line has no end.
  void finish(const MergePlan& plan, const std::vector<int>& chosen);

  const std::vector<graph::FinishedLine>& finished() const { return finished_; }
  const std::vector<Nurbs>& splines() const { return splines_; }  ///< of the finished lines
  const std::vector<int>& merge_of() const { return merge_of_; }  ///< candidate of each finished line, or -1

 private:
  graph::FinishedLine merged(const MergePlan& plan, int candidate);
  graph::FinishedLine traced(int line);

  const field::FieldEvaluator& evaluator_;
  const std::vector<Streamline>& lines_;
  double tol_;
  std::vector<std::optional<Nurbs>> traced_, merged_;
  std::vector<graph::FinishedLine> finished_;
  std::vector<Nurbs> splines_;
  std::vector<int> merge_of_;
};

}  // namespace quadrille::trace
