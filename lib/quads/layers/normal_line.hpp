#pragma once
// Wall-normal lines: lines of mesh nodes across a block between two opposite sides, of which one or both are walls.
//
// In the layers nodes lie at their heights above the wall. Between them, intervals have given lengths, or those of the
// two arcs beside the line, blended across the block; one factor makes them fill the line.

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "layers/wall_sides.hpp"
#include "sizing/measured_layout.hpp"

namespace quadrille::layers {

/// A line across a block, for u in [0, 1].
using NormalLine = std::function<Vec2(double)>;

/// The heights of all nodes of layers with these upper ends: Gauss-Lobatto-Legendre points of each layer, without 0.
std::vector<double> node_heights(const std::vector<double>& layer_heights, int order);

/// The Gauss-Lobatto-Legendre points of every interval, ends shared: of n intervals n `order` + 1.
std::vector<double> interval_nodes(const std::vector<double>& ends, int order);

/// The first u at which the line, which starts on the wall at `foot`, is at each of the rising heights, to 1e-11 of the
/// height. Fewer parameters if the line turns back to the wall, or ends, before the last one.
std::vector<double> parameters_at_heights(const NormalLine& line, const WallLine& wall, WallPoint foot,
                                          const std::vector<double>& heights);

/// The parameters of the nodes of elements in layers with these upper ends, compressed if there are `own_intervals`
/// (compressed_heights). Fewer, as from parameters_at_heights.
std::vector<double> parameters_in_layers(const NormalLine& line, const WallLine& wall, WallPoint foot,
                                         const std::vector<double>& heights, int own_intervals, int order);

/// Layers along one side of a block.
struct SideLayers {
  const WallLine* wall = nullptr;  ///< nullptr: no wall
  std::vector<double> heights;     ///< of the layers' upper ends
  std::vector<WallPoint> feet;     ///< on the wall: the side's nodes by rising s or t
  int own_intervals = 0;           ///< WallSide::own_intervals
};

/// All lines between two opposite sides of a block.
struct LineFamily {
  const SideLayers& low;            ///< at u = 0
  const SideLayers& high;           ///< at u = 1
  std::vector<double> left, right;  ///< lengths of the elements on the arcs beside the lines, by rising u
  int order = 1;

  /// Numbers of the nodes, of so many on each line, at which the layers end.
  int low_node() const { return static_cast<int>(low.heights.size()) * order; }
  int high_node(int num_nodes) const { return num_nodes - 1 - static_cast<int>(high.heights.size()) * order; }
};

/// One line of nodes across a block before its intervals above the layers are placed.
struct BlockLine {
  double length = 0;  ///< of the part above the layers
  std::vector<double>
      sizes;  ///< of its intervals, blended from the sides beside it; their sum may differ from the length
  double before = 0, after = 0;            ///< lengths of the last layer at its beginning and end; 0: no layers
  double before_size = 0, after_size = 0;  ///< the same, blended from the sides
};

/// Measures the line that starts at the given node of both sides. `blend`: at its beginning and its end, each 0 at the
/// left and 1 at the right, so that the sizes of lines which continue each other in adjacent blocks do so too. Throws
/// as divide_normal_line.
BlockLine measured_line(const LineFamily& family, const NormalLine& line, std::size_t node,
                        const std::array<double, 2>& blend, const CadFace& face);

/// Parameters from 0 to 1 of all nodes of the line that starts at the given node of both sides. `lengths`: of the
/// intervals between the layers, up to a common factor. Throws ComputeError, with the position, if the
/// line turns back before its layers end or the layers of both ends overlap.
std::vector<double> divide_normal_line(const LineFamily& family, const NormalLine& line, std::size_t node,
                                       const CadFace& face, const std::vector<double>& lengths);

}  // namespace quadrille::layers
