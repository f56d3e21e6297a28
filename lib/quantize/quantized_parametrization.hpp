#pragma once
// A T-mesh parametrized by integers: its iso-lines (quantize/iso_lines.hpp) and their crossings with the arcs.

#include <map>
#include <vector>

#include "quantize/integer_sides.hpp"
#include "quantize/iso_lines.hpp"

namespace quadrille::quantize {

/// Of each arc: the fraction of its length at which an iso-line crosses it, by the number of the point.
using CrossingFractions = std::vector<std::map<int, double>>;

class QuantizedParametrization {
 public:
  /// `faces` and `lengths` (integer, of the arcs; opposite sides of a face equal) must outlive it. `arc_lengths`: in
  /// the plane. Each crossing is moved towards the neighbouring crossings of its line, so that lines run straight
  /// through the transfinite maps of the faces; crossings of one arc keep at least a quarter of their even distance.
  QuantizedParametrization(const ArcGraph& t_mesh, const std::vector<TFace>& faces, const std::vector<int>& lengths,
                           std::vector<double> arc_lengths);

  const IntegerSides& sides() const { return sides_; }
  const IsoLines& lines() const { return lines_; }
  const CrossingFractions& crossing_fractions() const { return fractions_; }

  /// Fraction of a side's length (in the plane) at a position that is a node or a crossing.
  double side_fraction(int face, int side, int position) const;

 private:
  void straighten();
  double straightened(int arc, int number) const;
  double arc_fraction(HalfEdge h, double fraction_of_side) const;

  IntegerSides sides_;
  IsoLines lines_;
  std::vector<double> arc_lengths_;
  CrossingFractions fractions_;
};

}  // namespace quadrille::quantize
