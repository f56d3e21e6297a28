#include "block/split_chord.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "block/opposite_points.hpp"
#include "curve/fit_line.hpp"
#include "curve/nurbs.hpp"
#include "mesh/chords.hpp"

namespace quadrille::block {
namespace {

constexpr double fit_tolerance = 1e-9;   // relative to the face's diameter
constexpr double anchor_weight = 1e-2;   // w_0
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

std::vector<Crossing> blocks_of(const BlockLayout& layout, int chord) {
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
    f = normal.ldlt().solve(right);
    for (int i = 0; i < n; ++i) f[i] = std::clamp(f[i], least_fraction, 1 - least_fraction);
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

/// Divides an arc at the fraction f in its own direction: it keeps the first part. Returns the number of the second.
int divide_arc(BlockLayout& layout, const curve::Chain& chain, int id, double f) {
  curve::ChainPoint at = chain.at(f);
  std::vector<ArcPiece> pieces = layout.arcs[id].pieces;
  const ArcPiece& piece = pieces[at.piece];
  const double tiny = 1e-9 * std::abs(piece.t1 - piece.t0);
  if (std::abs(at.t - piece.t1) <= tiny && at.piece + 1 < static_cast<int>(pieces.size()))
    ++at.piece, at.t = pieces[at.piece].t0;
  const bool at_joint = at.piece > 0 && std::abs(at.t - pieces[at.piece].t0) <= tiny;
  if (at_joint) at.t = pieces[at.piece].t0;
  const bool is_boundary = layout.arcs[id].is_boundary;
  const int node = static_cast<int>(layout.nodes.size()), second = static_cast<int>(layout.arcs.size());
  layout.nodes.push_back({at.position, is_boundary ? NodeKind::boundary : NodeKind::crossing, is_boundary ? 2 : 4,
                          is_boundary ? pieces[at.piece].curve : -1, is_boundary ? at.t : 0});
  layout.arcs.push_back({node, layout.arcs[id].to, is_boundary, 0, {}});
  GraphArc &before = layout.arcs[id], &after = layout.arcs[second];
  before.to = node;
  before.pieces.assign(pieces.begin(), pieces.begin() + at.piece + (at_joint ? 0 : 1));
  after.pieces.assign(pieces.begin() + at.piece, pieces.end());
  if (!at_joint) before.pieces.back().t1 = after.pieces.front().t0 = at.t;
  return second;
}

/// The two parts of a half-edge, in its direction.
std::array<HalfEdge, 2> parts(HalfEdge h, int second) {
  const HalfEdge other{second, h.is_backwards};
  return h.is_backwards ? std::array{other, h} : std::array{h, other};
}

void divide_block(BlockLayout& layout, const Crossing& c, const std::vector<int>& second, int cut) {
  const int k0 = c.side, k1 = k0 + 1, k2 = k0 + 2, k3 = (k0 + 3) % 4;
  const std::array<int, 4> nodes = layout.block2nodes[c.block];
  const std::array<HalfEdge, 4> sides = layout.block2arcs[c.block];
  const std::array<HalfEdge, 2> near = parts(sides[k0], second[sides[k0].arc]);
  const std::array<HalfEdge, 2> far = parts(sides[k2], second[sides[k2].arc]);
  const int p = layout.arcs[cut].from, q = layout.arcs[cut].to;
  std::array<int, 4> left_nodes = nodes, right_nodes = nodes;
  std::array<HalfEdge, 4> left = sides, right = sides;
  left_nodes[k1] = p, left_nodes[k2] = q;
  left[k0] = near[0], left[k1] = {cut}, left[k2] = far[1];
  right_nodes[k0] = p, right_nodes[k3] = q;
  right[k0] = near[1], right[k2] = far[0], right[k3] = {cut, true};
  layout.block2nodes[c.block] = left_nodes, layout.block2arcs[c.block] = left;
  layout.block2nodes.push_back(right_nodes), layout.block2arcs.push_back(right);
  layout.unnamed_blocks.push_back(layout.num_blocks() - 1);
  layout.block_names.push_back(fmt::format("block_{}", layout.num_blocks() - 1));
}

}  // namespace

bool split_chord(BlockLayout& layout, int id, const std::vector<bool>& is_sound) {
  const std::vector<Crossing> crossings = blocks_of(layout, id);
  if (!may_be_cut(layout, id) || crosses_itself(crossings)) return false;
  const mesh::Chord chord = mesh::directed_chords(layout.block2arcs, layout.arc_chord)[id];
  // All measures are taken before the layout is changed.
  const BlockLayout before = layout;
  const BlockMaps maps(before);
  const std::vector<double> fractions = cut_fractions(before, maps, chord, crossings);
  std::vector<double> own(before.arcs.size(), 0);  // along the arc's own direction
  for (std::size_t i = 0; i < chord.arcs.size(); ++i)
    own[chord.arcs[i]] = chord.backwards[i] ? 1 - fractions[i] : fractions[i];
  std::vector<int> second(before.arcs.size(), -1);
  for (const int a : chord.arcs) second[a] = divide_arc(layout, maps.arc(a), a, own[a]);
  for (const Crossing& c : crossings) {
    const HalfEdge near = before.block2arcs[c.block][c.side], far = before.block2arcs[c.block][c.side + 2];
    const double f = near.is_backwards ? 1 - own[near.arc] : own[near.arc];
    const double g = far.is_backwards ? own[far.arc] : 1 - own[far.arc];
    layout.splines.push_back(cut_curve(before, maps, c, f, g, is_sound[c.block]));
    const Nurbs& spline = layout.splines.back();
    const int curve = layout.face.num_curves() + static_cast<int>(layout.splines.size()) - 1;
    layout.arcs.push_back({layout.arcs[second[near.arc]].from,
                           layout.arcs[second[far.arc]].from,
                           false,
                           0,
                           {{curve, spline.begin(), spline.end()}}});
    divide_block(layout, c, second, static_cast<int>(layout.arcs.size()) - 1);
  }
  layout.arc_chord = mesh::arc_chords(layout.block2arcs, static_cast<int>(layout.arcs.size()));
  return true;
}

}  // namespace quadrille::block
