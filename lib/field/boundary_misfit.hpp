#pragma once
// How far a discrete field is from its exact boundary data, the error of the curved edges' shape included.

#include <vector>

#include "model/field.hpp"

namespace quadrille::field {

/// For each element the greatest |v_h(x_h) - v_b(t)| + |dv/dn| |x_h - x(t)| over points of its boundary edges, x_h the
/// element's and x(t) the curve's point at the same arc length, only the distance across the curve counting; 0 for
/// elements inside. Of a field of kind "phase" the same of its phase: |s_h - g| + |dphi/dn| |x_h - x(t)|.
std::vector<double> boundary_misfit(const Field& field);

}  // namespace quadrille::field
