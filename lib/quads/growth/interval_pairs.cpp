#include "growth/interval_pairs.hpp"

#include <cmath>

#include "mesh/block_sides.hpp"

namespace quadrille::growth {
namespace {

Interval at_end(const sizing::ArcDivisions& divisions, const mesh::ArcEnd& at) {
  return {at.arc, at.end == 0 ? 0 : divisions[at.arc].num_intervals() - 1};
}

}  // namespace

bool is_layer(const GrowthInput& input, const sizing::ArcDivisions& divisions, const Interval& interval) {
  return interval.k < input.num_layers(interval.arc, 0) ||
         interval.k >= divisions[interval.arc].num_intervals() - input.num_layers(interval.arc, 1);
}

std::vector<IntervalPair> adjacent_intervals(const GrowthInput& input, const sizing::ArcDivisions& divisions) {
  std::vector<IntervalPair> pairs;
  const auto add = [&](const IntervalPair& pair) {
    if (!is_layer(input, divisions, pair.a) || !is_layer(input, divisions, pair.b)) pairs.push_back(pair);
  };
  for (int arc = 0; arc < input.measured.num_arcs(); ++arc)
    for (int k = 0; k + 1 < divisions[arc].num_intervals(); ++k) add({{arc, k}, {arc, k + 1}});
  for (const auto& [a, b] : mesh::arc_neighbours(input.measured.blocks()))
    add({at_end(divisions, a), at_end(divisions, b)});
  return pairs;
}

double length_of(const GrowthInput& input, const sizing::ArcDivisions& divisions, const Interval& interval) {
  const sizing::ArcDivision& division = divisions[interval.arc];
  return (division.high(interval.k) - division.low(interval.k)) * input.measured.length(interval.arc);
}

double log_growth(const GrowthInput& input, const sizing::ArcDivisions& divisions, const IntervalPair& pair) {
  return std::log(length_of(input, divisions, pair.b) / length_of(input, divisions, pair.a));
}

}  // namespace quadrille::growth
