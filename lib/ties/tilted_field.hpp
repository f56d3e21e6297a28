#pragma once
// The field with its data tilted at all ties (field/corner_tilt), for any choice of the valences: the sum of parts that
// are solved for once.

#include <functional>
#include <memory>
#include <vector>

#include "field/corner_tilt.hpp"
#include "field/evaluate.hpp"
#include "field/harmonic_part.hpp"
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

 private:
  Field sum_;
  std::vector<double> u_, v_;  ///< coefficients without the odd parts of the units
  std::vector<Lifting> liftings_;
  std::vector<field::HarmonicPart> odd_;  ///< of each unit
  std::unique_ptr<field::FieldEvaluator> evaluator_;
};

}  // namespace quadrille::ties
