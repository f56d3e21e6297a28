#pragma once
// Corners at ties: within 2 degrees of 45 + 90 k degrees two valences are equally good, and the field close to the
// corner decides nothing (lib/method.md §3). All that follows takes the angle of the tie itself, so that 44.98 and 45
// degrees get one layout.
//
// The field with its data tilted at all ties (field/corner_tilt), for any choice of the valences: the sum of parts that
// are solved for once.

#include <Eigen/Dense>
#include <functional>
#include <map>
#include <memory>
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

/// Solves for harmonic functions with the mesh and the orders of the field.
using PartSolver = std::function<std::vector<field::HarmonicPart>(const std::vector<field::LiftedData>&)>;

class TiltedField {
 public:
  TiltedField(const Field& field, const TieOrbits& ties, const PartSolver& solve);

  /// Valid until the next choice. Its error estimate is that of the first choice.
  const field::FieldEvaluator& with(const Choice& choice);
  /// For each element whether it has no zero for any choice, as far as sampled values of the tilts tell.
  const std::vector<bool>& is_empty() const { return is_empty_; }
  /// For each element a bound of the difference between the fields of two choices, as far as sampled values tell.
  std::vector<double> changes(const Choice& from, const Choice& to) const;

 private:
  std::vector<double> greatest_values(const field::HarmonicPart& part);
  void find_empty_elements();

  Field sum_;                                         ///< with the odd parts of choice_
  Choice choice_;                                     ///< empty before the first choice
  std::vector<field::HarmonicPart> odd_;              ///< of each unit
  std::vector<std::vector<double>> greatest_;         ///< |odd part| of each unit on its elements, twice the sampled
  std::map<int, Eigen::MatrixXd> sampled_basis_;      ///< by order
  std::unique_ptr<field::FieldEvaluator> evaluator_;  ///< of sum_
  std::vector<bool> is_empty_;
};

}  // namespace quadrille::ties
