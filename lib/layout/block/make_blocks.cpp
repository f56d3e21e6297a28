#include "block/make_blocks.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <set>
#include <utility>

#include "base/bracketed_root.hpp"
#include "base/message_text.hpp"
#include "base/warning_codes.hpp"
#include "block/extract_blocks.hpp"
#include "block/report_layout.hpp"
#include "curve/least_squares_spline.hpp"
#include "curve/nurbs.hpp"
#include "graph/arc_pieces.hpp"
#include "mesh/chords.hpp"
#include "surface/positions.hpp"

namespace quadrille::block {
namespace {

struct CutConstants {
  double fit_tolerance = 1e-9;   // relative to the face's diameter
  double anchor_weight = 1e-2;   // w_0
  double periodic_weight = 1e4;  // of equal fractions of periodic arcs, over the greatest other weight
  double least_fraction = 0.05;  // of an arc, on either side of the cut
};
constexpr CutConstants cut_constants{};

/// The distance by which b's point lies ahead of a's, times the length of the sum of tangents.
double lead(const DirectedCurve& a, const DirectedCurve& b, double middle, double d) {
  const curve::ChainPoint p = a.at(middle - d / 2), q = b.at(middle + d / 2);
  return dot(q.position - p.position, p.tangent + q.tangent);
}

/// A block of the chord: its sides `side` and `side + 2` are cut.
struct Crossing {
  int block = 0, side = 0;
};

bool may_be_cut(const BlockLayout& layout, int chord) {
  for (std::size_t a = 0; a < layout.arcs.size(); ++a)
    if (layout.arc_chord[a] == chord && layout.arcs[a].length > 0) return false;
  return true;
}

std::vector<Crossing> blocks_of_chord(const BlockLayout& layout, int chord) {
  std::vector<Crossing> crossings;
  for (int b = 0; b < layout.num_blocks(); ++b)
    for (int k = 0; k < 2; ++k)
      if (layout.arc_chord[layout.block2arcs[b][k].arc] == chord) crossings.push_back({b, k});
  return crossings;
}

bool crosses_itself(const std::vector<Crossing>& crossings) {
  for (std::size_t i = 1; i < crossings.size(); ++i)
    if (crossings[i].block == crossings[i - 1].block) return true;
  return false;
}

/// The fractions f_i of the chord's arcs, in the chord's direction.
std::vector<double> cut_fractions(const BlockLayout& layout, const BlockMaps& maps, const mesh::Chord& chord,
                                  const std::vector<Crossing>& crossings) {
  const int n = static_cast<int>(chord.arcs.size());
  std::vector<int> arc2index(layout.arcs.size(), -1);
  for (int i = 0; i < n; ++i) arc2index[chord.arcs[i]] = i;
  std::vector<std::array<int, 2>> periodic;  // pairs of the chord's arcs that are cut at the same fraction
  for (const auto& [first, second] : matched_arcs(layout))
    if (arc2index[first.arc] >= 0) periodic.push_back({arc2index[first.arc], arc2index[second.arc]});
  const auto walk = [&](int i) { return DirectedCurve{&maps.arc(chord.arcs[i]), chord.backwards[i]}; };
  Eigen::VectorXd f = Eigen::VectorXd::Constant(n, 0.5);
  for (int round = 0; round < 4; ++round) {  // d depends on the middle, but weakly
    Eigen::MatrixXd normal = cut_constants.anchor_weight * Eigen::MatrixXd::Identity(n, n);
    Eigen::VectorXd right = Eigen::VectorXd::Constant(n, cut_constants.anchor_weight / 2);
    for (const Crossing& c : crossings) {
      const std::array<HalfEdge, 4>& sides = layout.block2arcs[c.block];
      const int i = arc2index[sides[c.side].arc], j = arc2index[sides[c.side + 2].arc];
      if (i == j) continue;
      const double length = maps.arc(sides[c.side].arc).length() + maps.arc(sides[c.side + 2].arc).length();
      const double width = maps.arc(sides[c.side + 1].arc).length() + maps.arc(sides[(c.side + 3) % 4].arc).length();
      const double d = opposite_point_offset(walk(i), walk(j), (f[i] + f[j]) / 2).value_or(f[j] - f[i]);
      const double w = length * length / (width * width);
      normal(i, i) += w, normal(j, j) += w, normal(i, j) -= w, normal(j, i) -= w;
      right[j] += w * d, right[i] -= w * d;
    }
    const double stiffness = cut_constants.periodic_weight * normal.maxCoeff();
    for (const auto& [i, j] : periodic) {
      normal(i, i) += stiffness, normal(j, j) += stiffness, normal(i, j) -= stiffness, normal(j, i) -= stiffness;
    }
    f = normal.ldlt().solve(right);
    for (int i = 0; i < n; ++i) f[i] = std::clamp(f[i], cut_constants.least_fraction, 1 - cut_constants.least_fraction);
    for (const auto& [i, j] : periodic) f[i] = f[j] = (f[i] + f[j]) / 2;
  }
  return {f.data(), f.data() + n};
}

/// z times w as complex numbers, and z / w.
Vec2 times(Vec2 z, Vec2 w) { return {z.x * w.x - z.y * w.y, z.x * w.y + z.y * w.x}; }
Vec2 over(Vec2 z, Vec2 w) { return times(z, {w.x, -w.y}) / norm2(w); }

/// Whether curve(t) is the segment from curve(0) to curve(1), t the fraction of its length.
template <typename Curve>
bool is_straight(const Curve& curve, double tolerance) {
  constexpr int samples = 16;
  const Vec2 from = curve(0), to = curve(1);
  for (int i = 1; i < samples; ++i) {
    const double t = static_cast<double>(i) / samples;
    if (distance(curve(t), (1 - t) * from + t * to) > tolerance) return false;
  }
  return true;
}

/// A curve between `from` and `to` with the shape of `side` in the same direction: rotated and scaled to fit.
Vec2 like_side(const DirectedCurve& side, Vec2 from, Vec2 to, double t) {
  const Vec2 begin = side.at(0).position, end = side.at(1).position;
  return from + times(over(side.at(t).position - begin, end - begin), to - from);
}

Nurbs cut_curve(const BlockLayout& layout, const BlockMaps& maps, const Crossing& c, double f, double g, bool sound) {
  const std::array<HalfEdge, 4>& sides = layout.block2arcs[c.block];
  const auto side = [&](int k) { return DirectedCurve{&maps.arc(sides[k % 4].arc), sides[k % 4].is_backwards}; };
  const Vec2 from = side(c.side).at(f).position, to = side(c.side + 2).at(1 - g).position;
  const DirectedCurve right = side(c.side + 1);
  DirectedCurve left = side(c.side + 3);
  left.backwards = !left.backwards;
  const mesh::TransfiniteMap map = maps.map(c.block);
  const auto position = [&](double t) -> Vec2 {
    if (t == 0) return from;
    if (t == 1) return to;
    const double s = f + t * (g - f);
    if (sound) return c.side == 0 ? map.position(s, t) : map.position(1 - t, s);
    return (1 - s) * like_side(left, from, to, t) + s * like_side(right, from, to, t);
  };
  const double length = distance(from, to), tolerance = cut_constants.fit_tolerance * layout.face.diameter;
  if (is_straight(position, tolerance))
    return curve::segment(from, to);  // a spline of a tiny length would consist of rounding errors
  const curve::CurveFunction curve = [&](double x, Vec2& derivative) {
    constexpr double h = 1e-4;
    const double t = std::min(x / length, 1.0), low = std::max(t - h, 0.0), high = std::min(t + h, 1.0);
    const double middle = (low + high) / 2;  // one-sided at the ends, of second order
    const Vec2 a = position(low), b = position(middle), d = position(high);
    const double at = (t - middle) / (high - low);  // -1/2, 0 or 1/2
    derivative = ((d - a) + 4 * at * (a - 2 * b + d)) / ((high - low) * length);
    return position(t);
  };
  return curve::fit_line(curve, length, tolerance);
}

/// The fraction of a half-edge of which `fractions` has that of its arc.
double along(HalfEdge h, const std::vector<double>& fractions) {
  return h.is_backwards ? 1 - fractions[h.arc] : fractions[h.arc];
}

/// By arc of the layout, along the arc: the fraction at which the cut meets it.
std::vector<double> arc_fractions(const BlockLayout& layout, const BlockMaps& maps, const mesh::Chord& chord,
                                  const std::vector<Crossing>& crossings) {
  const std::vector<double> fractions = cut_fractions(layout, maps, chord, crossings);
  std::vector<double> by_arc(layout.arcs.size(), 0);
  for (std::size_t i = 0; i < chord.arcs.size(); ++i)
    by_arc[chord.arcs[i]] = chord.backwards[i] ? 1 - fractions[i] : fractions[i];
  return by_arc;
}

constexpr int most_rounds = 4;

constexpr double poor_shape = 0.1;  // scaled Jacobian

bool is_proved(const BlockMeasure& m) { return m.divisions > 0; }
bool is_good(const BlockMeasure& m) { return is_proved(m) && m.map_scaled_jacobian >= poor_shape; }

/// Number of blocks that are not proved valid, and number of bad blocks.
std::pair<int, int> faults(const std::vector<BlockMeasure>& measures) {
  std::pair<int, int> count{0, 0};
  for (const BlockMeasure& m : measures) count.first += !is_proved(m), count.second += !is_good(m);
  return count;
}

/// The sides of a block that are cut. The exact map of a strip folds unless its long sides are cut; that of a block
/// around a nose, whose sides leave the nose at right angles, unless the cut begins there, whichever sides are longer.
enum class CutSides { longer, shorter };

/// One arc of every chord that runs across these sides of a bad block.
std::set<int> arcs_to_cut(const Blocks& blocks, CutSides cut) {
  const BlockMaps maps(blocks.layout);
  std::set<int> chords, arcs;
  for (int b = 0; b < blocks.layout.num_blocks(); ++b) {
    if (is_good(blocks.measures[b])) continue;
    const std::array<HalfEdge, 4>& sides = blocks.layout.block2arcs[b];
    const auto length = [&](int k) { return maps.arc(sides[k].arc).length(); };
    const bool is_longer = length(0) + length(2) >= (1 - 1e-6) * (length(1) + length(3));
    const int arc = sides[is_longer == (cut == CutSides::longer) ? 0 : 1].arc;
    if (chords.insert(blocks.layout.arc_chord[arc]).second) arcs.insert(arc);
  }
  return arcs;
}

/// The blocks of a subdivision, measured.
struct Trial {
  graph::Subdivision subdivision;
  Progress* progress = nullptr;
  Blocks blocks = {};

  void measure() {
    BlockLayout layout = blocks_of(subdivision);
    std::vector<BlockMeasure> measures = measure_blocks(layout, progress, blocks);
    blocks = {std::move(layout), std::move(measures)};
  }
};

/// Cuts each of these chords once. Returns false if none can be cut.
bool cut_once(Trial& trial, CutSides cut) {
  std::vector<bool> sound;
  for (const BlockMeasure& m : trial.blocks.measures) sound.push_back(is_good(m));
  bool has_cut = false;
  for (const int arc : arcs_to_cut(trial.blocks, cut)) {
    has_cut |= split_chord(trial.subdivision, arc, sound);
    sound.resize(trial.subdivision.face_bound(), false);
  }
  if (has_cut) trial.measure();
  return has_cut;
}

/// Cuts the chords of bad blocks again and again, as long as it helps; `best`: the blocks with the fewest faults.
void cut_bad_blocks(Trial trial, CutSides cut, Blocks& best) {
  const Progress::Part rounds(trial.progress, "round");
  int in_vain = 0;
  for (int round = 0; round < most_rounds && in_vain < 2; ++round) {
    rounds.advance();
    if (faults(trial.blocks.measures).second == 0 || !cut_once(trial, cut)) break;
    const bool helps = faults(trial.blocks.measures) < faults(best.measures);
    if (helps) best = trial.blocks;
    in_vain = helps ? 0 : in_vain + 1;
  }
}

void warn_of_invalid(const Blocks& blocks, Report& report) {
  int num_unproved = 0, worst = -1;
  for (int b = 0; b < blocks.layout.num_blocks(); ++b) {
    if (is_proved(blocks.measures[b])) continue;
    ++num_unproved;
    if (worst < 0 || blocks.measures[b].scaled_jacobian < blocks.measures[worst].scaled_jacobian) worst = b;
  }
  if (num_unproved == 0) return;
  const std::string others = num_unproved > 1 ? fmt::format(" ({} blocks; this one is the worst)", num_unproved) : "";
  report.warn(
      warning::block_not_proved_valid,
      fmt::format("{} cannot be proved valid near {}: its exact map folds there, or nearly so{}",
                  blocks.layout.block_names[worst],
                  surface::position_text(blocks.layout.face, blocks.measures[worst].scaled_jacobian_position), others));
}

}  // namespace

std::optional<double> opposite_point_offset(const DirectedCurve& a, const DirectedCurve& b, double middle) {
  constexpr int steps = 64;
  const double widest = 2 * (std::min(middle, 1 - middle) - cut_constants.least_fraction);
  const double at_zero = lead(a, b, middle, 0);
  if (at_zero == 0) return 0;
  const double direction = at_zero > 0 ? -1 : 1;
  double low = 0;
  for (int i = 1; i <= steps; ++i) {
    const double high = widest * i / steps;
    const auto lead_at = [&](double d) { return lead(a, b, middle, direction * d) * at_zero; };
    if (lead_at(high) <= 0) return direction * bisect(lead_at, low, high);
    low = high;
  }
  return std::nullopt;
}

bool split_chord(graph::Subdivision& subdivision, int arc, const std::vector<bool>& is_sound) {
  // All measures are taken before the subdivision is changed.
  const BlockLayout layout = blocks_of(subdivision);
  const int id = layout.arc_chord[arc];
  const std::vector<Crossing> crossings = blocks_of_chord(layout, id);
  if (!may_be_cut(layout, id) || crosses_itself(crossings)) return false;
  const mesh::Chord chord = mesh::directed_chords(layout.block2arcs, layout.arc_chord, matched_arcs(layout))[id];
  const BlockMaps maps(layout);
  const std::vector<double> fractions = arc_fractions(layout, maps, chord, crossings);
  std::vector<int> second(layout.arcs.size(), -1);  // part of each divided arc
  for (const int a : chord.arcs)
    second[a] = graph::divide_at_point(subdivision, {a}, maps.arc(a).at(fractions[a])).second.arc;
  const auto first_part = [&](HalfEdge h) { return HalfEdge{h.is_backwards ? second[h.arc] : h.arc, h.is_backwards}; };
  for (const Crossing& c : crossings) {
    const HalfEdge near = layout.block2arcs[c.block][c.side], far = layout.block2arcs[c.block][c.side + 2];
    Nurbs cut = cut_curve(layout, maps, c, along(near, fractions), 1 - along(far, fractions), is_sound[c.block]);
    const double begin = cut.begin(), end = cut.end();
    const int curve = subdivision.add_spline(std::move(cut));
    subdivision.insert_arc({first_part(near)}, {first_part(far)}, {{curve, begin, end}});
  }
  return true;
}

Blocks split_bad_chords(graph::Subdivision subdivision, Report& report) {
  const int blocks_before = subdivision.num_faces();
  Trial whole{std::move(subdivision), report.progress()};
  whole.measure();
  Blocks best = whole.blocks;
  cut_bad_blocks(whole, CutSides::longer, best);
  if (faults(best.measures).first > 0) cut_bad_blocks(std::move(whole), CutSides::shorter, best);
  store_measures(best.measures, best.layout);
  report.set("blocks_added_to_mend", best.layout.num_blocks() - blocks_before);
  warn_of_invalid(best, report);
  return best;
}

Blocks make_blocks(const SeparatrixGraph& graph, Report& report) {
  Blocks blocks = split_bad_chords(subdivision_into_blocks(graph), report);
  blocks.layout.provenance = graph.provenance;
  report_layout(blocks.layout, blocks.measures, report);
  return blocks;
}

BlockLayout extract_blocks(const SeparatrixGraph& graph, Report& report) { return make_blocks(graph, report).layout; }

}  // namespace quadrille::block
