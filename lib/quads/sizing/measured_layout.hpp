#pragma once
// A block layout with its lengths: the curve, the chord and the parameter of each of its arcs.
//
// Sizes, divisions, wall layers and the split into elements all work on this value. A chord's parameter u in [0, 1]
// runs over all of its arcs at once: a line across the chord meets each arc at the same u. On arc a, in its own
// direction, this is the fraction parameter(a).fraction(u) of its length, or of 1 - u if the chord runs along it
// backwards. The ends of elements on an arc are fractions of its length, too.

#include <memory>
#include <optional>
#include <vector>

#include "curve/chain.hpp"
#include "curve/symmetry_lines.hpp"
#include "mesh/chords.hpp"
#include "model/block_layout.hpp"
#include "model/interfaces.hpp"

namespace quadrille::sizing {

/// Fractions of the arc's length in its own direction, ascending from 0 to 1: element k lies between ends k and k + 1.
struct ArcDivision {
  std::vector<double> ends{0.0, 1.0};

  int num_intervals() const { return static_cast<int>(ends.size()) - 1; }
  double low(int k) const { return ends[k]; }
  double high(int k) const { return ends[k + 1]; }
  double width(int k) const { return ends[k + 1] - ends[k]; }
  double middle(int k) const { return (ends[k] + ends[k + 1]) / 2; }
};

/// One per arc of a layout; arcs of one chord have the same number of intervals.
using ArcDivisions = std::vector<ArcDivision>;

/// The same points as fractions from the other end.
void reverse_fractions(std::vector<double>& fractions);

/// Whether one of them is this one, but for rounding.
bool has_fraction(const std::vector<double>& fractions, double fraction);

/// Fractions of the chain's joints, ascending, between curves of different names of which at least one was given: no
/// edge of an element may belong to both curves. Default names made from numbers do not count. All pieces of the chain
/// must be CAD curves.
std::vector<double> name_joints(const curve::Chain& chain, const CadFace& face);

/// The points at which the lines across a chord meet one of its arcs: a monotone map from the chord's parameter to the
/// arc's own arc-length fraction.
class ArcParameter {
 public:
  /// The identity: equal parameters at equal fractions.
  ArcParameter() = default;
  /// Through `fractions` (rising, from 0 to 1) at equally spaced parameters, by cubic Hermite pieces.
  explicit ArcParameter(std::vector<double> fractions);

  /// Both run along the arc's own direction; u, fraction in [0, 1].
  double fraction(double u) const;
  double parameter(double fraction) const;
  bool is_identity() const { return fractions_.empty(); }

 private:
  std::vector<double> fractions_, slopes_;  ///< slope by the sample number
};

/// The side of a block on a line of symmetry that divides a block of the whole (sizing/halved_blocks).
struct HalvedSide {
  int side = 0;
  curve::SymmetryLine line;
};

/// By block; empty if there are none.
using HalvedSides = std::vector<std::optional<HalvedSide>>;

class MeasuredLayout {
 public:
  /// Equal parameters at equal fractions of the length. `layout` must outlive the value and all copies, and must not
  /// change meanwhile; copies refer to the same lengths and chords.
  explicit MeasuredLayout(const BlockLayout& layout);
  explicit MeasuredLayout(BlockLayout&& layout) = delete;
  /// The same layout with other parameters, one per arc, and these halved sides.
  MeasuredLayout with_parameters(std::vector<ArcParameter> parameters, HalvedSides halved = {}) const;

  const BlockLayout& blocks() const { return *geometry_->blocks; }
  int num_arcs() const { return static_cast<int>(geometry_->chains.size()); }
  const curve::Chain& chain(int arc) const { return geometry_->chains[arc]; }
  double length(int arc) const { return chain(arc).length(); }
  /// The table of the chains' curves; it lives as long as this value or a copy.
  const curve::CurveTable& curves() const { return geometry_->curves; }
  bool is_on_cad_curve(int arc) const { return quadrille::is_on_cad_curve(blocks(), blocks().arcs[arc]); }
  std::vector<double> name_joints(int arc) const { return sizing::name_joints(chain(arc), blocks().face); }

  const std::vector<mesh::Chord>& chords() const { return geometry_->chords; }
  int chord_of(int arc) const { return geometry_->arc_chord[arc]; }
  /// The chord whose count is the number of elements along a side of a block.
  int chord_along(int block, int side) const { return chord_of(blocks().block2arcs[block][side].arc); }
  /// The number of the arc in its chord.
  int position_in_chord(int arc) const { return geometry_->arc_position[arc]; }
  /// The region that the arc is in; -1: between two, or there is only one.
  int region_of(int arc) const { return geometry_->arc_region[arc]; }
  int region_of_block(int block) const { return blocks().block_region.empty() ? -1 : blocks().block_region[block]; }
  const std::vector<PeriodicArcs>& periodic_arcs() const { return geometry_->periodic; }
  /// Whether another arc has the same two ends.
  bool is_parallel(int arc) const { return geometry_->is_parallel[arc]; }

  const ArcParameter& parameter(int arc) const { return parameters_[arc]; }
  /// nullptr: the block is not one half of a block of the whole.
  const HalvedSide* halved_side(int block) const {
    return halved_.empty() || !halved_[block] ? nullptr : &*halved_[block];
  }
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
    std::vector<int> arc_chord, arc_position, arc_region;
    std::vector<mesh::Chord> chords;
    std::vector<bool> is_parallel;  ///< by arc

    explicit Geometry(const BlockLayout& layout);
    Geometry(const Geometry&) = delete;
    Geometry& operator=(const Geometry&) = delete;
  };
  std::shared_ptr<const Geometry> geometry_;
  std::vector<ArcParameter> parameters_;
  HalvedSides halved_;
};

}  // namespace quadrille::sizing
