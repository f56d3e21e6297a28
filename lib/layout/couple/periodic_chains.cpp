#include "couple/periodic_chains.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "curve/arc_length.hpp"
#include "curve/chain.hpp"
#include "graph/separatrix_lines.hpp"
#include "model/periodic.hpp"

namespace quadrille::couple {
namespace {

// Number of the pair of which the curve is the first; -1: none.
std::vector<int> pairs_of_firsts(const CadFace& face) {
  std::vector<int> pairs(face.curves.size(), -1);
  for (int i = 0; i < static_cast<int>(face.periodic_pairs.size()); ++i) pairs[face.periodic_pairs[i].curves[0]] = i;
  return pairs;
}

// Whether the pair of the next curve goes on where this one ends.
bool continues(const CadFace& face, const std::vector<int>& pairs, int first) {
  const int next = face.next_in_loop(first);
  if (pairs[next] < 0 || next == first) return false;
  const int second = face.periodic_pairs[pairs[first]].curves[1], behind = face.periodic_pairs[pairs[next]].curves[1];
  return face.next_in_loop(behind) == second;
}

PeriodicChain chain_from(const CadFace& face, const std::vector<int>& pairs, int first) {
  PeriodicChain chain;
  chain.chain.offsets.push_back(0);
  for (int curve = first;; curve = face.next_in_loop(curve)) {
    chain.chain.curves.push_back(curve);
    chain.seconds.push_back(face.periodic_pairs[pairs[curve]].curves[1]);
    chain.chain.offsets.push_back(chain.chain.offsets.back() + curve::ArcLength(face.curves[curve]).total());
    if (!continues(face, pairs, curve)) return chain;
  }
}

int index_of(const std::vector<int>& curves, int curve) {
  const auto found = std::find(curves.begin(), curves.end(), curve);
  return found == curves.end() ? -1 : static_cast<int>(found - curves.begin());
}

}  // namespace

std::vector<PeriodicChain> periodic_chains(const CadFace& face) {
  const std::vector<int> pairs = pairs_of_firsts(face);
  std::vector<PeriodicChain> chains;
  for (const PeriodicPair& pair : face.periodic_pairs) {
    const int first = pair.curves[0], before = face.previous_in_loop(first);
    if (pairs[before] < 0 || before == first || !continues(face, pairs, before))
      chains.push_back(chain_from(face, pairs, first));
  }
  return chains;
}

void set_stations(const graph::CandidateLayout& layout, std::vector<PeriodicChain>& chains) {
  const ArcGraph& graph = layout.graph();
  const curve::CurveTable table(graph.face, graph.splines);
  const std::vector<LineKind> kinds = graph::spline_kinds(graph, layout.lines);
  for (PeriodicChain& chain : chains) {
    for (std::vector<Station>& side : chain.chain.stations) side.clear();
    for (int n = 0; n < static_cast<int>(graph.nodes.size()); ++n) {
      const GraphNode& node = graph.nodes[n];
      if (node.curve < 0) continue;
      const int first = index_of(chain.chain.curves, node.curve), second = index_of(chain.seconds, node.curve);
      if (first < 0 && second < 0) continue;
      const int k = std::max(first, second), curve = chain.chain.curves[k];
      const double t = first >= 0 ? node.t : periodic_parameter(graph.face, node.curve, node.t, curve);
      const double position = chain.chain.offsets[k] + table.arc_length(curve).at(t);
      if (position <= 0 || position >= chain.chain.length()) continue;
      Station station = station_at(layout, table, kinds, 0, n);
      station.position = position;
      chain.chain.stations[first >= 0 ? 0 : 1].push_back(station);
    }
    for (std::vector<Station>& side : chain.chain.stations)
      std::stable_sort(side.begin(), side.end(),
                       [](const Station& a, const Station& b) { return a.position < b.position; });
  }
}

Place image_of(const CadFace& face, const PeriodicChain& chain, const Place& place) {
  if (const int k = index_of(chain.chain.curves, place.curve); k >= 0)
    return place_at(face, chain.seconds[k], periodic_parameter(face, place.curve, place.t, chain.seconds[k]));
  const int k = index_of(chain.seconds, place.curve);
  if (k < 0) throw Defect("couple: a place that is on no periodic side has no image");
  return place_at(face, chain.chain.curves[k], periodic_parameter(face, place.curve, place.t, chain.chain.curves[k]));
}

}  // namespace quadrille::couple
