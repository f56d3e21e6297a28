#include "field/misalignment.hpp"

#include <cmath>

#include "base/angle.hpp"

namespace quadrille::field {

Misalignment& Misalignment::operator+=(const Misalignment& other) {
  weight += other.weight;
  cosine_loss += other.cosine_loss;
  square_degrees += other.square_degrees;
  return *this;
}

double Misalignment::rms_degrees() const { return weight > 0 ? std::sqrt(square_degrees / weight) : 0; }

Misalignment misalignment(const FieldEvaluator& evaluator, const Alignment& alignment) {
  std::vector<Vec2> positions;
  for (const AlignmentPoint& point : alignment) positions.push_back(point.position);
  Misalignment sum;
  const std::vector<PointSample> samples = evaluator.values_at(positions);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (samples[k].at.elem < 0 || samples[k].value == Vec2{}) continue;
    const AlignmentPoint& point = alignment[k];
    const double weight = point.rate * point.width * point.width;
    const double turn = wrap_pi(angle_of(samples[k].value) - 4 * point.angle), degrees = turn / 4 * 180 / pi;
    sum += {weight, weight * (1 - std::cos(turn)), weight * degrees * degrees};
  }
  return sum;
}

}  // namespace quadrille::field
