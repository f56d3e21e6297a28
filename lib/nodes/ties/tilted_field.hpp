#pragma once
// The field with its data tilted at all ties (field/corner_tilt), for any choice of the valences: the sum of parts that
// are solved for once.

#include <functional>
#include <memory>
#include <vector>

#include "field/corner_tilt.hpp"
#include "field/evaluate.hpp"
#include "ties/tie_orbits.hpp"

namespace quadrille::ties {

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

 private:
  std::vector<double> greatest_changes();
  void find_empty_elements();

  Field sum_;                                         ///< with the odd parts of choice_
  Choice choice_;                                     ///< empty before the first choice
  std::vector<field::HarmonicPart> odd_;              ///< of each unit
  std::unique_ptr<field::FieldEvaluator> evaluator_;  ///< of sum_
  std::vector<bool> is_empty_;
};

}  // namespace quadrille::ties
