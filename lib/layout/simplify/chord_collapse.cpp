#include "simplify/chord_collapse.hpp"

#include <utility>

#include "base/error.hpp"
#include "graph/arc_pieces.hpp"
#include "model/interfaces.hpp"

namespace quadrille::simplify {
namespace {

using graph::ChordStrip;
using graph::FixedSide;
using graph::Subdivision;

// Number of rung `i` of a strip: in a closed strip they continue after the last with the first.
int wrapped_rung(const ChordStrip& strip, int i) {
  return strip.is_closed ? i % static_cast<int>(strip.rungs.size()) : i;
}

graph::Pieces rail(const ArcGraph& graph, const ChordStrip& strip, const BlendedStretch& stretch, bool is_left) {
  graph::Pieces pieces;
  for (int k = 0; k < stretch.num_blocks; ++k) {
    const int block = wrapped_rung(strip, stretch.first_rung + k);
    pieces = graph::joined(std::move(pieces), graph::pieces_along(graph, (is_left ? strip.left : strip.right)[block]));
  }
  return pieces;
}

// The crossings of blends with rungs, and the pieces of blends between rungs.
struct PlacedBlends {
  std::vector<Nurbs> splines;
  std::vector<std::optional<curve::ChainPoint>> on_rung;  // of each rung
  std::vector<std::optional<ArcPiece>> in_block;          // of each block
};

bool place_blend(const ArcGraph& graph, const ChordStrip& strip, const BlendedStretch& stretch, Nurbs spline,
                 PlacedBlends& placed) {
  std::vector<HalfEdge> inner;
  for (int k = 1; k < stretch.num_blocks; ++k)
    inner.push_back(strip.rungs[wrapped_rung(strip, stretch.first_rung + k)]);
  const auto crossings = cross_rungs(graph, inner, spline);
  if (!crossings) return false;
  const int curve =
      graph.face.num_curves() + static_cast<int>(graph.splines.size()) + static_cast<int>(placed.splines.size());
  double s = spline.begin();
  for (int k = 0; k < stretch.num_blocks; ++k) {
    const int i = wrapped_rung(strip, stretch.first_rung + k);
    if (k > 0) placed.on_rung[i] = (*crossings)[k - 1].at;
    const double next = k + 1 < stretch.num_blocks ? (*crossings)[k].s : spline.end();
    placed.in_block[i] = ArcPiece{curve, s, next};
    s = next;
  }
  placed.splines.push_back(std::move(spline));
  return true;
}

std::optional<PlacedBlends> place_blends(const ArcGraph& graph, const ChordStrip& strip, const CollapsePlan& plan,
                                         const std::vector<Blend>& blends) {
  PlacedBlends placed;
  placed.on_rung.resize(strip.rungs.size());
  placed.in_block.resize(strip.num_blocks());
  for (const BlendedStretch& s : plan.stretches) {
    auto spline = find_blend(blends, rail(graph, strip, s, s.from_left), rail(graph, strip, s, !s.from_left));
    if (!spline || !place_blend(graph, strip, s, std::move(*spline), placed)) return std::nullopt;
  }
  return placed;
}

// Prepends `pieces` to the arc that starts at a node of the strip and leads away from it: only one, as the node is
// regular.
void lengthen(Subdivision& subdivision, const std::set<int>& arcs_of_strip, int node, const graph::Pieces& pieces,
              std::set<int>& changed) {
  for (const HalfEdge h : subdivision.around(node)) {
    if (arcs_of_strip.contains(h.arc)) continue;
    const graph::Pieces& own = subdivision.graph().arcs[h.arc].pieces;
    subdivision.set_pieces(
        h.arc, h.is_backwards ? graph::joined(own, graph::reversed_pieces(pieces)) : graph::joined(pieces, own));
    changed.insert(h.arc);
  }
}

void move_onto_rung(Subdivision& subdivision, int node, const graph::Pieces& rung, const curve::ChainPoint& at) {
  const int curve = rung[at.piece].curve;
  if (curve < subdivision.graph().face.num_curves())
    subdivision.move_boundary_node(node, at.position, curve, at.t);
  else
    subdivision.move_node(node, at.position);
}

// Rung by rung: the lines that cross the strip are lengthened, the two ends become one node.
void merge_rungs(Subdivision& subdivision, const ChordStrip& strip, const CollapsePlan& plan,
                 const PlacedBlends& placed, std::set<int>& changed) {
  std::set<int> arcs;
  for (const std::vector<HalfEdge>* half_edges : {&strip.rungs, &strip.left, &strip.right})
    for (const HalfEdge h : *half_edges) arcs.insert(h.arc);
  for (std::size_t i = 0; i < strip.rungs.size(); ++i) {
    const HalfEdge rung = strip.rungs[i];
    const int l = subdivision.start(rung), r = subdivision.end(rung);
    const graph::Pieces pieces = graph::pieces_along(subdivision.graph(), rung);
    if (placed.on_rung[i]) {
      const auto [before, behind] = graph::cut(pieces, *placed.on_rung[i]);
      move_onto_rung(subdivision, l, pieces, *placed.on_rung[i]);
      lengthen(subdivision, arcs, l, graph::reversed_pieces(before), changed);
      lengthen(subdivision, arcs, r, behind, changed);
      subdivision.merge_ends(rung);
    } else if (plan.merged_into[i] == FixedSide::left) {
      lengthen(subdivision, arcs, r, pieces, changed);
      subdivision.merge_ends(rung);
    } else {
      lengthen(subdivision, arcs, l, graph::reversed_pieces(pieces), changed);
      subdivision.merge_ends(rung.reversed());
    }
  }
}

// std::nullopt if the strip cannot be collapsed.
std::optional<CollapsePlan> possible_plan(const Subdivision& subdivision, const ChordStrip& strip) {
  const std::vector<FixedSide> fixed = graph::fixed_sides(subdivision, strip);
  if (fixed.empty()) return std::nullopt;
  CollapsePlan plan = plan_collapse(strip, fixed);
  return removes_boundary(subdivision.graph(), strip, plan) ? std::nullopt : std::optional(std::move(plan));
}

}  // namespace

CollapsePlan plan_collapse(const graph::ChordStrip& strip, const std::vector<FixedSide>& fixed) {
  const int num_rungs = static_cast<int>(strip.rungs.size());
  CollapsePlan plan{fixed, std::vector<FixedSide>(strip.num_blocks(), FixedSide::none), {}};
  const auto at = [&](int i) { return wrapped_rung(strip, i); };
  int first = 0;
  while (fixed[first] == FixedSide::none) ++first;
  if (!strip.is_closed)
    for (int b = 0; b < first; ++b) plan.kept_rail[b] = plan.merged_into[b] = fixed[first];
  const int end = strip.is_closed ? first + num_rungs : num_rungs;
  for (int i = first, next = 0; i < end; i = next) {
    next = i + 1;
    while (next < end && fixed[at(next)] == FixedSide::none) ++next;
    const bool is_last = !strip.is_closed && next == end;
    const FixedSide here = fixed[at(i)], there = is_last ? here : fixed[at(next)];
    if (here != there) {
      plan.stretches.push_back({i, next - i, here == FixedSide::left});
      continue;
    }
    for (int k = i; k < next; ++k) plan.merged_into[at(k)] = here;
    for (int k = i; k < next - (is_last ? 1 : 0); ++k) plan.kept_rail[at(k)] = here;
  }
  return plan;
}

bool removes_boundary(const ArcGraph& graph, const graph::ChordStrip& strip, const CollapsePlan& plan) {
  const auto is_boundary = [&](HalfEdge h) { return is_on_cad_curve(graph, graph.arcs[h.arc]); };
  for (int b = 0; b < strip.num_blocks(); ++b)
    if ((plan.kept_rail[b] != FixedSide::left && is_boundary(strip.left[b])) ||
        (plan.kept_rail[b] != FixedSide::right && is_boundary(strip.right[b])))
      return true;
  return false;
}

int ArcChanges::now(int arc) const {
  for (auto at = removed.find(arc); at != removed.end(); at = removed.find(arc)) arc = at->second;
  return arc;
}

void ArcChanges::add(const ArcChanges& later) {
  std::set<int> still;
  for (const int a : changed)
    if (const int to = later.now(a); to >= 0) still.insert(to);
  changed = std::move(still);
  changed.insert(later.changed.begin(), later.changed.end());
  removed.insert(later.removed.begin(), later.removed.end());
}

std::optional<std::vector<Blend>> blends_of(const field::FieldsOfRegions& fields, const Subdivision& subdivision,
                                            const ChordStrip& strip, const BlendOptions& options) {
  const ArcGraph& graph = subdivision.graph();
  const std::optional<CollapsePlan> plan = possible_plan(subdivision, strip);
  if (!plan) return std::nullopt;
  const curve::CurveTable table(graph.face, graph.splines);
  std::vector<Blend> found;
  for (const BlendedStretch& s : plan->stretches) {
    auto blend =
        make_blend(fields, table, rail(graph, strip, s, s.from_left), rail(graph, strip, s, !s.from_left), options);
    if (!blend) return std::nullopt;
    found.push_back(std::move(*blend));
  }
  return found;
}

std::optional<ArcChanges> collapse_strip(Subdivision& subdivision, const ChordStrip& strip,
                                         const std::vector<Blend>& blends) {
  const std::optional<CollapsePlan> plan = possible_plan(subdivision, strip);
  if (!plan) return std::nullopt;
  std::optional<PlacedBlends> placed = place_blends(subdivision.graph(), strip, *plan, blends);
  if (!placed) return std::nullopt;
  for (Nurbs& spline : placed->splines) subdivision.add_spline(std::move(spline));
  ArcChanges changes;
  merge_rungs(subdivision, strip, *plan, *placed, changes.changed);
  for (const HalfEdge rung : strip.rungs) changes.removed[rung.arc] = -1;
  // Every block has two remaining sides: one of them is removed.
  for (int b = 0; b < strip.num_blocks(); ++b) {
    const bool keeps_left = plan->kept_rail[b] != FixedSide::right;
    const HalfEdge kept = keeps_left ? strip.left[b] : strip.right[b],
                   gone = keeps_left ? strip.right[b] : strip.left[b];
    if (!subdivision.remove_arc(gone.arc))
      throw Defect("collapse_strip: a block's two rails have nothing between them");
    changes.removed[gone.arc] = kept.arc;
    if (plan->kept_rail[b] != FixedSide::none) continue;
    subdivision.reshape_arc(kept, {*placed->in_block[b]});
    changes.changed.insert(kept.arc);
  }
  return changes;
}

}  // namespace quadrille::simplify
