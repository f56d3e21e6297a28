#pragma once
// The lines of a family across a block, tied to each other above their layers (layers/smooth_across).

#include <vector>

#include "layers/normal_line.hpp"
#include "layers/smooth_across.hpp"

namespace quadrille::layers {

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
  void set(const std::vector<double>& relative);
  void scale_line(const std::vector<double>& factors, double* nodes) const;

  const LineFamily& family_;
  const std::vector<NormalLine>& lines_;
  std::vector<std::vector<double>>& parameters_;
  int num_nodes_, low_ = 0, high_ = 0;
};

}  // namespace quadrille::layers
