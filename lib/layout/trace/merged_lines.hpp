#pragma once
// Traced lines with their merge decisions, curves and crossings: the input of both the graph of whole lines and the
// motorcycle graph.

#include <limits>
#include <vector>

#include "base/progress.hpp"
#include "graph/crossing_cache.hpp"
#include "trace/line_fitter.hpp"
#include "trace/merge_plan.hpp"

namespace quadrille::trace {

/// Nodes nearer to each other than this are one, relative to the diameter.
inline constexpr double relative_snap_tol = 1e-9;

/// Lines that meet head on within this angle (radians) are always merged, independent of the options.
inline constexpr double same_line_angle = 1e-4;

/// Limits of the lines that are merged.
struct LineBounds {
  double reach = 0;  ///< as for MergePlan
  std::size_t max_crossings = std::numeric_limits<std::size_t>::max();
};

/// The lines with the present merges, in the order of their streamlines, and their crossings.
struct LineArrangement {
  std::vector<MergedLine> lines;
  std::vector<graph::Crossing> crossings;
  std::vector<graph::Crossing> inner_crossings;  ///< without those at a common end of two lines
  std::vector<int> chosen = {};                  ///< the merges, as numbers of candidates
};

enum class LineEnds {
  required,  ///< a line that reaches neither boundary nor node must be merged, also with a larger deviation; else it is
             ///< an error
  optional   ///< such a line may remain: another line stops it (motorcycle graph)
};

class MergedLines {
 public:
  /// `evaluator`, `lines` and `nodes` (the positions of the nodes that lines start at) must outlive it. `merge_angle`
  /// in radians, `merge_distance` a length.
  MergedLines(const field::FieldEvaluator& evaluator, const std::vector<Streamline>& lines,
              const std::vector<Vec2>& nodes, double merge_angle, double merge_distance, LineEnds ends,
              const LineBounds& bounds = {});

  /// Chooses merges, computes curves and crossings, and rejects merges that have bent a line across its own family
  /// until there are none. Returns false if lines must be continued to decide. Throws ComputeError if a line has no end
  /// but requires one or if lines of one family cross (graph::require_family_order), and as graph::find_crossings.
  bool merge(Progress* progress = nullptr);

  /// Rejects those of these merges (numbers as in chosen()) whose deviation is within 1e-6 of the largest. Returns
  /// false if the largest is below `least_deviation` (radians). merge() must be called afterwards.
  bool reject_worst(const std::vector<int>& merges, double least_deviation);

  /// Searches candidates again, after lines were added or continued. Rejected pairs of lines stay rejected.
  void renew() { plan_.renew(); }

  /// Results of the last merge().
  const LineArrangement& arrangement() const { return arrangement_; }
  const std::vector<int>& chosen() const { return arrangement_.chosen; }
  double largest_deviation() const;  ///< of the chosen merges, radians

 private:
  const CadFace& face() const { return evaluator_.field().mesh.face; }
  void arrange(Progress* progress);
  bool is_common_end(const graph::Crossing& crossing) const;
  bool reject_crossing_merges();
  void require_family_order() const;

  const field::FieldEvaluator& evaluator_;
  const std::vector<Streamline>& lines_;
  LineEnds ends_;
  std::size_t max_crossings_;
  MergePlan plan_;
  LineFitter fitter_;
  graph::CrossingCache cache_;
  LineArrangement arrangement_;
};

}  // namespace quadrille::trace
