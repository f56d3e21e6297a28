#include "block/split_chord.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "block/block_maps.hpp"
#include "block/extract_blocks.hpp"
#include "block/opposite_points.hpp"
#include "curve/fit_line.hpp"
#include "curve/nurbs.hpp"
#include "graph/divide_at_point.hpp"
#include "mesh/chords.hpp"

namespace quadrille::block {
namespace {

constexpr double fit_tolerance = 1e-9;   // relative to the face's diameter
constexpr double anchor_weight = 1e-2;   // w_0
constexpr double periodic_weight = 1e4;  // of equal fractions of periodic arcs, over the greatest other weight
constexpr double least_fraction = 0.05;  // fraction of an arc, on either side of the cut

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
    Eigen::MatrixXd normal = anchor_weight * Eigen::MatrixXd::Identity(n, n);
    Eigen::VectorXd right = Eigen::VectorXd::Constant(n, anchor_weight / 2);
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
    const double stiffness = periodic_weight * normal.maxCoeff();
    for (const auto& [i, j] : periodic) {
      normal(i, i) += stiffness, normal(j, j) += stiffness, normal(i, j) -= stiffness, normal(j, i) -= stiffness;
    }
    f = normal.ldlt().solve(right);
    for (int i = 0; i < n; ++i) f[i] = std::clamp(f[i], least_fraction, 1 - least_fraction);
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
  const double length = distance(from, to), tolerance = fit_tolerance * layout.face.diameter;
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

}  // namespace

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

}  // namespace quadrille::block
