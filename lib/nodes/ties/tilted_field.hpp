#pragma once
// Corners at ties: within 2 degrees of 45 + 90 k degrees two valences are equally good, and the field close to the
// corner decides nothing (lib/method.md §3). All that follows takes the angle of the tie itself, so that 44.98 and 45
// degrees get one layout.
//
// The field with its data tilted at all ties (field/corner_tilt), for any choice of the valences: the sum of the field
// for one choice and of parts that are solved for once.

#include <Eigen/Dense>
#include <functional>
#include <map>
#include <vector>

#include "curve/symmetry.hpp"
#include "field/corner_tilt.hpp"
#include "field/evaluate.hpp"
#include "model/cad_face.hpp"

namespace quadrille::ties {

struct Tie {
  int joint = 0;
  double angle = 0;  ///< of the tie, radians
  int smaller = 0;   ///< the smaller of both valences; 0 is no choice, because no block fits
};

/// The ties of a face. A *unit* has the ties that rotations of the face map onto each other, an *orbit* those that any
/// isometry does: one unit, or two that are mirror images.
struct TieOrbits {
  std::vector<Tie> ties;                 ///< in the order of the joints
  std::vector<std::vector<int>> units;   ///< of ties with a choice
  std::vector<std::vector<int>> orbits;  ///< of units
  std::vector<int> unit2orbit;
};

/// Isometries are those within a thousandth of the diameter: a symmetric part whose chamfers were drawn at 44.98
/// degrees is decided like one with 45.
TieOrbits tie_orbits(const CadFace& face);

/// Pairs of orbits with ties at both ends of a chamfer: the shorter of the two curves at a tie leads to the other. Each
/// pair once, ascending.
std::vector<std::vector<int>> chamfers(const CadFace& face, const TieOrbits& ties);

/// Which units of ties have the smaller valence.
using Choice = std::vector<bool>;

/// Solves for harmonic functions with the mesh of the field and these orders of elements, without coefficients that are
/// smaller than `negligible`.
using PartSolver = std::function<std::vector<field::HarmonicPart>(
    const std::vector<field::LiftedData>&, const std::vector<int>& elem_order, double negligible)>;

class TiltedField {
 public:
  /// `field` and `ties` must outlive this. Throws as `solve`.
  TiltedField(const Field& field, const TieOrbits& ties, PartSolver solve);

  /// The field for a choice, solved for as a whole.
  Field solved(const Choice& choice) const;

  /// The field for a choice, by parts: of more than 16 units without what is below 1e-6, so that memory does not grow
  /// like the square of the face. Valid until the next choice. Its error estimate is that for the larger valence
  /// everywhere.
  const field::FieldEvaluator& with(const Choice& choice);
  /// A bound of |v - v'| on an element, as far as sampled values tell, for two choices that differ in one unit.
  struct Change {
    int elem;
    double most;
  };
  /// Of the elements on which the unit counts.
  const std::vector<Change>& changes(std::size_t unit) const { return changes_[unit]; }
  /// Frees their memory; with() must not follow.
  void forget_parts();
  /// Of all parts, the memory that they take.
  std::size_t num_numbers() const;

 private:
  double negligible_part() const;
  std::vector<Change> changes_by(const field::HarmonicPart& part);

  const Field* field_;
  const TieOrbits* ties_;
  PartSolver solve_;
  Choice choice_;
  Field sum_;                                     ///< for choice_
  field::FieldEvaluator evaluator_;               ///< of sum_
  std::vector<field::HarmonicPart> odd_;          ///< of each unit
  std::vector<std::vector<Change>> changes_;      ///< by each unit
  std::map<int, Eigen::MatrixXd> sampled_basis_;  ///< by order
};

}  // namespace quadrille::ties
