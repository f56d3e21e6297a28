#include "heal/measured_edge.hpp"

#include "curve/arc_length.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::heal {

std::vector<std::vector<MeasuredEdge>> measured(const std::vector<std::vector<RawEdge>>& wires) {
  std::vector<std::vector<MeasuredEdge>> result;
  std::vector<curve::Carrier> carriers;
  for (const auto& wire : wires) {
    result.emplace_back();
    for (const RawEdge& edge : wire) {
      carriers.push_back(curve::carrier_of(edge.curve));
      result.back().push_back({&edge, carriers.back(), {}, curve::ArcLength(edge.curve).total()});
    }
  }
  const std::vector<Rank> ranks = ranks_of(carriers);
  size_t next = 0;
  for (auto& wire : result)
    for (MeasuredEdge& edge : wire) edge.rank = ranks[next++];
  return result;
}

JointSide end_of(const MeasuredEdge& edge) {
  const Nurbs& c = edge.raw->curve;
  return {edge.carrier, edge.rank, c.poles.back(), curve::tangent(c, c.end(), true)};
}

JointSide start_of(const MeasuredEdge& edge) {
  const Nurbs& c = edge.raw->curve;
  return {edge.carrier, edge.rank, c.poles.front(), curve::tangent(c, c.begin())};
}

}  // namespace quadrille::heal
