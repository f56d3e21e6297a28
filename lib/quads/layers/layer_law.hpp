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

/// The height of one more layer: as much greater than the last one as that than the one below it.
double next_layer(const std::vector<double>& heights);

/// The heights of as many layers if they and `above` intervals, which where there is room are one more layer, must fit
/// below `room`: the first layer keeps its height, and all others grow less; with room for less than one more interval
/// of the first height all layers are equal.
std::vector<double> compressed_heights(const std::vector<double>& heights, double room, int above = 1);

/// The number of layers: spec.layers, or the least number that reaches spec.thickness. Throws UsageError if that would
/// be more than LayerConstants::max_layers.
int requested_layers(const WallSpec& spec);

/// The least height of blocks with all layers: their thickness and one more interval, which is as much longer than the
/// last layer as that than the one below it. This is the distance of the curve above layers in blocks of their own.
/// Throws UsageError unless first and the number of layers are known.
double block_height(const WallSpec& spec);

/// The distance from the wall at which irregular nodes leave room for all layers and for edges that grow above: more
/// than the height of the blocks, whose far sides lie nearer to a round wall than the nodes between which they run
/// (LayerConstants::node_distance). Throws as block_height.
double node_clearance(const WallSpec& spec);

}  // namespace quadrille::layers
