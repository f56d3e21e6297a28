#pragma once
// The spacings that the layers of the walls prescribe on the arcs that start there.

#include <array>
#include <vector>

#include "layers/end_spacing.hpp"
#include "layers/wall_input.hpp"
#include "layers/wall_sides.hpp"

namespace quadrille::layers {

struct LayerRequests {
  std::vector<ArcSpacing> spacings;  ///< by arc
  /// By arc and end: fractions of the arc's length, from this end, at which its nodes in the layers lie.
  std::vector<std::array<std::vector<double>, 2>> nodes;
};

/// `spec_heights`: by spec, upper ends of its layers. Throws ComputeError with the position if an arc turns back to the
/// wall before the layers end.
LayerRequests request_layers(const WallInput& input, const WallSides& walls,
                             const std::vector<std::vector<double>>& spec_heights);

/// The Gauss-Lobatto-Legendre points of every interval, ends shared: of n intervals n `order` + 1.
std::vector<double> interval_nodes(const std::vector<double>& ends, int order);

/// The fractions of all nodes of the arcs that start at walls: in the layers at their heights, elsewhere
/// Gauss-Lobatto-Legendre points of each interval. Empty for other arcs, and for those on which the end of a layer
/// moved onto a break (rule 17): all their nodes follow from the intervals.
std::vector<std::vector<double>> layered_arc_nodes(const LayerRequests& requests, const sizing::ArcDivisions& divisions,
                                                   int order);

}  // namespace quadrille::layers
