#include "layers/chord_layers.hpp"

#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace quadrille::layers {
namespace {

constexpr int max_intervals = 10000;
/// A line may turn by this much, as a slope, where heights are not kept.
constexpr double greatest_turn = 0.2;
/// Intervals of arcs that ask for nothing may exceed the wanted size by this factor.
constexpr double size_slack = 1.25;
/// Beyond it arcs are as good as one.
constexpr double greatest_pull = 1e6;
/// Intervals of a crowded arc begin with at most this multiple of their mean: the shortest are then about a fifth of
/// it.
constexpr double greatest_crowding = 2.5;
constexpr double equal_tol = 1e-6;

/// Where an arc is too short for intervals as long as its neighbours', they must not become ever shorter; only layers
/// are gone on from all the same.
void uncrowd(const std::array<ArcEndWish, 2>& wishes, int count, InnerLine& rest) {
  const double most = greatest_crowding * rest.length / (count - rest.layers);
  if (wishes[0].layers() == 0) rest.ends.before = std::min(rest.ends.before, most);
  if (wishes[1].layers() == 0) rest.ends.after = std::min(rest.ends.after, most);
}

/// The fractions that these ends and the count make of an arc.
std::vector<double> arc_ends(const std::array<ArcEndWish, 2>& wishes, double length, double size, int count) {
  InnerLine rest = rest_of_arc(wishes, length, size);
  uncrowd(wishes, count, rest);
  std::vector<double> ends{0.0};
  for (const double cut : wishes[0].cuts) ends.push_back(cut);
  const int inner = count - rest.layers;
  const std::vector<double> intervals = sizing::graded_intervals(rest.ends, inner, rest.length, rest.size);
  const double low = ends.back();
  double sum = 0;
  for (int k = 0; k + 1 < inner; ++k) ends.push_back(low + (sum += intervals[k]) / length);
  for (int k = wishes[1].layers(); k-- > 0;) ends.push_back(1 - wishes[1].cuts[k]);
  ends.push_back(1);
  return ends;
}

/// Where an arc is reached from the wishes of others.
struct Reach {
  double way = std::numeric_limits<double>::infinity();
  int source = -1;  ///< position in the chord
};

class ChordPlanner {
 public:
  explicit ChordPlanner(const ChordLayersInput& input) : in_(input), growth_(chord_growth(in_.chord, in_.wishes)) {
    place_.assign(in_.measured.num_arcs(), -1);
    for (int i = 0; i < num_arcs(); ++i) place_[in_.chord.arcs[i]] = i;
    for (const int end : {0, 1}) reach_[end] = reaches(end);
  }

  std::vector<sizing::ArcDivision> divisions() const {
    const int count = least_count();
    std::vector<sizing::ArcDivision> result;
    for (int i = 0; i < num_arcs(); ++i) result.push_back({ends_of(i, count)});
    align_divisions(result);
    return result;
  }

 private:
  int num_arcs() const { return static_cast<int>(in_.chord.arcs.size()); }
  double length(int i) const { return in_.measured.length(in_.chord.arcs[i]); }
  double size(int i) const { return in_.arc_sizes[in_.chord.arcs[i]]; }
  const std::array<ArcEndWish, 2>& wishes(int i) const { return in_.wishes[in_.chord.arcs[i]]; }
  /// The arc's own end at the chord's beginning (0) or end (1).
  int own_end(int i, int chord_end) const { return in_.chord.backwards[i] ? 1 - chord_end : chord_end; }
  const ArcEndWish& wish(int i, int chord_end) const { return wishes(i)[own_end(i, chord_end)]; }

  int least_count() const {
    int count = in_.least_count;
    const auto suit = [&](const InnerLine& line) {
      count = std::max(
          count, line.layers + sizing::least_graded_count(line.ends, line.length, line.size, growth_, max_intervals));
    };
    for (const InnerLine& line : in_.lines) suit(line);
    for (int i = 0; i < num_arcs(); ++i) {
      const InnerLine rest = rest_of_arc(wishes(i), length(i), size(i));
      if (rest.ends.are_free())
        count = std::max(count, static_cast<int>(std::ceil(length(i) / (size_slack * size(i)) - equal_tol)));
      else
        suit(rest);
    }
    return std::min(count, max_intervals);
  }

  bool has_layers(int chord_end) const {
    for (int i = 0; i < num_arcs(); ++i)
      if (wish(i, chord_end).layers() > 0) return true;
    return false;
  }

  /// The shortest ways along the blocks from arcs that have layers, or else wishes, at this end of the chord.
  std::vector<Reach> reaches(int chord_end) const {
    std::vector<Reach> reach(num_arcs());
    const bool any_layers = has_layers(chord_end);
    for (int i = 0; i < num_arcs(); ++i)
      if (any_layers ? wish(i, chord_end).layers() > 0 : !wish(i, chord_end).is_empty()) reach[i] = {0, i};
    for (bool changed = true; changed;) {
      changed = false;
      for (const std::array<HalfEdge, 4>& sides : in_.measured.blocks().block2arcs)
        for (int k = 0; k < 2; ++k) {
          const int a = place_[sides[k].arc], b = place_[sides[k + 2].arc];
          if (a < 0 || b < 0 || a == b) continue;
          const double way = way_across(sides, k);
          changed |= shorten(reach[b], reach[a], way, chord_end) | shorten(reach[a], reach[b], way, chord_end);
        }
    }
    return reach;
  }

  /// Of equally long ways that from the finer wish counts.
  bool shorten(Reach& to, const Reach& from, double way, int chord_end) const {
    if (from.source < 0) return false;
    const double longer = from.way + way;
    if (longer > to.way * (1 + equal_tol)) return false;
    const bool is_shorter = longer < to.way * (1 - equal_tol);
    if (!is_shorter && start_size(from.source, chord_end) >= (1 - equal_tol) * start_size(to.source, chord_end))
      return false;
    to = {longer, from.source};
    return true;
  }

  /// Mean length of the sides that lead from one arc to the other.
  double way_across(const std::array<HalfEdge, 4>& sides, int k) const {
    return (in_.measured.length(sides[k + 1].arc) + in_.measured.length(sides[(k + 3) % 4].arc)) / 2;
  }

  void align_divisions(std::vector<sizing::ArcDivision>& divisions) const {
    const int count = static_cast<int>(divisions.front().ends.size());
    Eigen::MatrixXd wanted(num_arcs(), count);
    for (int i = 0; i < num_arcs(); ++i) {
      const auto [low, high] = free_part(i, divisions[i].ends);
      for (int k = 0; k < count; ++k)
        wanted(i, k) = (chord_parameter(i, divisions[i].ends[own_step(i, k, count)]) - low) / (high - low);
    }
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(pulls());
    const Eigen::MatrixXd drawn = solver.solve(wanted);
    for (int i = 0; i < num_arcs(); ++i) {
      const auto [low, high] = free_part(i, divisions[i].ends);
      for (int k = wish(i, 0).layers() + 1; k + 1 < count - wish(i, 1).layers(); ++k)
        divisions[i].ends[own_step(i, k, count)] = arc_fraction(i, low + drawn(i, k) * (high - low));
    }
  }

  /// The chord's parameters between which arc i is free of layers.
  std::pair<double, double> free_part(int i, const std::vector<double>& ends) const {
    const int count = static_cast<int>(ends.size()), low = wish(i, 0).layers(), high = wish(i, 1).layers();
    return {chord_parameter(i, ends[own_step(i, low, count)]),
            chord_parameter(i, ends[own_step(i, count - 1 - high, count)])};
  }

  /// Between arcs with the same layers: others have different lines beside each other. Layered arcs are
  /// rather left as they grow, unless the chord has to be aligned.
  Eigen::SparseMatrix<double> pulls() const {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < num_arcs(); ++i) entries.emplace_back(i, i, 1.0);
    for (const std::array<HalfEdge, 4>& sides : in_.measured.blocks().block2arcs)
      for (int k = 0; k < 2; ++k) {
        const int a = place_[sides[k].arc], b = place_[sides[k + 2].arc];
        if (a < 0 || b < 0 || a == b) continue;
        if (wish(a, 0).layers() != wish(b, 0).layers() || wish(a, 1).layers() != wish(b, 1).layers()) continue;
        const bool is_layered = wish(a, 0).layers() + wish(a, 1).layers() > 0;
        const bool is_free = !is_layered || is_aligned(a) || is_aligned(b);
        const double slenderness = (length(a) + length(b)) / ((is_free ? 4 : 8) * way_across(sides, k));
        const double pull = std::min(greatest_pull, std::pow(slenderness, 4));
        for (const int i : {a, b}) {
          entries.emplace_back(i, i, pull);
          entries.emplace_back(i, a + b - i, -pull);
        }
      }
    Eigen::SparseMatrix<double> matrix(num_arcs(), num_arcs());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  bool is_aligned(int i) const { return !in_.measured.parameter(in_.chord.arcs[i]).is_identity(); }
  int own_step(int i, int k, int count) const { return in_.chord.backwards[i] ? count - 1 - k : k; }
  double chord_parameter(int i, double fraction) const { return in_.measured.chord_parameter(in_.chord, i, fraction); }
  double arc_fraction(int i, double u) const { return in_.measured.arc_fraction(in_.chord, i, u); }

  /// What would stand before the first interval of an arc that begins like this one.
  double start_size(int i, int chord_end) const {
    const ArcEndWish& w = wish(i, chord_end);
    return w.cuts.empty() ? w.before : w.cuts.front() * length(i) / w.growth;
  }

  std::vector<double> ends_of(int i, int count) const {
    std::array<ArcEndWish, 2> kept = wishes(i);
    double way = std::numeric_limits<double>::infinity();
    for (const int chord_end : {0, 1}) {
      const Reach& reach = reach_[chord_end][i];
      ArcEndWish& own = kept[own_end(i, chord_end)];
      if (reach.source < 0 || reach.source == i) continue;
      const double start = start_size(reach.source, chord_end);
      own.before = own.is_empty() ? start : std::min(own.before, start);
      own.growth = growth_;
      way = std::min(way, reach.way);
    }
    std::vector<double> free = arc_ends(wishes(i), length(i), size(i), count);
    if (!std::isfinite(way)) return free;
    const std::vector<double> like_the_wall = arc_ends(kept, length(i), size(i), count);
    double shift = 0;
    for (std::size_t k = 0; k < free.size(); ++k)
      shift = std::max(shift, std::abs(free[k] - like_the_wall[k]) * length(i));
    const double weight = shift > 0 ? std::min(1.0, greatest_turn * way / shift) : 1;
    for (std::size_t k = 1; k + 1 < free.size(); ++k) free[k] = weight * free[k] + (1 - weight) * like_the_wall[k];
    return free;
  }

  const ChordLayersInput& in_;
  double growth_;
  std::vector<int> place_;  ///< in the chord, by arc
  std::array<std::vector<Reach>, 2> reach_;
};

}  // namespace

InnerLine rest_of_arc(const std::array<ArcEndWish, 2>& wishes, double length, double size) {
  const auto top = [](const ArcEndWish& w) { return w.cuts.empty() ? 0 : w.cuts.back(); };
  return {{wishes[0].before, wishes[1].before},
          (1 - top(wishes[0]) - top(wishes[1])) * length,
          size,
          wishes[0].layers() + wishes[1].layers()};
}

double chord_growth(const mesh::Chord& chord, const ArcWishes& wishes) {
  double least = 0;
  for (const int arc : chord.arcs)
    for (const ArcEndWish& w : wishes[arc])
      if (!w.is_empty()) least = least > 0 ? std::min(least, w.growth) : w.growth;
  return least;
}

std::vector<sizing::ArcDivision> layered_divisions(const ChordLayersInput& input) {
  return ChordPlanner(input).divisions();
}

}  // namespace quadrille::layers
