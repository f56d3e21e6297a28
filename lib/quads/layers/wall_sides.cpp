#include "layers/wall_sides.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/tolerance.hpp"
#include "curve/gauss.hpp"
#include "curve/nurbs.hpp"
#include "layers/layer_rules.hpp"
#include "mesh/chords.hpp"
#include "model/interfaces.hpp"

namespace quadrille::layers {
namespace {

/// Decides between specs of one wall, and records those that were overruled.
struct FinestSpec {
  const std::vector<WallSpec>& specs;
  std::set<std::array<int, 2>> overruled = {};

  /// Whether a has the smaller first height; of equal ones the spec given first. b = -1: none.
  bool is_finer(int a, int b) const {
    const double tol = tolerance::tied;
    return b < 0 || specs[a].first < (1 - tol) * specs[b].first ||
           (specs[a].first <= (1 + tol) * specs[b].first && a < b);
  }
  void overrule(int loser, int winner) { overruled.insert({loser, winner}); }
};

/// The finest of the specs of the curves that the side of a block follows, -1 for none. On an interface these are the
/// curves of the block's own region.
int spec_of_side(const BlockLayout& layout, const std::vector<int>& curve_spec, HalfEdge side, FinestSpec& choice) {
  int spec = -1;
  const GraphArc& arc = layout.arcs[side.arc];
  if (!is_on_cad_curve(layout, arc)) return spec;
  for (const ArcPiece& piece : arc.pieces) {
    const bool is_own_curve =
        arc.is_boundary || !layout.face.is_interface(piece.curve) || side.is_backwards != (piece.t0 < piece.t1);
    const int other = curve_spec[is_own_curve ? piece.curve : layout.face.partners[piece.curve]];
    if (other < 0 || other == spec) continue;
    const bool is_finer = choice.is_finer(other, spec);
    if (spec >= 0) choice.overrule(is_finer ? spec : other, is_finer ? other : spec);
    if (is_finer) spec = other;
  }
  return spec;
}

void append_pieces(const BlockLayout& layout, const mesh::BlockSide& side, std::vector<ArcPiece>& pieces) {
  const HalfEdge half = mesh::half_edge(layout, side.block, side.side);
  std::vector<ArcPiece> own = layout.arcs[half.arc].pieces;
  if (half.is_backwards) {
    std::reverse(own.begin(), own.end());
    for (ArcPiece& piece : own) std::swap(piece.t0, piece.t1);
  }
  pieces.insert(pieces.end(), own.begin(), own.end());
}

std::vector<ArcPiece> pieces_of(const BlockLayout& layout, const mesh::BlockSide& side) {
  std::vector<ArcPiece> pieces;
  append_pieces(layout, side, pieces);
  return pieces;
}

/// Whether a side ends (step +1) or begins (-1) at a corner with V = 1 whose other side rises steeply enough from its
/// straight continuation.
bool extends_beyond(const BlockLayout& layout, const curve::CurveTable& table, const mesh::BlockSide& side, int step) {
  const mesh::BlockSide beside{side.block, (side.side + 4 + step) % 4};
  if (!layout.arcs[mesh::half_edge(layout, beside.block, beside.side).arc].is_boundary) return false;
  const std::vector<ArcPiece> own = pieces_of(layout, side), other = pieces_of(layout, beside);
  const bool at_end = step > 0;
  return cross(direction(table, at_end ? own.back() : other.back(), true),
               direction(table, at_end ? other.front() : own.front(), false)) >= layer_constants.least_corner_sine;
}

/// Whether the wall turns away from the blocks between a side and the one that continues it (step as above).
bool turns_away(const BlockLayout& layout, const curve::CurveTable& table, const mesh::BlockSide& side,
                const mesh::BlockSide& next, int step) {
  if (next.block < 0) return false;
  const mesh::BlockSide &first = step > 0 ? side : next, &second = step > 0 ? next : side;
  return cross(direction(table, pieces_of(layout, first).back(), true),
               direction(table, pieces_of(layout, second).front(), false)) < -layer_constants.least_bend;
}

WallSide make_wall_side(const BlockLayout& layout, const curve::CurveTable& table, const mesh::ArcSides& arc_sides,
                        const mesh::BlockSide& side, const WallSpec& spec, int number,
                        const std::shared_ptr<const sizing::ChartScale>& scale) {
  WallSide wall{side.block, side.side, number, {}, {}, {}, 0};
  std::vector<ArcPiece> pieces;
  mesh::BlockSide before = mesh::next_along_boundary(layout, arc_sides, side, -1),
                  after = mesh::next_along_boundary(layout, arc_sides, side, 1);
  const bool ends_before = spec.own_blocks && turns_away(layout, table, side, before, -1),
             ends_after = spec.own_blocks && turns_away(layout, table, side, after, 1);
  if (ends_before) before = {};
  if (ends_after) after = {};
  if (before.block >= 0) append_pieces(layout, before, pieces);
  const int first = static_cast<int>(pieces.size());
  append_pieces(layout, side, pieces);
  wall.begin = {first, pieces[first].t0};
  wall.end = {static_cast<int>(pieces.size()) - 1, pieces.back().t1};
  if (after.block >= 0) append_pieces(layout, after, pieces);
  wall.line = WallLine(table, std::move(pieces), scale);
  if (ends_before || extends_beyond(layout, table, before.block < 0 ? side : before, -1)) wall.line.extend(-1);
  if (ends_after || extends_beyond(layout, table, after.block < 0 ? side : after, 1)) wall.line.extend(1);
  return wall;
}

/// By wall side: the first side of its run, the wall sides that continue each other.
std::vector<int> runs(const BlockLayout& layout, const mesh::ArcSides& arc_sides, const WallSides& walls) {
  const int count = static_cast<int>(walls.sides.size());
  DisjointSets linked(walls.sides.size());
  for (int i = 0; i < count; ++i) {
    const mesh::BlockSide next =
        mesh::next_along_boundary(layout, arc_sides, {walls.sides[i].block, walls.sides[i].side}, 1);
    const int other = next.block < 0 ? -1 : walls.of_block[next.block][next.side];
    if (other >= 0) linked.unite(i, other);
  }
  std::vector<int> run;
  for (int i = 0; i < count; ++i) run.push_back(linked.find(i));
  return run;
}

/// Gives every side of a run the finest spec of the run.
void unify_runs(const std::vector<int>& run, std::vector<WallSide>& sides, FinestSpec& choice) {
  std::vector<int> finest(run.size(), -1);
  for (std::size_t i = 0; i < run.size(); ++i) {
    int& spec = finest[run[i]];
    if (choice.is_finer(sides[i].spec, spec)) spec = sides[i].spec;
  }
  for (std::size_t i = 0; i < run.size(); ++i) {
    const int spec = finest[run[i]];
    if (spec != sides[i].spec) choice.overrule(sides[i].spec, spec);
    sides[i].spec = spec;
  }
}

/// Marks the arcs that start at both ends of a side. Where two sides continue each other the first one counts.
void mark_arcs(const BlockLayout& layout, int wall, WallSides& walls) {
  const WallSide& side = walls.sides[wall];
  for (const mesh::ArcEnd& at : {mesh::ending(mesh::half_edge(layout, side.block, side.side - 1)),
                                 mesh::beginning(mesh::half_edge(layout, side.block, side.side + 1))}) {
    int& mark = walls.at_arc_end[at.arc][at.end];
    if (mark < 0) mark = wall;
  }
}

}  // namespace

Vec2 direction(const curve::CurveTable& table, const ArcPiece& piece, bool at_end) {
  const bool forwards = piece.t0 <= piece.t1;
  const double t = at_end ? piece.t1 : piece.t0;
  const Vec2 along = curve::tangent(table.curve(piece.curve), t, forwards == at_end);
  return forwards ? along : -along;
}

WallLine::WallLine(const curve::CurveTable& table, std::vector<ArcPiece> pieces,
                   std::shared_ptr<const sizing::ChartScale> scale)
    : table_(&table), scale_(std::move(scale)), pieces_(std::move(pieces)) {
  for (std::size_t i = 0; i + 1 < pieces_.size(); ++i)
    bends_.push_back(std::abs(cross(direction(table, pieces_[i], true), direction(table, pieces_[i + 1], false))) >
                     layer_constants.least_bend);
  bends_.push_back(false);
}

WallPoint WallLine::entry(const WallPoint& foot, int step) const {
  const int piece = foot.piece + step;
  return {piece, step > 0 ? pieces_[piece].t0 : pieces_[piece].t1};
}

double WallLine::distance_at(Vec2 x, const WallPoint& foot) const {
  return quadrille::distance(x, curve::point(table_->curve(pieces_[foot.piece].curve), foot.t));
}

double WallLine::distance_beyond(Vec2 x, int step) const {
  const ArcPiece& piece = step < 0 ? pieces_.front() : pieces_.back();
  const Vec2 end = curve::point(table_->curve(piece.curve), step < 0 ? piece.t0 : piece.t1);
  return std::abs(cross(direction(*table_, piece, step > 0), x - end));
}

int WallLine::move_foot(Vec2 x, WallPoint& foot) const {
  const ArcPiece& piece = pieces_[foot.piece];
  const Nurbs& curve = table_->curve(piece.curve);
  const double low = std::min(piece.t0, piece.t1), high = std::max(piece.t0, piece.t1);
  double slope = 0;
  for (int step = 0; step < layer_constants.max_foot_steps; ++step) {
    const auto d = curve::derivatives(curve, foot.t, foot.t >= high);
    slope = dot(d[0] - x, d[1]);
    const double speed2 = norm2(d[1]), bend = speed2 + dot(d[0] - x, d[2]);
    if (speed2 == 0) break;
    // Newton where the squared distance is convex, else Gauss-Newton.
    const double next = std::clamp(foot.t - slope / (bend > 0.1 * speed2 ? bend : speed2), low, high);
    const double move = std::abs(next - foot.t);
    foot.t = next;
    if (move <= 1e-14 * (high - low)) break;
  }
  const bool forwards = piece.t0 <= piece.t1;
  if (foot.t <= low && slope > 0) return forwards ? -1 : 1;
  if (foot.t >= high && slope < 0) return forwards ? 1 : -1;
  return 0;
}

double WallLine::follow_pieces(Vec2 x, WallPoint& foot) const {
  int beyond = move_foot(x, foot);
  double nearest = distance_at(x, foot);
  while (beyond != 0) {
    if (!has_piece(foot.piece + beyond)) {
      if (is_extended_[beyond < 0 ? 0 : 1]) nearest = distance_beyond(x, beyond);
      break;
    }
    WallPoint next = entry(foot, beyond);
    const int further = move_foot(x, next);
    const double d = distance_at(x, next);
    if (d >= nearest) break;
    nearest = d, foot = next;
    if (further == -beyond) break;
    beyond = further;
  }
  return nearest;
}

double WallLine::distance(Vec2 x, WallPoint& foot) const {
  const double in_plane = distance_in_plane(x, foot);
  if (!scale_) return in_plane;
  const Vec2 at = curve::point(table_->curve(pieces_[foot.piece].curve), foot.t);
  return in_plane * curve::gauss_integral<3>([&](double u) { return scale_at(at + u * (x - at)); }, 0, 1);
}

double WallLine::distance_in_plane(Vec2 x, WallPoint& foot) const {
  double nearest = follow_pieces(x, foot);
  for (const int step : {-1, 1}) {  // in a corner of less than 180 degrees both parts have a nearest point
    const int piece = foot.piece + step;
    if (!has_piece(piece) || !bends_[std::min(piece, foot.piece)]) continue;
    WallPoint other = entry(foot, step);
    move_foot(x, other);
    const double d = distance_at(x, other);
    if (d < nearest) nearest = d, foot = other;
  }
  return nearest;
}

std::vector<LayeredEnd> WallSides::layered_ends() const {
  std::vector<LayeredEnd> ends;
  for (int arc = 0; arc < std::ssize(at_arc_end); ++arc)
    for (const int end : {0, 1})
      if (at_arc_end[arc][end] >= 0) ends.push_back({arc, end, at_arc_end[arc][end]});
  return ends;
}

WallSides find_wall_sides(const BlockLayout& layout, const curve::CurveTable& table, const std::vector<int>& curve_spec,
                          const std::vector<WallSpec>& specs, const std::shared_ptr<const sizing::ChartScale>& scale) {
  const mesh::ArcSides arc_sides = mesh::sides_of_arcs(layout);
  FinestSpec choice{specs};
  WallSides walls;
  walls.of_block.assign(layout.block2arcs.size(), {-1, -1, -1, -1});
  walls.at_arc_end.assign(layout.arcs.size(), {-1, -1});
  for (int block = 0; block < layout.num_blocks(); ++block)
    for (int side = 0; side < 4; ++side) {
      const int spec = spec_of_side(layout, curve_spec, mesh::half_edge(layout, block, side), choice);
      if (spec < 0) continue;
      walls.of_block[block][side] = static_cast<int>(walls.sides.size());
      walls.sides.push_back(make_wall_side(layout, table, arc_sides, {block, side}, specs[spec], spec, scale));
    }
  unify_runs(runs(layout, arc_sides, walls), walls.sides, choice);
  for (WallSide& wall : walls.sides) wall.own_intervals = specs[wall.spec].own_blocks ? 1 : 0;
  for (std::size_t i = 0; i < walls.sides.size(); ++i) mark_arcs(layout, static_cast<int>(i), walls);
  walls.overruled.assign(choice.overruled.begin(), choice.overruled.end());
  return walls;
}

double greatest_bend(const curve::CurveTable& table, const WallSide& wall) {
  constexpr int samples = 16;  // of each piece, at middles of equal parts
  double greatest = 0;
  for (int p = wall.begin.piece; p <= wall.end.piece; ++p) {
    const ArcPiece& piece = wall.line.pieces()[p];
    for (int k = 0; k < samples; ++k) {
      const double t = piece.t0 + (piece.t1 - piece.t0) * (k + 0.5) / samples;
      const Nurbs& curve = table.curve(piece.curve);
      const double bend = curve::curvature(curve, t) / wall.line.scale_at(curve::point(curve, t));
      greatest = std::max(greatest, piece.t0 < piece.t1 ? bend : -bend);
    }
  }
  return greatest;
}

WallPoint wall_point(const WallSide& wall, const curve::ChainPoint& on_arc, bool backwards) {
  return {backwards ? wall.end.piece - on_arc.piece : wall.begin.piece + on_arc.piece, on_arc.t};
}

}  // namespace quadrille::layers
