#pragma once
// Traced lines with their merge decisions, curves and crossings: the input of both the graph of whole lines and the
// motorcycle graph.
//
// Pairs of lines that are merged are chosen with corrections: merges that bend a line across its neighbour are
// rejected, and lines that would never end are merged with a larger deviation.
//
// Lines of one family never cross: along every edge of an element, and so everywhere, they keep their order. Two lines
// either cross at right angles, up to the error of their integration, or belong to one family.

#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/progress.hpp"
#include "graph/build_graph.hpp"
#include "graph/crossings.hpp"
#include "trace/merge_candidates.hpp"

namespace quadrille::trace {

/// Picks pairs in their order so that no line is in two, and returns their numbers; `is_taken` marks the lines that are
/// in a pair, on entry and on return. Pairs that meet after lengths with a relative difference below 1e-6 are decided
/// together: where two of them compete for one line, neither is picked, so that symmetric shapes stay symmetric. Only
/// pairs with allowed[i] are considered.
std::vector<int> choose_merges(const std::vector<MergeCandidate>& candidates, const std::vector<bool>& allowed,
                               std::vector<bool>& is_taken);

class MergePlan {
 public:
  /// `evaluator`, `lines` and `nodes` must outlive the plan. `reaches`, by line: the length to which it has been traced
  /// so far, if it has no end yet and can be continued; 0: it is complete. Empty: all are.
  MergePlan(const field::FieldEvaluator& evaluator, const std::vector<Streamline>& lines,
            const std::vector<Vec2>& nodes, const MergeOptions& options, std::vector<double> reaches = {});

  /// Numbers of the candidates chosen by the rules (trace/merge_candidates.hpp) among those not rejected.
  std::vector<int> choose_by_rules() const;

  /// choose_by_rules, then every endless line (spiral, limit cycle) without a partner is merged with the first free one
  /// that meets it head on within merge_limits.endless_angle; if none is free, the merge of two lines that end is
  /// rejected for it. std::nullopt if continued lines might change the choice: `unsettled`.
  std::optional<std::vector<int>> choose();

  /// The lines that must be continued before choose() can decide. Lines of a pair that meets before the reach of both
  /// are none of them, though they have no end yet: all pairs that come before it are known.
  const std::set<int>& unsettled() const { return unsettled_; }

  /// The first line that cannot be continued (Streamline::is_stuck), is far shorter than the unsettled ones and has no
  /// partner by the rules; std::nullopt if every line can be continued, is long or has a partner. Continuing the other
  /// lines gives such a line no partner.
  std::optional<int> stuck_without_partner() const;

  /// Rejects those of these candidates whose deviation is within 1e-6 of the largest: a symmetry orbit together.
  /// Returns false and rejects none if the largest is below `least_deviation` (radians).
  bool reject_worst(const std::vector<int>& candidates, double least_deviation);

  /// Rejects all candidates of each pair of lines of which one is rejected.
  void reject_whole_pairs();

  /// Searches candidates again, after lines were added or continued; rejects all candidates of rejected pairs.
  void renew();

  const MergeCandidate& candidate(int i) const { return candidates_[i]; }
  /// The candidate among `chosen` of each line, or -1.
  std::vector<int> merge_of_lines(const std::vector<int>& chosen) const;

 private:
  using LinePairs = std::set<std::pair<int, int>>;

  void reject(const LinePairs& pairs);
  LinePairs rejected_pairs() const;
  void add_candidates(const MergeOptions& options);
  bool is_unfinished(int line) const;
  void find_unsettled(const std::vector<int>& chosen);
  std::vector<int> endless_without_partner(const std::vector<int>& chosen) const;
  std::optional<std::vector<int>> choose_once();
  void add_last_resorts(const std::vector<int>& endless, std::vector<int>& chosen);
  bool reject_for(int endless, const std::vector<int>& merge_of);

  const field::FieldEvaluator& evaluator_;
  const std::vector<Streamline>& lines_;
  const std::vector<Vec2>& nodes_;
  MergeOptions options_;
  std::vector<MergeCandidate> candidates_;  // by the rules, then the last resorts of endless lines
  std::vector<bool> is_rejected_;
  size_t num_regular_ = 0;  // candidates by the rules
  std::vector<double> reaches_;
  std::set<int> unsettled_;
};

/// Whether a crossing can only be one of lines of one family.
bool is_of_one_family(const graph::Crossing& crossing);

/// Two lines of one family cross: lines integrated more accurately may not.
struct FamilyOrderError : ComputeError {
  using ComputeError::ComputeError;
};

/// Throws FamilyOrderError with the position where two lines of one family cross at more than a milliradian (laps of a
/// spiral coincide up to rounding): the tolerance of their integration was too large for the field there. `is_exempt`,
/// by line of the crossings: lines bent by a merge may cross their neighbours. Crossings at common ends must have been
/// removed before.
void require_family_order(const std::vector<graph::Crossing>& crossings, const std::vector<bool>& is_exempt,
                          const CadFace& face);

/// A line, or a pair that was merged into one, with its curve.
struct MergedLine {
  graph::FinishedLine line;  ///< an endless line ends on no node and no curve
  double length = 0;         ///< arc length; for a pair the mean of both
  int merge = -1;            ///< candidate of the plan; -1: a single line
  int streamline = 0;        ///< its number; for a pair the number of the first line
  graph::CurveKey key{};     ///< lines with equal keys are the same curve
};

/// Splines that follow lines and pairs, each fitted once.
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

/// Lines that meet head on within this angle (radians) are always merged, independent of the options.
inline constexpr double same_line_angle = 1e-4;

/// Limits of the lines that are merged.
struct LineBounds {
  std::vector<double> reaches = {};  ///< as for MergePlan
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
  /// until there are none. Returns false if lines must be continued to decide: `unsettled`. Throws ComputeError if a
  /// line has no end but requires one or if lines of one family cross (require_family_order), and as
  /// graph::find_crossings.
  bool merge(Progress* progress = nullptr);

  /// Rejects those of these merges (numbers as in chosen()) whose deviation is within 1e-6 of the largest. Returns
  /// false if the largest is below `least_deviation` (radians). merge() must be called afterwards.
  bool reject_worst(const std::vector<int>& merges, double least_deviation);

  /// Searches candidates again, after lines were added or continued. Rejected pairs of lines stay rejected.
  void renew() { plan_.renew(); }

  /// Results of the last merge().
  const LineArrangement& arrangement() const { return arrangement_; }
  const std::vector<int>& chosen() const { return arrangement_.chosen; }
  const std::set<int>& unsettled() const { return plan_.unsettled(); }
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
