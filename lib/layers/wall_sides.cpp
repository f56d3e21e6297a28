#include "layers/wall_sides.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "mesh/chords.hpp"

namespace quadrille::layers {
namespace {

/// A block's side on the boundary.
struct Side {
  int block = -1, side = 0;
};

std::vector<ArcPiece> walked(const std::vector<ArcPiece>& pieces, bool backwards) {
  if (!backwards) return pieces;
  std::vector<ArcPiece> reversed(pieces.rbegin(), pieces.rend());
  for (ArcPiece& piece : reversed) std::swap(piece.t0, piece.t1);
  return reversed;
}

class Finder {
 public:
  Finder(const BlockLayout& layout, const curve::CurveTable& table, const std::vector<int>& curve_spec,
         const std::vector<WallSpec>& specs)
      : layout_(layout), table_(table), curve_spec_(curve_spec), specs_(specs), arc2sides_(layout.arcs.size()) {
    for (int block = 0; block < layout.num_blocks(); ++block)
      for (int side = 0; side < 4; ++side) arc2sides_[directed(block, side).arc].push_back({block, side});
  }

  WallSides find() {
    found_.of_block.assign(layout_.block2arcs.size(), {-1, -1, -1, -1});
    found_.at_arc_end.assign(layout_.arcs.size(), {-1, -1});
    for (int block = 0; block < layout_.num_blocks(); ++block)
      for (int side = 0; side < 4; ++side) add_side(block, side);
    settle_runs();
    for (std::size_t i = 0; i < found_.sides.size(); ++i) mark_arcs(static_cast<int>(i));
    return std::move(found_);
  }

 private:
  HalfEdge directed(int block, int side) const { return layout_.block2arcs[block][(side + 4) % 4]; }

  bool is_finer(int a, int b) const {
    return b < 0 || specs_[a].first < (1 - 1e-6) * specs_[b].first ||
           (specs_[a].first <= (1 + 1e-6) * specs_[b].first && a < b);
  }

  /// The finest of the specs of the curves that the arc follows, -1 for none.
  int spec_of(int arc) {
    int spec = -1;
    if (!layout_.arcs[arc].is_boundary) return spec;
    for (const ArcPiece& piece : layout_.arcs[arc].pieces) {
      const int other = table_.is_cad_curve(piece.curve) ? curve_spec_[piece.curve] : -1;
      if (other < 0 || other == spec) continue;
      if (spec >= 0) overrule(is_finer(other, spec) ? spec : other, is_finer(other, spec) ? other : spec);
      if (is_finer(other, spec)) spec = other;
    }
    return spec;
  }

  void overrule(int loser, int winner) { overruled_.insert({loser, winner}); }

  void add_side(int block, int side) {
    const int spec = spec_of(directed(block, side).arc);
    if (spec < 0) return;
    found_.of_block[block][side] = static_cast<int>(found_.sides.size());
    WallSide wall{block, side, spec, {}, {}, {}};
    std::vector<ArcPiece> pieces;
    const auto append = [&](int b, int s) {
      const HalfEdge d = directed(b, s);
      for (const ArcPiece& piece : walked(layout_.arcs[d.arc].pieces, d.is_backwards)) pieces.push_back(piece);
    };
    if (const Side before = next_along(block, side, -1); before.block >= 0) append(before.block, before.side);
    const int first = static_cast<int>(pieces.size());
    append(block, side);
    wall.begin = {first, pieces[first].t0};
    wall.end = {static_cast<int>(pieces.size()) - 1, pieces.back().t1};
    if (const Side after = next_along(block, side, 1); after.block >= 0) append(after.block, after.side);
    wall.line = WallLine(table_, std::move(pieces));
    found_.sides.push_back(std::move(wall));
  }

  /// The boundary side that goes on from this one beyond the arc between them (step +1: at its end, -1: at its
  /// beginning); none at corners of other valences than 2.
  Side next_along(int block, int side, int step) const {
    const HalfEdge between = directed(block, side + step);
    for (const Side& other : arc2sides_[between.arc]) {
      if (layout_.block2arcs[other.block][other.side] == between) continue;  // this block itself
      const int next = (other.side + step + 4) % 4;
      if (layout_.arcs[directed(other.block, next).arc].is_boundary) return {other.block, next};
    }
    return {};
  }

  /// One spec for each run of sides.
  void settle_runs() {
    std::vector<int> root(found_.sides.size());
    std::iota(root.begin(), root.end(), 0);
    const auto find_root = [&](int i) {
      while (root[i] != i) i = root[i];
      return i;
    };
    for (std::size_t i = 0; i < root.size(); ++i) {
      const Side next = next_along(found_.sides[i].block, found_.sides[i].side, 1);
      const int other = next.block < 0 ? -1 : found_.of_block[next.block][next.side];
      if (other < 0) continue;
      const int a = find_root(static_cast<int>(i)), b = find_root(other);
      root[std::max(a, b)] = std::min(a, b);
    }
    std::vector<int> finest(root.size(), -1);
    for (std::size_t i = 0; i < root.size(); ++i) {
      int& spec = finest[find_root(static_cast<int>(i))];
      if (is_finer(found_.sides[i].spec, spec)) spec = found_.sides[i].spec;
    }
    for (std::size_t i = 0; i < root.size(); ++i) {
      const int spec = finest[find_root(static_cast<int>(i))];
      if (spec != found_.sides[i].spec) overrule(found_.sides[i].spec, spec);
      found_.sides[i].spec = spec;
    }
    for (const auto& pair : overruled_) found_.overruled.push_back({pair.first, pair.second});
  }

  /// The arcs that leave the wall at both ends of a side.
  void mark_arcs(int wall) {
    const WallSide& side = found_.sides[wall];
    const HalfEdge before = directed(side.block, side.side - 1), after = directed(side.block, side.side + 1);
    int& at_begin = found_.at_arc_end[before.arc][1 - beginning_of(before)];
    int& at_end = found_.at_arc_end[after.arc][beginning_of(after)];
    if (at_begin < 0) at_begin = wall;
    if (at_end < 0) at_end = wall;
  }

  const BlockLayout& layout_;
  const curve::CurveTable& table_;
  const std::vector<int>& curve_spec_;
  const std::vector<WallSpec>& specs_;
  std::vector<std::vector<Side>> arc2sides_;
  std::set<std::pair<int, int>> overruled_;
  WallSides found_;
};

}  // namespace

int beginning_of(HalfEdge directed) { return directed.is_backwards ? 1 : 0; }

WallSides find_wall_sides(const BlockLayout& layout, const curve::CurveTable& table, const std::vector<int>& curve_spec,
                          const std::vector<WallSpec>& specs) {
  return Finder(layout, table, curve_spec, specs).find();
}

}  // namespace quadrille::layers
