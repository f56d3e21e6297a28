#include "growth/opposite_ends.hpp"

#include <algorithm>

#include "mesh/block_sides.hpp"

namespace quadrille::growth {
namespace {

constexpr double derivative_step = 1e-5;

double slope_of(const sizing::ArcParameter& parameter, double fraction) {
  if (parameter.is_identity()) return 1;
  const double low = std::max(0.0, fraction - derivative_step), high = std::min(1.0, fraction + derivative_step);
  return (parameter.parameter(high) - parameter.parameter(low)) / (high - low);
}

AlignedSide aligned_side(const GrowthInput& input, const sizing::ArcDivisions& divisions, HalfEdge half,
                         bool is_reversed) {
  return {&input.measured.parameter(half.arc), half.arc, divisions[half.arc].num_intervals(), is_reversed, 0, 1};
}

/// Number of layers at the beginning (0) or the end (1) of the side.
int layers_at(const GrowthInput& input, const AlignedSide& side, int end) {
  return input.num_layers(side.arc, side.is_reversed ? 1 - end : end);
}

/// Positions count from the ends of the layers.
void skip_layers(const GrowthInput& input, const sizing::ArcDivisions& divisions, AlignedSide& side) {
  const double low = side.at(divisions, layers_at(input, side, 0)).position;
  side.high = side.at(divisions, side.count - layers_at(input, side, 1)).position;
  side.low = low;
}

}  // namespace

RelativeEnd AlignedSide::at(const sizing::ArcDivisions& divisions, int i) const {
  const int end = is_reversed ? count - i : i;
  const double fraction = divisions[arc].ends[end], u = parameter->parameter(fraction), range = high - low;
  const double slope = slope_of(*parameter, fraction) / range;
  return {end, ((is_reversed ? 1 - u : u) - low) / range, is_reversed ? -slope : slope};
}

std::vector<OppositeSides> opposite_arcs(const GrowthInput& input, const sizing::ArcDivisions& divisions) {
  const BlockLayout& blocks = input.measured.blocks();
  std::vector<OppositeSides> pairs;
  for (int block = 0; block < blocks.num_blocks(); ++block)
    for (int k = 0; k < 2; ++k) {
      const auto half = [&](int side) { return mesh::half_edge(blocks, block, side); };
      const auto length = [&](int side) { return input.measured.length(half(side).arc); };
      if (half(k).arc == half(k + 2).arc) continue;
      OppositeSides pair{aligned_side(input, divisions, half(k), half(k).is_backwards),
                         aligned_side(input, divisions, half(k + 2), !half(k + 2).is_backwards),
                         (length(k) + length(k + 2)) / (length(k + 1) + length(k + 3))};
      if (layers_at(input, pair.a, 0) == layers_at(input, pair.b, 0) &&
          layers_at(input, pair.a, 1) == layers_at(input, pair.b, 1)) {
        skip_layers(input, divisions, pair.a);
        skip_layers(input, divisions, pair.b);
      }
      pairs.push_back(pair);
    }
  return pairs;
}

}  // namespace quadrille::growth
