#pragma once
// The points at which the lines across a chord meet each of its arcs: a monotone map from the chord's parameter to the
// arc's own arc-length fraction.

#include <vector>

namespace quadrille::sizing {

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

}  // namespace quadrille::sizing
