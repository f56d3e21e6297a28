#include "couple/interface_chains.hpp"

#include <algorithm>
#include <map>

#include "base/error.hpp"
#include "curve/arc_length.hpp"
#include "curve/chain.hpp"
#include "graph/separatrix_lines.hpp"

namespace quadrille::couple {
namespace {

bool is_lower_side(const CadFace& face, int curve) { return curve < face.partners[curve]; }

// Whether the interface goes on from `curve` to the next one of its loop, on both sides.
bool continues(const CadFace& face, int curve) {
  const int next = face.next_in_loop(curve);
  if (!face.is_interface(curve) || !face.is_interface(next)) return false;
  if (!is_lower_side(face, curve) || !is_lower_side(face, next)) return false;
  return face.next_in_loop(face.partners[next]) == face.partners[curve];
}

InterfaceChain chain_from(const CadFace& face, int first, std::vector<bool>& is_used) {
  InterfaceChain chain;
  for (int curve = first;; curve = face.next_in_loop(curve)) {
    chain.curves.push_back(curve);
    is_used[curve] = true;
    if (!continues(face, curve)) break;
    if (face.next_in_loop(curve) == first) {
      chain.is_closed = true;
      break;
    }
  }
  return chain;
}

// First those that begin where no other ends, then closed ones.
std::vector<InterfaceChain> chains_of(const CadFace& face) {
  std::vector<InterfaceChain> chains;
  std::vector<bool> is_used(face.num_curves(), false);
  for (const bool is_closed : {false, true})
    for (int c = 0; c < face.num_curves(); ++c) {
      if (is_used[c] || !face.is_interface(c) || !is_lower_side(face, c)) continue;
      if (is_closed || !continues(face, face.previous_in_loop(c))) chains.push_back(chain_from(face, c, is_used));
    }
  return chains;
}

// The last arc of the regular line that ends at the node; -1: it is another node.
int line_at(const graph::CandidateLayout& layout, int node) {
  const GraphNode& n = layout.graph().nodes[node];
  const std::vector<HalfEdge> around = layout.subdivision.around(node);
  const bool is_line_end = n.kind == NodeKind::boundary || n.kind == NodeKind::cut;
  return is_line_end && n.valence == 2 && around.size() == 3 ? around[1].arc : -1;
}

}  // namespace

Station station_at(const graph::CandidateLayout& layout, const curve::CurveTable& table,
                   const std::vector<LineKind>& kinds, int region, int node) {
  Station station{region, node, 0, false, 0, false};
  const int line = line_at(layout, node);
  if (line < 0) return station;
  const std::vector<ArcPiece>& pieces = layout.graph().arcs[line].pieces;
  const int spline = pieces.front().curve - layout.graph().face.num_curves();
  station.is_movable = true;
  station.line_length = curve::Chain(table, pieces).length();
  station.is_cut = spline >= 0 && kinds[spline] == LineKind::cut;
  return station;
}

std::vector<InterfaceChain> interface_chains(const RegionLayouts& regions, CutEnds cuts) {
  const CadFace& face = regions.face;
  std::vector<InterfaceChain> chains = chains_of(face);
  std::map<int, std::pair<int, int>> chain_of_curve;  // its chain, and its number in the chain
  std::vector<curve::ArcLength> tables;
  for (const Nurbs& curve : face.curves) tables.emplace_back(curve);
  for (std::size_t i = 0; i < chains.size(); ++i) {
    chains[i].offsets.push_back(0);
    for (std::size_t k = 0; k < chains[i].curves.size(); ++k) {
      chain_of_curve[chains[i].curves[k]] = {static_cast<int>(i), static_cast<int>(k)};
      chains[i].offsets.push_back(chains[i].offsets.back() + tables[chains[i].curves[k]].total());
    }
  }
  for (int r = 0; r < static_cast<int>(regions.layouts.size()); ++r) {
    const graph::CandidateLayout& layout = regions.layouts[r];
    const curve::CurveTable table(layout.graph().face, layout.graph().splines);
    const std::vector<LineKind> kinds = graph::spline_kinds(layout.graph(), layout.lines);
    for (int n = 0; n < static_cast<int>(layout.graph().nodes.size()); ++n) {
      if (layout.graph().nodes[n].curve < 0) continue;
      Place place = regions.place_of(r, n);
      // At a joint the curve before it may be the one that belongs to a chain; either gives the same length.
      if (!face.is_interface(place.curve)) continue;
      const bool is_lower = is_lower_side(face, place.curve);
      const int curve = is_lower ? place.curve : face.partners[place.curve];
      const auto& [chain_number, k] = chain_of_curve.at(curve);
      InterfaceChain& chain = chains[chain_number];
      const double t = is_lower ? place.t : partner_parameter(face, place.curve, place.t);
      double position = chain.offsets[k] + tables[curve].at(t);
      if (!chain.is_closed && (position <= 0 || position >= chain.length())) continue;
      if (position >= chain.length()) position = 0;
      Station station = station_at(layout, table, kinds, r, n);
      if (station.is_cut && cuts == CutEnds::ignored) continue;
      station.position = position;
      chain.stations[is_lower ? 0 : 1].push_back(station);
    }
  }
  for (InterfaceChain& chain : chains)
    for (std::vector<Station>& side : chain.stations)
      std::stable_sort(side.begin(), side.end(),
                       [](const Station& a, const Station& b) { return a.position < b.position; });
  return chains;
}

Place place_on_side(const CadFace& face, const InterfaceChain& chain, int side, const Place& place) {
  for (const Place& p : places_of_point(face, place)) {
    const bool is_lower = std::find(chain.curves.begin(), chain.curves.end(), p.curve) != chain.curves.end();
    if (is_lower == (side == 0)) return p;
  }
  throw Defect("couple: a point of an interface has no place on one side of it");
}

}  // namespace quadrille::couple
