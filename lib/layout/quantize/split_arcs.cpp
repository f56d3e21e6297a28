#include "quantize/split_arcs.hpp"

#include <algorithm>
#include <iterator>

#include "graph/divide_at_point.hpp"

namespace quadrille::quantize {
namespace {

// From the last crossing to the first: what remains of the arc begins with the pieces of the chain.
std::vector<int> split_arc(int arc, const curve::Chain& chain, const std::map<int, double>& fractions,
                           graph::Subdivision& subdivision) {
  std::vector<int> parts;
  for (auto crossing = fractions.rbegin(); crossing != fractions.rend(); ++crossing)
    parts.push_back(graph::divide_at_point(subdivision, {arc}, chain.at(crossing->second)).second.arc);
  parts.push_back(arc);
  std::reverse(parts.begin(), parts.end());
  return parts;
}

}  // namespace

ArcParts split_arcs(const std::vector<curve::Chain>& chains, const CrossingFractions& fractions,
                    graph::Subdivision& subdivision) {
  ArcParts parts;
  for (size_t a = 0; a < chains.size(); ++a)
    parts.push_back(split_arc(static_cast<int>(a), chains[a], fractions[a], subdivision));
  return parts;
}

HalfEdge part_before(const QuantizedParametrization& parametrization, const ArcParts& parts, int face, int side,
                     int position) {
  const auto [h, number] = parametrization.sides().half_edge_at(face, side, position);
  const std::map<int, double>& crossings = parametrization.crossing_fractions()[h.arc];
  const auto next = h.is_backwards ? crossings.upper_bound(parametrization.sides().arc(h.arc) - number)
                                   : crossings.lower_bound(number);
  return {parts[h.arc][std::distance(crossings.begin(), next)], h.is_backwards};
}

}  // namespace quadrille::quantize
