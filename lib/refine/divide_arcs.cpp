#include "refine/divide_arcs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "refine/spacing.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille {
namespace {

constexpr int max_intervals = 10000;
constexpr double same_fraction = 1e-9;
/// An interval may exceed the wanted size by this factor where breaks leave segments that do not divide well.
constexpr double size_slack = 1.25;
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

double between(double low, double high, double xi) { return low * (1 - xi) / 2 + high * (1 + xi) / 2; }

/// Two elements must not meet in two edges, nor one meet itself.
int least_topological_count(const BlockLayout& layout, int arc) {
  const GraphArc& a = layout.arcs[arc];
  if (a.from == a.to) return 3;
  const auto ends = std::minmax(a.from, a.to);
  const auto is_parallel = [&](const GraphArc& b) { return &b != &a && std::minmax(b.from, b.to) == ends; };
  return std::any_of(layout.arcs.begin(), layout.arcs.end(), is_parallel) ? 2 : 1;
}

class Divider {
 public:
  Divider(const BlockLayout& layout, const std::vector<int>& arc_chord, const std::vector<Chain>& chains,
          const DivideOptions& options)
      : layout_(layout), chains_(chains), options_(options) {
    const int num_arcs = static_cast<int>(layout.arcs.size());
    chord_arcs_.resize(num_arcs == 0 ? 0 : 1 + *std::max_element(arc_chord.begin(), arc_chord.end()));
    for (int a = 0; a < num_arcs; ++a) chord_arcs_[arc_chord[a]].push_back(a);
    segments_.resize(num_arcs);
    ends_.resize(num_arcs);
    breaks_.resize(num_arcs);
    for (int a = 0; a < num_arcs; ++a)
      if (layout.arcs[a].is_boundary) breaks_[a] = chains[a].break_fractions();
    for (const std::vector<int>& arcs : chord_arcs_) counts_.push_back(first_count(arcs));
  }

  std::vector<std::vector<double>> divide() {
    for (std::size_t chord = 0; chord < chord_arcs_.size(); ++chord)
      for (bool improved = true; improved;) {
        settle(static_cast<int>(chord));
        improved = false;
        for (const int arc : chord_arcs_[chord]) improved |= layout_.arcs[arc].is_boundary && improve(arc);
      }
    return std::move(ends_);
  }

 private:
  int first_count(const std::vector<int>& arcs) const {
    double longest = 0;
    int least = 1;
    for (const int arc : arcs) {
      longest = std::max(longest, chains_[arc].length());
      least = std::max(least, least_topological_count(layout_, arc));
    }
    const double wanted = std::ceil(longest / options_.size - 1e-6);
    if (wanted > max_intervals) fail(arcs.front(), "the wanted size");
    return std::max(least, static_cast<int>(wanted));
  }

  /// Gives all arcs of the chord the same number of intervals, the least that suits all.
  void settle(int chord) {
    int& count = counts_[chord];
    for (const int arc : chord_arcs_[chord]) count = std::max(count, segments_[arc].least_count());
    if (count > max_intervals) fail(chord_arcs_[chord].front(), "the geometric tolerance");
    const int first = count;
    while (!try_count(chord, count, count - first >= max_tie_rounds)) ++count;
  }

  bool try_count(int chord, int count, bool break_ties) {
    for (const int arc : chord_arcs_[chord]) {
      const std::vector<int> counts = segment_counts(segments_[arc], count, break_ties);
      if (counts.empty()) return false;
      std::vector<double> ends = interval_ends(segments_[arc], counts);
      double longest = 0;
      for (std::size_t i = 1; i < ends.size(); ++i) longest = std::max(longest, ends[i] - ends[i - 1]);
      if (longest * chains_[arc].length() > size_slack * options_.size) return false;
      ends_[arc] = std::move(ends);
    }
    return true;
  }

  /// Asks for breaks and counts where the arc misses the tolerance; false when it meets it everywhere.
  bool improve(int arc) {
    const std::vector<double>& ends = ends_[arc];
    ArcSegments& segments = segments_[arc];
    std::vector<double> new_ends;
    bool missed = false;
    std::size_t interval = 0;
    for (std::size_t s = 0; s < segments.least_counts.size(); ++s) {
      const std::size_t first = interval;
      double worst = 0;
      for (; interval + 1 < ends.size() && ends[interval + 1] <= segments.ends[s + 1]; ++interval) {
        const double error = interval_error(chains_[arc], ends[interval], ends[interval + 1], options_.order);
        if (error <= options_.tolerance) continue;
        missed = true;
        if (!breaks_inside(arc, ends[interval], ends[interval + 1], new_ends)) worst = std::max(worst, error);
      }
      if (worst > 0) segments.least_counts[s] = raised_count(static_cast<int>(interval - first), worst);
    }
    insert_ends(segments, new_ends);
    return missed;
  }

  bool breaks_inside(int arc, double low, double high, std::vector<double>& found) const {
    const std::size_t before = found.size();
    for (const double b : breaks_[arc])
      if (b > low + same_fraction && b < high - same_fraction) found.push_back(b);
    return found.size() > before;
  }

  /// The error of a smooth interval falls with its length to the power N + 1.
  int raised_count(int count, double error) const {
    const double factor = std::min(4.0, 1.02 * std::pow(error / options_.tolerance, 1.0 / (options_.order + 1)));
    return std::max(count + 1, static_cast<int>(std::ceil(count * factor - 1e-6)));
  }

  static void insert_ends(ArcSegments& segments, const std::vector<double>& new_ends) {
    for (const double end : new_ends) {
      const auto at = std::lower_bound(segments.ends.begin(), segments.ends.end(), end);
      segments.least_counts.insert(segments.least_counts.begin() + (at - segments.ends.begin()), 1);
      segments.least_counts[at - segments.ends.begin() - 1] = 1;
      segments.ends.insert(at, end);
    }
  }

  [[noreturn]] void fail(int arc, const char* wish) const {
    const Vec2 place = chains_[arc].at(0.5).position + layout_.face.origin;
    throw ComputeError(fmt::format("{} asks for more than {} elements along the arc through ({:.6g}, {:.6g})", wish,
                                   max_intervals, place.x, place.y));
  }

  const BlockLayout& layout_;
  const std::vector<Chain>& chains_;
  const DivideOptions& options_;
  std::vector<std::vector<int>> chord_arcs_;
  std::vector<int> counts_;            ///< by chord
  std::vector<ArcSegments> segments_;  ///< by arc, as the rest
  std::vector<std::vector<double>> ends_, breaks_;
};

}  // namespace

double interval_error(const Chain& chain, double low, double high, int order) {
  const ErrorSamples& samples = error_samples(order);
  std::vector<Vec2> nodes;
  for (const double xi : gll_points(order)) nodes.push_back(chain.at(between(low, high, xi)).position);
  double worst = 0;
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    Vec2 value;
    for (int k = 0; k <= order; ++k) value += samples.from_nodes(static_cast<int>(i), k) * nodes[k];
    worst = std::max(worst, distance(value, chain.at(between(low, high, samples.points[i])).position));
  }
  return worst;
}

std::vector<std::vector<double>> divide_arcs(const BlockLayout& layout, const std::vector<int>& arc_chord,
                                             const std::vector<Chain>& chains, const DivideOptions& options) {
  return Divider(layout, arc_chord, chains, options).divide();
}

}  // namespace quadrille
