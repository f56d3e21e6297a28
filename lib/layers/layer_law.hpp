#pragma once
// Heights of the boundaries between the layers along a wall.

#include <vector>

#include "layers/wall_spec.hpp"

namespace quadrille::layers {

/// Distances of the layers' upper ends from the wall, ascending; the first is spec.first under every law.
///   uniform    equal layers
///   geometric  each layer is `growth` times the one below
///   tanh       the geometric law's count and thickness, with heights T (1 - tanh(d (1 - k / m)) / tanh(d)): growing
///              fastest at the wall and not at all at the top
///   gll        the lower half of the 2 m + 1 Gauss-Lobatto-Legendre points, scaled to the first height
std::vector<double> layer_heights(const WallSpec& spec, int layers);

/// The number of layers: spec.layers, or the least number that reaches spec.thickness. Throws UsageError if that would
/// be more than LayerConstants::max_layers.
int requested_layers(const WallSpec& spec);

}  // namespace quadrille::layers
