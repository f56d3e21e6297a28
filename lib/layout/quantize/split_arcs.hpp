#pragma once
// Splits the arcs of a T-mesh at their crossings with iso-lines.

#include <vector>

#include "curve/chain.hpp"
#include "graph/subdivision.hpp"
#include "quantize/quantized_parametrization.hpp"

namespace quadrille::quantize {

/// Of each arc of the T-mesh: the arcs that it is split into, in its direction.
using ArcParts = std::vector<std::vector<int>>;

/// Splits the arcs of `subdivision`, a T-mesh, at these fractions of their lengths. `chains`: of the arcs.
ArcParts split_arcs(const std::vector<curve::Chain>& chains, const CrossingFractions& fractions,
                    graph::Subdivision& subdivision);

/// The half-edge that ends at a position on a side of a face: at a crossing, or at the end of an arc.
HalfEdge part_before(const QuantizedParametrization& parametrization, const ArcParts& parts, int face, int side,
                     int position);

}  // namespace quadrille::quantize
