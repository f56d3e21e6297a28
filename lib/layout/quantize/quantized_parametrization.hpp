#pragma once
// A T-mesh parametrized by integers: its iso-lines (quantize/iso_lines.hpp) and their crossings with the arcs.

#include <map>
#include <vector>

#include "quantize/integer_sides.hpp"
#include "quantize/iso_lines.hpp"

namespace quadrille::quantize {

/// Of each arc: the fraction of its length at which an iso-line crosses it, by the number of the point.
using CrossingFractions = std::vector<std::map<int, double>>;

/// The faces with each arc replaced by the one that `same` has for it (model/periodic.hpp, first_arcs): what lies
/// beyond a periodic side is then the face inside the other one. Without any, the faces themselves.
std::vector<TFace> faces_across_periodic_sides(std::vector<TFace> faces, const std::vector<HalfEdge>& same);

class QuantizedParametrization {
 public:
  /// `faces` and `lengths` (integer, of the arcs; opposite sides of a face equal) must outlive it. `arc_lengths`: in
  /// the plane. Each crossing is moved towards the neighbouring crossings of its line, so that lines run straight
  /// through the transfinite maps of the faces; crossings of one arc keep at least a quarter of their even distance.
  /// `same`: lines that leave through an arc enter through the arc that is the same one; both have one length.
  QuantizedParametrization(const ArcGraph& t_mesh, const std::vector<TFace>& faces, const std::vector<int>& lengths,
                           std::vector<double> arc_lengths, const std::vector<HalfEdge>& same = {});

  QuantizedParametrization(const QuantizedParametrization&) = delete;
  QuantizedParametrization& operator=(const QuantizedParametrization&) = delete;

  const IntegerSides& sides() const { return is_finished_ ? own_sides_ : glued_sides_; }
  const IsoLines& lines() const { return lines_; }
  const CrossingFractions& crossing_fractions() const { return fractions_; }

  /// Fraction of a side's length (in the plane) at a position that is a node or a crossing.
  double side_fraction(int face, int side, int position) const;

 private:
  void copy_to_images(const std::vector<HalfEdge>& same);
  void straighten();
  double straightened(int arc, int number) const;
  double arc_fraction(HalfEdge h, double fraction_of_side) const;

  std::vector<TFace> glued_;
  IntegerSides own_sides_, glued_sides_;  // of the faces themselves, and across periodic sides
  bool is_finished_ = false;
  IsoLines lines_;
  std::vector<double> arc_lengths_;
  CrossingFractions fractions_;
};

}  // namespace quadrille::quantize
