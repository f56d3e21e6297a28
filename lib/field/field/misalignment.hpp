#pragma once
// How far the crosses of a field are from prescribed directions.

#include "field/evaluate.hpp"
#include "model/alignment.hpp"

namespace quadrille::field {

/// Weighted sums over the middles of those Gaussians of an alignment that lie inside a mesh; a weight is the integral
/// of the Gaussian, rate width^2 up to a factor. Sums of several regions add up.
struct Misalignment {
  double weight = 0;
  double cosine_loss = 0;     ///< of 1 - cos(4 delta), delta the angle from the nearest direction of the cross
  double square_degrees = 0;  ///< of delta^2

  Misalignment& operator+=(const Misalignment& other);
  double mean_cosine_loss() const { return weight > 0 ? cosine_loss / weight : 0; }
  double rms_degrees() const;
};

Misalignment misalignment(const FieldEvaluator& evaluator, const Alignment& alignment);

}  // namespace quadrille::field
