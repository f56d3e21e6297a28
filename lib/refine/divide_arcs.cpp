#include "refine/divide_arcs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "refine/anchors.hpp"
#include "refine/spacing.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille {
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

/// Interpolation from the nodes of an interval to samples between them.
struct ErrorSamples {
  std::vector<double> points;
  Eigen::MatrixXd from_nodes;

  explicit ErrorSamples(int order) {
    const int count = 2 * order + 2;
    for (int i = 0; i < count; ++i) points.push_back(-std::cos((2 * i + 1) * pi / (2 * count)));
    from_nodes = interpolation_matrix(gll_points(order), points);
  }
};

const ErrorSamples& error_samples(int order) {
  static PerOrder<ErrorSamples> cache([](int n) { return ErrorSamples(n); });
  return cache[order];
}

/// A polynomial of the order as a polygon, to tell the distance of points that may be far from where its parameter
/// says.
struct PolygonSamples {
  Eigen::MatrixXd from_nodes;

  explicit PolygonSamples(int order) {
    const int count = 16 * order;
    std::vector<double> points;
    for (int i = 0; i <= count; ++i) points.push_back(-1 + 2.0 * i / count);
    from_nodes = interpolation_matrix(gll_points(order), points);
  }
};

const PolygonSamples& polygon_samples(int order) {
  static PerOrder<PolygonSamples> cache([](int n) { return PolygonSamples(n); });
  return cache[order];
}

double distance_to_segment(Vec2 x, Vec2 a, Vec2 b) {
  const double length2 = norm2(b - a);
  const double share = length2 > 0 ? std::clamp(dot(x - a, b - a) / length2, 0.0, 1.0) : 0;
  return distance(x, a + share * (b - a));
}

/// A lower bound of the distance of the chain's breaks, and of the middles between them, from the interval's
/// polynomial: there a bend that is short against the interval, a fillet, is farthest from it. Nodes and parameters do
/// not see that.
double bend_error(const Chain& chain, double low, double high, const std::vector<ChainPoint>& nodes, int order) {
  std::vector<double> ends{low};
  for (const double f : chain.break_fractions())
    if (f > low + same_fraction && f < high - same_fraction) ends.push_back(f);
  if (ends.size() == 1) return 0;
  ends.push_back(high);

  const Eigen::MatrixXd& from_nodes = polygon_samples(order).from_nodes;
  std::vector<Vec2> polygon(from_nodes.rows());
  for (std::size_t i = 0; i < polygon.size(); ++i)
    for (int k = 0; k <= order; ++k) polygon[i] += from_nodes(static_cast<int>(i), k) * nodes[k].position;
  double sagitta = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sagitta = std::max(sagitta, norm(polygon[i - 1] - 2 * polygon[i] + polygon[i + 1]) / 8);

  double worst = 0;
  for (std::size_t i = 1; i < ends.size(); ++i)
    for (const double f : {ends[i - 1], (ends[i - 1] + ends[i]) / 2}) {
      const Vec2 x = chain.at(f).position;
      double nearest = distance(x, polygon[0]);
      for (std::size_t k = 1; k < polygon.size(); ++k)
        nearest = std::min(nearest, distance_to_segment(x, polygon[k - 1], polygon[k]));
      worst = std::max(worst, nearest);
    }
  return worst - sagitta;
}

double between(double low, double high, double xi) { return low * (1 - xi) / 2 + high * (1 + xi) / 2; }

/// Distance of x from a curve whose nearest point has about the parameter t: a Newton step, then that from the tangent.
double distance_from(const Nurbs& curve, Vec2 x, double t) {
  const auto d = derivatives(curve, t);
  const double speed2 = norm2(d[1]);
  if (speed2 == 0) return distance(x, d[0]);
  const auto near = derivatives(curve, t + dot(x - d[0], d[1]) / speed2);
  const double speed = norm(near[1]);
  return speed == 0 ? distance(x, near[0]) : std::abs(cross(x - near[0], near[1])) / speed;
}

/// The same for a chain by its fraction, which measures length: no step is needed.
double distance_from(const Chain& chain, Vec2 x, double fraction) {
  const ChainPoint near = chain.at(fraction);
  return std::abs(cross(x - near.position, near.tangent));
}

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
  ChordDivider(const BlockLayout& layout, const Chord& chord, const ChordPlan& plan, const CurveTable& table,
               const std::vector<Chain>& chains, const std::vector<ArcParameter>& parameters,
               const DivideOptions& options)
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
  const Chain& chain(int i) const { return chains_[chord_.arcs[i]]; }

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
      const double error = interval_error(table_, chain(i), ends[k - 1], ends[k], options_.order);
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
  const Chord& chord_;
  const ChordPlan& plan_;
  const CurveTable& table_;
  const std::vector<Chain>& chains_;
  const std::vector<ArcParameter>& parameters_;
  const DivideOptions& options_;
  Grading grading_;
  double planned_count_ = 1;
  std::vector<LengthDemand> demands_;
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

double interval_error(const CurveTable& table, const Chain& chain, double low, double high, int order) {
  const ErrorSamples& samples = error_samples(order);
  std::vector<ChainPoint> nodes;
  for (const double xi : gll_points(order)) nodes.push_back(chain.at(between(low, high, xi)));
  const int piece = nodes[order / 2].piece;
  const bool in_one_piece =
      std::all_of(nodes.begin(), nodes.end(), [&](const ChainPoint& p) { return p.piece == piece; });
  double worst = std::max(0.0, bend_error(chain, low, high, nodes, order));
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    Vec2 value;
    double t = 0;
    for (int k = 0; k <= order; ++k) {
      const double weight = samples.from_nodes(static_cast<int>(i), k);
      value += weight * nodes[k].position;
      t += weight * nodes[k].t;
    }
    worst = std::max(worst, in_one_piece ? distance_from(table.curve(chain.pieces()[piece].curve), value, t)
                                         : distance_from(chain, value, between(low, high, samples.points[i])));
  }
  return worst;
}

std::vector<std::vector<double>> divide_arcs(const BlockLayout& layout, const std::vector<Chord>& chords,
                                             const std::vector<ChordPlan>& plans, const CurveTable& table,
                                             const std::vector<Chain>& chains,
                                             const std::vector<ArcParameter>& parameters,
                                             const DivideOptions& options) {
  std::vector<std::vector<double>> ends(chains.size());
  for (std::size_t c = 0; c < chords.size(); ++c) {
    ChordDivider divider(layout, chords[c], plans[c], table, chains, parameters, options);
    std::vector<std::vector<double>> divided = divider.divide();
    for (std::size_t i = 0; i < divided.size(); ++i) ends[chords[c].arcs[i]] = std::move(divided[i]);
  }
  return ends;
}

}  // namespace quadrille
