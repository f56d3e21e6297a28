#pragma once
// A block layout with its lengths: the curve, the chord and the parameter of each of its arcs.
//
// Sizes, divisions, wall layers and the split into elements all work on this value. A chord's parameter u in [0, 1]
// runs over all of its arcs at once: a line across the chord meets each arc at the same u. On arc a, in its own
// direction, this is the fraction parameter(a).fraction(u) of its length, or of 1 - u if the chord runs along it
// backwards.

#include <memory>
#include <vector>

#include "curve/chain.hpp"
#include "mesh/chords.hpp"
#include "model/block_layout.hpp"
#include "sizing/arc_parameter.hpp"

namespace quadrille::sizing {

class MeasuredLayout {
 public:
  /// Equal parameters at equal fractions of the length. `layout` must outlive the value and all copies, and must not
  /// change meanwhile; copies refer to the same lengths and chords.
  explicit MeasuredLayout(const BlockLayout& layout);
  explicit MeasuredLayout(BlockLayout&& layout) = delete;
  /// The same layout with other parameters, one per arc.
  MeasuredLayout with_parameters(std::vector<ArcParameter> parameters) const;
  MeasuredLayout with_equal_parameters() const { return with_parameters(std::vector<ArcParameter>(num_arcs())); }

  const BlockLayout& blocks() const { return *geometry_->blocks; }
  int num_arcs() const { return static_cast<int>(geometry_->chains.size()); }
  const curve::Chain& chain(int arc) const { return geometry_->chains[arc]; }
  double length(int arc) const { return chain(arc).length(); }
  /// The table of the chains' curves; it lives as long as this value or a copy.
  const curve::CurveTable& curves() const { return geometry_->curves; }

  const std::vector<mesh::Chord>& chords() const { return geometry_->chords; }
  int chord_of(int arc) const { return geometry_->arc_chord[arc]; }
  /// The region that the arc is in; -1: between two, or there is only one.
  int region_of(int arc) const { return geometry_->arc_region[arc]; }
  int region_of_block(int block) const { return blocks().block_region.empty() ? -1 : blocks().block_region[block]; }
  const std::vector<PeriodicArcs>& periodic_arcs() const { return geometry_->periodic; }
  /// Whether another arc has the same two ends.
  bool is_parallel(int arc) const { return geometry_->is_parallel[arc]; }

  const ArcParameter& parameter(int arc) const { return parameters_[arc]; }
  /// Whether all parameters are the identity.
  bool has_equal_parameters() const;
  /// Between the parameter u of a chord and the fraction of the length of its arc number i, in the arc's own direction.
  double arc_fraction(const mesh::Chord& chord, int i, double u) const;
  double chord_parameter(const mesh::Chord& chord, int i, double fraction) const;

 private:
  struct Geometry {
    const BlockLayout* blocks;
    curve::CurveTable curves;
    std::vector<curve::Chain> chains;  ///< by arc; they refer to `curves`
    std::vector<PeriodicArcs> periodic;
    std::vector<int> arc_chord, arc_region;
    std::vector<mesh::Chord> chords;
    std::vector<bool> is_parallel;  ///< by arc

    explicit Geometry(const BlockLayout& layout);
    Geometry(const Geometry&) = delete;
    Geometry& operator=(const Geometry&) = delete;
  };
  std::shared_ptr<const Geometry> geometry_;
  std::vector<ArcParameter> parameters_;
};

}  // namespace quadrille::sizing
