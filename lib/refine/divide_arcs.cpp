#include "refine/divide_arcs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "refine/anchors.hpp"
#include "refine/spacing.hpp"
#include "sizing/interval_error.hpp"

namespace quadrille::refine {
namespace {

constexpr int max_intervals = 10000;
constexpr double same_fraction = 1e-9;
/// An interval may be longer than planned by this factor where breaks leave segments that do not divide well.
constexpr double length_slack = 1.25 + 1e-9;
/// Breaks of opposite arcs share a cross line when they lie within this share of an interval.
constexpr double anchor_reach = 0.5;
/// An interval that misses the tolerance becomes shorter by this factor at least.
constexpr double least_excess = 1.05;
/// So often may a chord's count rise by one in search of a symmetric division.
constexpr int max_tie_rounds = 24;

/// Two elements must not meet in two edges, nor one meet itself.
int least_topological_count(const BlockLayout& layout, int arc) {
  const GraphArc& a = layout.arcs[arc];
  if (a.from == a.to) return 3;
  const auto ends = std::minmax(a.from, a.to);
  const auto is_parallel = [&](const GraphArc& b) { return &b != &a && std::minmax(b.from, b.to) == ends; };
  return std::any_of(layout.arcs.begin(), layout.arcs.end(), is_parallel) ? 2 : 1;
}

/// The division of one chord: segments between those anchors that are needed, and what each arc makes of them.
class ChordDivider {
 public:
  ChordDivider(const BlockLayout& layout, const mesh::Chord& chord, const sizing::ChordPlan& plan,
               const curve::CurveTable& table, const std::vector<curve::Chain>& chains,
               const std::vector<sizing::ArcParameter>& parameters, const DivideOptions& options)
      : layout_(layout),
        chord_(chord),
        plan_(plan),
        table_(table),
        chains_(chains),
        parameters_(parameters),
        options_(options),
        grading_(plan.grading),
        planned_count_(std::min<double>(plan.count, plan.grading.count())) {
    count_ = base_count_ = first_count();
    std::vector<Break> breaks;
    for (int i = 0; i < num_arcs(); ++i) longest_arc_ = std::max(longest_arc_, chain(i).length());
    for (int i = 0; i < num_arcs(); ++i)
      if (layout.arcs[chord.arcs[i]].is_boundary)
        for (const double f : chain(i).break_fractions()) breaks.push_back({chord_share(i, f), f, i});
    anchors_ = find_anchors(std::move(breaks), anchor_reach / count_);
    for (std::size_t a = 0; a < anchors_.size(); ++a)
      if (std::any_of(anchors_[a].breaks.begin(), anchors_[a].breaks.end(),
                      [&](const Break& b) { return parts_names(b); }))
        need(static_cast<int>(a));
    ends_.resize(num_arcs());
  }

  /// Ends of the intervals of each arc of the chord.
  std::vector<std::vector<double>> divide() {
    for (bool improved = true; improved;) {
      settle();
      improved = false;
      for (int i = 0; i < num_arcs(); ++i) improved |= layout_.arcs[chord_.arcs[i]].is_boundary && improve(i);
      if (!demands_.empty()) shorten();
    }
    return std::move(ends_);
  }

 private:
  int num_arcs() const { return static_cast<int>(chord_.arcs.size()); }

  /// Whether the curves on both sides of a break have different names, one of them given: no edge may belong to both.
  bool parts_names(const Break& b) const {
    const std::vector<double> joints = chain(b.arc).joint_fractions();
    const auto at = std::find_if(joints.begin(), joints.end(),
                                 [&](double joint) { return std::abs(joint - b.fraction) < same_fraction; });
    if (at == joints.end()) return false;
    const auto piece = chain(b.arc).pieces().begin() + (at - joints.begin());
    const int before = piece[0].curve, after = piece[1].curve;
    const CadFace& face = layout_.face;
    const auto is_given = [&](int c) { return face.curve_names[c] != fmt::format("curve_{}", c); };
    return face.curve_names[before] != face.curve_names[after] && (is_given(before) || is_given(after));
  }
  const curve::Chain& chain(int i) const { return chains_[chord_.arcs[i]]; }

  /// Between the chord's parameter and arc i's own fraction.
  double arc_fraction(int i, double u) const {
    return parameters_[chord_.arcs[i]].fraction(chord_.backwards[i] ? 1 - u : u);
  }
  double chord_parameter(int i, double fraction) const {
    const double own = parameters_[chord_.arcs[i]].parameter(fraction);
    return chord_.backwards[i] ? 1 - own : own;
  }
  double chord_share(int i, double fraction) const { return grading_.share(chord_parameter(i, fraction)); }

  int first_count() const {
    int count = plan_.count;
    for (const int arc : chord_.arcs) count = std::max(count, least_topological_count(layout_, arc));
    if (count > max_intervals) fail("the wanted size");
    return count;
  }

  /// Takes the least count that suits all arcs.
  void settle() {
    count_ = std::max(base_count_, segments_.least_count());
    const int first = count_;
    for (int next = 0; next != count_;) {
      if (next > 0) count_ = next;
      if (count_ > max_intervals) fail("the geometric tolerance");
      next = next_count(plan_.is_prescribed || count_ - first >= max_tie_rounds);
    }
  }

  /// The present count if it suits all arcs, else one to try after it.
  int next_count(bool break_ties) {
    counts_ = segment_counts(segments_, count_, break_ties);
    if (counts_.empty()) return count_ + 1;
    double longest = 0;
    for (int i = 0; i < num_arcs(); ++i) longest = std::max(longest, place_ends(i));
    if (longest <= length_slack || plan_.is_prescribed) return count_;
    return count_ + std::max(1, count_ / 100);
  }

  /// Arc i's ends in its own direction: at its own breaks to the last digit, else at the chord's shares. Returns its
  /// longest interval against what the plan has there on the chord's longest arc.
  double place_ends(int i) {
    Segments own = segments_;
    std::vector<double> exact(own.ends.size(), -1);
    for (std::size_t s = 0; s < needed_.size(); ++s)
      for (const Break& b : anchors_[needed_[s]].breaks)
        if (b.arc == i) own.ends[s + 1] = b.u, exact[s + 1] = b.fraction;
    ends_[i] = interval_ends(own, counts_);
    std::vector<double> u = ends_[i];
    for (double& end : u) end = grading_.parameter(end);
    const std::vector<double> shares = std::move(ends_[i]);
    ends_[i].clear();
    for (const double at : u) ends_[i].push_back(arc_fraction(i, at));
    for (std::size_t s = 0, at = 0; s < counts_.size(); at += counts_[s++])
      if (exact[s] >= 0) ends_[i][at] = exact[s];
    double longest = 0;
    for (std::size_t k = 1; k < u.size(); ++k) {
      // By how much the arc's own parameter stretches the interval, where no edge may be longer than planned.
      const double stretch = plan_.is_bound ? std::abs(ends_[i][k] - ends_[i][k - 1]) / (u[k] - u[k - 1]) : 1;
      longest = std::max(longest, stretch * (shares[k] - shares[k - 1]));
    }
    if (chord_.backwards[i]) std::reverse(ends_[i].begin(), ends_[i].end());
    return longest * planned_count_ * chain(i).length() / longest_arc_;
  }

  /// Asks for breaks and counts where arc i misses the tolerance; false when it meets it everywhere.
  bool improve(int i) {
    const std::vector<double>& ends = ends_[i];
    std::vector<int> anchors;
    std::vector<double> worst(counts_.size(), 0.0);  ///< by segment
    bool missed = false;
    for (std::size_t k = 1; k < ends.size(); ++k) {
      const double error = sizing::interval_error(table_, chain(i), ends[k - 1], ends[k], options_.order);
      if (error <= options_.tolerance) continue;
      missed = true;
      if (anchors_inside(i, ends[k - 1], ends[k], anchors)) continue;
      const std::size_t s = segment_of(static_cast<int>(chord_.backwards[i] ? ends.size() - 1 - k : k - 1));
      if (grading_.is_identity())
        worst[s] = std::max(worst[s], error);
      else
        demand(i, ends[k - 1], ends[k], error);
    }
    for (std::size_t s = 0; s < worst.size(); ++s)
      if (worst[s] > 0)
        segments_.least_counts[s] = std::max(segments_.least_counts[s], raised_count(counts_[s], worst[s]));
    for (const int anchor : anchors) need(anchor);
    return missed;
  }

  /// The segment that holds an interval.
  std::size_t segment_of(int interval) const {
    std::size_t s = 0;
    while (interval >= counts_[s]) interval -= counts_[s++];
    return s;
  }

  /// The anchors that the interval should rather end on; none where it is smooth, or so long that breaks are spread all
  /// over it: then it must become shorter first.
  bool anchors_inside(int i, double low, double high, std::vector<int>& found) const {
    std::vector<int> inside;
    std::vector<double> fractions;
    for (std::size_t a = 0; a < anchors_.size(); ++a)
      for (const Break& b : anchors_[a].breaks)
        if (b.arc == i && b.fraction > low + same_fraction && b.fraction < high - same_fraction) {
          inside.push_back(static_cast<int>(a));
          fractions.push_back(b.fraction);
        }
    if (inside.empty()) return false;
    const auto [first, last] = std::minmax_element(fractions.begin(), fractions.end());
    if (inside.size() > 2 && *last - *first > (high - low) / 2) return false;
    found.insert(found.end(), inside.begin(), inside.end());
    return true;
  }

  /// So many intervals should stand in place of one: the error of a smooth interval falls with its length to the power
  /// N + 1.
  double excess(double error) const {
    return std::min(4.0, 1.02 * std::pow(error / options_.tolerance, 1.0 / (options_.order + 1)));
  }
  int raised_count(int count, double error) const {
    return std::max(count + 1, static_cast<int>(std::ceil(count * excess(error) - 1e-6)));
  }

  /// In a graded chord only the interval itself becomes shorter: elsewhere others may be far shorter already.
  void demand(int i, double from, double to, double error) {
    const double a = chord_parameter(i, from), b = chord_parameter(i, to);
    const double shorter = std::max(least_excess, excess(error));
    demands_.push_back({std::min(a, b), std::max(a, b), std::abs(b - a) / shorter, shorter});
  }

  void shorten() {
    grading_ = grading_.shortened(count_, demands_, plan_.slope);
    demands_.clear();
    planned_count_ = grading_.count();
    base_count_ = static_cast<int>(std::min<double>(max_intervals + 1, std::ceil(planned_count_ * (1 - 1e-6))));
    for (Anchor& anchor : anchors_) {
      anchor.u = 0;
      for (Break& b : anchor.breaks) {
        b.u = chord_share(b.arc, b.fraction);
        anchor.u += b.u / static_cast<double>(anchor.breaks.size());
      }
    }
    for (std::size_t s = 0; s < needed_.size(); ++s) segments_.ends[s + 1] = anchors_[needed_[s]].u;
  }

  /// Cuts a segment in two at an anchor; the count that it needed because it held the break is forgotten.
  void need(int anchor) {
    const auto at = std::lower_bound(needed_.begin(), needed_.end(), anchor) - needed_.begin();
    if (at < static_cast<std::ptrdiff_t>(needed_.size()) && needed_[at] == anchor) return;
    needed_.insert(needed_.begin() + at, anchor);
    segments_.ends.insert(segments_.ends.begin() + at + 1, anchors_[anchor].u);
    segments_.least_counts[at] = 1;
    segments_.least_counts.insert(segments_.least_counts.begin() + at + 1, 1);
  }

  [[noreturn]] void fail(const char* wish) const {
    const Vec2 place = chain(0).at(0.5).position + layout_.face.origin;
    throw ComputeError(fmt::format("{} asks for more than {} elements along the arc through ({:.6g}, {:.6g})", wish,
                                   max_intervals, place.x, place.y));
  }

  const BlockLayout& layout_;
  const mesh::Chord& chord_;
  const sizing::ChordPlan& plan_;
  const curve::CurveTable& table_;
  const std::vector<curve::Chain>& chains_;
  const std::vector<sizing::ArcParameter>& parameters_;
  const DivideOptions& options_;
  sizing::Grading grading_;
  double planned_count_ = 1;
  std::vector<sizing::LengthDemand> demands_;
  int base_count_ = 1;  ///< from plan and topology
  int count_ = 1;
  double longest_arc_ = 0;
  std::vector<Anchor> anchors_;
  std::vector<int> needed_;  ///< anchors, ascending: the inner ends of the segments
  Segments segments_;        ///< by the share of the chord's elements
  std::vector<int> counts_;  ///< of the segments
  std::vector<std::vector<double>> ends_;
};

}  // namespace

std::vector<std::vector<double>> divide_arcs(const BlockLayout& layout, const std::vector<mesh::Chord>& chords,
                                             const std::vector<sizing::ChordPlan>& plans,
                                             const curve::CurveTable& table, const std::vector<curve::Chain>& chains,
                                             const std::vector<sizing::ArcParameter>& parameters,
                                             const DivideOptions& options) {
  std::vector<std::vector<double>> ends(chains.size());
  for (std::size_t c = 0; c < chords.size(); ++c) {
    ChordDivider divider(layout, chords[c], plans[c], table, chains, parameters, options);
    std::vector<std::vector<double>> divided = divider.divide();
    for (std::size_t i = 0; i < divided.size(); ++i) ends[chords[c].arcs[i]] = std::move(divided[i]);
  }
  return ends;
}

}  // namespace quadrille::refine
