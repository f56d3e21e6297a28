#pragma once
// A T-mesh parametrized by integers: its iso-lines, which continue the lines that stop at its T-junctions, and their
// crossings with the arcs.
//
// Positions on a side of a face are counted counter-clockwise, from 0 to the side's length; points inside an arc are
// numbered in the arc's own direction.

#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "model/separatrix_graph.hpp"
#include "quantize/quantize.hpp"

namespace quadrille::quantize {

/// Position of a half-edge: side of a face, and the position on the side at which it starts.
struct SidePosition {
  int face = -1, side = 0, offset = 0;
};

/// The sides of the faces of a T-mesh whose arcs have integer lengths, as number lines.
class IntegerSides {
 public:
  /// `faces` and `lengths` (of the arcs, opposite sides of a face equal) must outlive it.
  IntegerSides(const std::vector<TFace>& faces, const std::vector<int>& lengths);

  const std::vector<TFace>& faces() const { return faces_; }
  /// Face -1 if a boundary arc has no face on that side.
  const SidePosition& position_of(HalfEdge h) const { return positions_[h.index()]; }
  /// Length of a side.
  int total(int face, int side) const { return totals_[face][side]; }
  /// Length of an arc.
  int arc(int a) const { return lengths_[a]; }
  /// The half-edge of a side at a position, and the position along the half-edge: 0 < number <= its length.
  std::pair<HalfEdge, int> half_edge_at(int face, int side, int position) const;

 private:
  const std::vector<TFace>& faces_;
  const std::vector<int>& lengths_;
  std::vector<SidePosition> positions_;
  std::vector<std::array<int, 4>> totals_;
};

/// Lines through the integer grids of the faces.
struct IsoLines {
  /// Of each arc: the numbers of its points where lines cross it, 0 < number < length.
  std::vector<std::set<int>> crossings;
  /// Of each face: the lines from side 0 to side 2 and from side 1 to side 3, by the position where they start.
  std::vector<std::array<std::set<int>, 2>> lines;
};

/// Each line continues through face after face until it meets the boundary, or a T-junction from the other side, whose
/// line it joins.
IsoLines iso_lines(const ArcGraph& t_mesh, const IntegerSides& sides);

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
