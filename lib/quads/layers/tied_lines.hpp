#pragma once
// The lines of a family across a block, made alike above their layers where they lie close together.
//
// Each line is divided for itself. Where lines are much closer to each other than their nodes, as in layers, small
// differences of their divisions would skew the elements between them. For node k of all lines the parameters u across
// the lines minimise
//
//   integral of (u - own)^2 / l^2 + u'^2   over the length across the lines,
//
// own the line's parameter and l a multiple of the length of the elements along the lines there: divisions differ only
// over distances as long as elements. Every u is a weighted mean of parameters of node k.

#include <vector>

#include "layers/normal_line.hpp"

namespace quadrille::layers {

/// Nodes of a family of lines across a block: node k of line l at l * num_nodes + k. The first and the last line are
/// sides of the block.
struct LineNodes {
  int num_lines = 0, num_nodes = 0;
  std::vector<double> parameters;  ///< along the line, rising from 0 to 1
  std::vector<Vec2> positions;
};

/// Changes the values of nodes `first` to `last` - 1 of all inner lines, in the order of their parameters. `order`:
/// nodes of each element along a line, less one. `reach`: l over the length of the elements. 0 < first, last <
/// num_nodes.
void smooth_across(const LineNodes& nodes, int first, int last, int order, double reach, std::vector<double>& values);

/// Lines become alike in their parts above the layers, relative to these: layers keep their heights, which are at
/// different parameters on lines of different lengths. What the object refers to must outlive it.
class TiedLines {
 public:
  /// `first`, `last`: fractions of the nodes on the sides that are the first and the last line. `parameters` of the
  /// nodes of all lines; those of the two sides are filled in.
  TiedLines(const LineFamily& family, const std::vector<NormalLine>& lines, const std::vector<double>& first,
            const std::vector<double>& last, std::vector<std::vector<double>>& parameters);

  /// Ties the lines themselves.
  void tie();
  /// Multiplies the intervals of each line between its layers by its factors, up to a common factor; the changes are
  /// tied to each other. Nodes keep their relative positions in their intervals.
  void scale(const std::vector<std::vector<double>>& factors);

 private:
  LineNodes nodes() const;
  void smooth(const LineNodes& nodes, std::vector<double>& values) const;
  void set(const std::vector<double>& relative);
  void scale_line(const std::vector<double>& factors, double* nodes) const;

  const LineFamily& family_;
  const std::vector<NormalLine>& lines_;
  std::vector<std::vector<double>>& parameters_;
  int num_nodes_, low_ = 0, high_ = 0;
};

}  // namespace quadrille::layers
