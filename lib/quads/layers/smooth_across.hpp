#pragma once
// Makes adjacent lines of a block alike where they lie close together.
//
// Each line of a family is divided for itself. Where lines are much closer to each other than their nodes, as in
// layers, small differences of their divisions would skew the elements between them. For node k of all lines the
// parameters u across the lines minimise
//
//   integral of (u - own)^2 / l^2 + u'^2   over the length across the lines,
//
// own the line's parameter and l a multiple of the length of the elements along the lines there: divisions differ only
// over distances as long as elements. Every u is a weighted mean of parameters of node k.

#include <vector>

#include "base/vec2.hpp"

namespace quadrille::layers {

/// Nodes of a family of lines across a block: node k of line l at l * num_nodes + k. The first and the last line are
/// sides of the block.
struct LineNodes {
  int num_lines = 0, num_nodes = 0;
  std::vector<double> parameters;  ///< along the line, rising from 0 to 1
  std::vector<Vec2> positions;
};

/// Changes the parameters of nodes `first` to `last` - 1 of all inner lines. `order`: nodes of each element along a
/// line, less one. `reach`: l over the length of the elements. 0 < first, last < num_nodes.
void smooth_across(LineNodes& nodes, int first, int last, int order, double reach);

/// The same for other values of these nodes, in the order of their parameters.
void smooth_across(const LineNodes& nodes, int first, int last, int order, double reach, std::vector<double>& values);

}  // namespace quadrille::layers
