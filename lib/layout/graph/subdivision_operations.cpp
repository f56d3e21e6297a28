// The operations of a subdivision: each rewires next and quarters where it changes something.

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "graph/arc_pieces.hpp"
#include "graph/subdivision.hpp"
#include "model/interfaces.hpp"

namespace quadrille::graph {
namespace {

constexpr int straight = 2;  // quarters on either side of a node through which only one line passes

}  // namespace

HalfEdge Subdivision::add_arc(int from, int to, bool is_boundary, std::vector<ArcPiece> pieces) {
  graph_.arcs.push_back({from, to, is_boundary, 0, std::move(pieces)});
  records_.resize(2 * graph_.arcs.size());
  return {arc_bound() - 1};
}

void Subdivision::retire(int arc) {
  record({arc}) = record({arc, true}) = {};
  changing_arc(arc).pieces.clear();
}

Subdivision::Division Subdivision::divide_arc(HalfEdge h, const GraphNode& node, std::vector<ArcPiece> first,
                                              std::vector<ArcPiece> second) {
  if (h.is_backwards) {
    const Division forwards =
        divide_arc(h.reversed(), node, reversed_pieces(std::move(second)), reversed_pieces(std::move(first)));
    return {forwards.node, forwards.second.reversed(), forwards.first.reversed()};
  }
  const HalfEdge back = h.reversed();
  const bool is_boundary = graph_.arcs[h.arc].is_boundary;
  const Record left = record(h), right = record(back);
  const HalfEdge behind = is_boundary ? HalfEdge{} : previous(back);
  const int n = node_bound(), to = end(h);
  graph_.nodes.push_back(node);
  const HalfEdge rest = add_arc(n, to, is_boundary, std::move(second));
  node_start_.push_back(rest);
  GraphArc& divided = changing_arc(h.arc);
  divided.to = n;
  divided.pieces = std::move(first);
  // The arc may end at a node without other arcs: then its reverse follows it.
  record(rest) = {left.next == back ? rest.reversed() : left.next, left.face, left.quarters};
  record(h) = {rest, left.face, straight};
  if (!is_boundary) {
    record(behind == h ? rest : behind).next = rest.reversed();
    record(rest.reversed()) = {back, right.face, straight};
  }
  if (node_start_[to] == back) changing_node_start(to) = rest.reversed();
  return {n, h, rest};
}

HalfEdge Subdivision::insert_arc(const Sector& from, const Sector& to, std::vector<ArcPiece> pieces) {
  if (face(from.after) != face(to.after) || from.after == to.after)
    throw Defect("Subdivision: an arc joins two corners of one face");
  const int left_face = face(from.after);
  const HalfEdge h = add_arc(end(from.after), end(to.after), false, std::move(pieces)), back = h.reversed();
  Record &at_start = record(from.after), &at_end = record(to.after);
  record(h) = {at_end.next, left_face, at_end.quarters - to.quarters};
  record(back) = {at_start.next, left_face, at_start.quarters - from.quarters};
  at_start.next = h, at_start.quarters = from.quarters;
  at_end.next = back, at_end.quarters = to.quarters;
  changing_face_start(left_face) = h;
  label(back, face_bound());
  face_start_.push_back(back);
  return h;
}

bool Subdivision::remove_arc(int arc) {
  const HalfEdge h{arc}, back{arc, true};
  const int kept = std::min(face(h), face(back)), removed = std::max(face(h), face(back));
  if (kept < 0 || kept == removed) return false;
  const HalfEdge after_start = next(back), after_end = next(h);
  const HalfEdge before_start = previous(h), before_end = previous(back);
  const int quarters_start = quarters(before_start) + quarters(back);
  const int quarters_end = quarters(before_end) + quarters(h);
  record(before_start).next = after_start, record(before_start).quarters = quarters_start;
  record(before_end).next = after_end, record(before_end).quarters = quarters_end;
  if (node_start_[start(h)] == h) changing_node_start(start(h)) = after_start;
  if (node_start_[end(h)] == back) changing_node_start(end(h)) = after_end;
  label(before_start, kept);
  changing_face_start(kept) = before_start;
  changing_face_start(removed) = {};
  retire(arc);
  return true;
}

bool Subdivision::dissolve_node(int node) {
  std::vector<HalfEdge> leaving = around(node);
  if (leaving.size() != 2 || leaving[0].arc == leaving[1].arc) return false;
  const bool is_boundary = graph_.arcs[leaving[0].arc].is_boundary;
  if (is_boundary)
    std::swap(leaving[0], leaving[1]);  // boundary arcs stay forwards
  else
    std::sort(leaving.begin(), leaving.end());
  const HalfEdge in = leaving[0].reversed(), out = leaving[1];
  if (quarters(in) != straight || (!is_boundary && quarters(out.reversed()) != straight)) return false;
  const Record left = record(out), right = record(in.reversed());
  const HalfEdge before = previous(in), behind = is_boundary ? HalfEdge{} : previous(out.reversed());
  const int from = start(in), to = end(out);
  std::vector<ArcPiece> pieces = joined(pieces_along(graph_, in), pieces_along(graph_, out));
  const HalfEdge whole = add_arc(from, to, is_boundary, std::move(pieces));
  const auto renamed = [&](HalfEdge x) {
    return x == in || x == out ? whole : x == in.reversed() || x == out.reversed() ? whole.reversed() : x;
  };
  record(before).next = whole;
  record(whole) = {renamed(left.next), left.face, left.quarters};
  if (!is_boundary) {
    record(behind).next = whole.reversed();
    record(whole.reversed()) = {renamed(right.next), right.face, right.quarters};
  }
  for (const int n : {from, to}) changing_node_start(n) = renamed(node_start_[n]);
  for (const int f : {left.face, right.face})
    if (f >= 0) changing_face_start(f) = renamed(face_start_[f]);
  changing_node_start(node) = {};
  retire(in.arc), retire(out.arc);
  return true;
}

void Subdivision::merge_ends(HalfEdge h) {
  const int kept = start(h), gone = end(h);
  const bool is_boundary = graph_.arcs[h.arc].is_boundary;
  const auto is_on_boundary = [&](int n) { return graph_.nodes[n].curve >= 0; };
  const bool is_along = is_on_cad_curve(graph_, graph_.arcs[h.arc]);
  if (kept == gone || (is_on_boundary(gone) && !(is_on_boundary(kept) && is_along)))
    throw Defect("Subdivision: these two nodes cannot be merged");
  const std::vector<HalfEdge> moved = around(gone);
  if (node_start_[kept].arc == h.arc)
    changing_node_start(kept) = is_boundary               ? node_start_[gone]
                                : next(h) != h.reversed() ? next(h)
                                                          : next(h.reversed());
  // On either side of the arc two sectors become one; their quarters add up, less those of the straight line along the
  // arc.
  for (const HalfEdge side : {h, h.reversed()}) {
    if (!is_inside(side)) continue;
    Record& before = record(previous(side));
    before.next = next(side);
    before.quarters += quarters(side) - straight;
    if (face_start_[face(side)] == side) changing_face_start(face(side)) = next(side);
  }
  for (const HalfEdge m : moved) {
    GraphArc& arc = changing_arc(m.arc);
    (m.is_backwards ? arc.to : arc.from) = kept;
  }
  changing_node(kept).valence += graph_.nodes[gone].valence - (is_boundary ? straight : 2 * straight);
  changing_node_start(gone) = {};
  retire(h.arc);
}

// Swaps the two half-edges of an arc.
void Subdivision::turn(int arc) {
  const HalfEdge h{arc}, back{arc, true};
  const auto turned = [&](HalfEdge x) { return x.arc == arc ? x.reversed() : x; };
  const HalfEdge before = previous(h), behind = previous(back);
  if (before.arc != arc) record(before).next = back;
  if (behind.arc != arc) record(behind).next = h;
  std::swap(record(h), record(back));
  for (const HalfEdge x : {h, back}) record(x).next = turned(record(x).next);
  changing_node_start(start(h)) = turned(node_start_[start(h)]);
  changing_face_start(face(h)) = turned(face_start_[face(h)]);
  if (end(h) != start(h)) changing_node_start(end(h)) = turned(node_start_[end(h)]);
  if (face(back) != face(h)) changing_face_start(face(back)) = turned(face_start_[face(back)]);
  GraphArc& turning = changing_arc(arc);
  std::swap(turning.from, turning.to);
}

void Subdivision::reshape_arc(HalfEdge h, std::vector<ArcPiece> pieces) {
  if (h.is_backwards) turn(h.arc);
  changing_arc(h.arc).pieces = std::move(pieces);
}

void Subdivision::move_boundary_node(int node, Vec2 position, int curve, double t) {
  GraphNode& moved = changing_node(node);
  moved.position = position;
  moved.curve = curve;
  moved.t = t;
}

int Subdivision::add_spline(Nurbs spline) {
  graph_.splines.push_back(std::move(spline));
  return graph_.face.num_curves() + static_cast<int>(graph_.splines.size()) - 1;
}

void Subdivision::drop_unused_splines() {
  const int first = graph_.face.num_curves();
  std::vector<int> number(graph_.splines.size(), -1);
  for (const GraphArc& arc : graph_.arcs)
    for (const ArcPiece& p : arc.pieces)
      if (p.curve >= first) number[p.curve - first] = 0;
  std::vector<Nurbs> splines;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] < 0) continue;
    number[i] = first + static_cast<int>(splines.size());
    splines.push_back(std::move(graph_.splines[i]));
  }
  for (GraphArc& arc : graph_.arcs)
    for (ArcPiece& p : arc.pieces)
      if (p.curve >= first) p.curve = number[p.curve - first];
  graph_.splines = std::move(splines);
}

}  // namespace quadrille::graph
