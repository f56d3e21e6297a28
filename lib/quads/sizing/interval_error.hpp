#pragma once
// Distance of the side of an element of order N from its curve.

#include "sizing/measured_layout.hpp"

namespace quadrille::sizing {

/// Greatest sampled distance between the chain and the order-N polynomial through its points at Gauss-Lobatto-Legendre
/// fractions of [low, high]: of the polynomial from the chain, and of the chain's breaks from the polynomial. `table`:
/// the chain's own.
double interval_error(const curve::CurveTable& table, const curve::Chain& chain, double low, double high, int order);

/// That of an arc.
inline double interval_error(const MeasuredLayout& measured, int arc, double low, double high, int order) {
  return interval_error(measured.curves(), measured.chain(arc), low, high, order);
}

}  // namespace quadrille::sizing
