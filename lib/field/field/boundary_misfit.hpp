#pragma once
// Deviation of a discrete field from its exact boundary data, including the shape error of curved edges.

#include <vector>

#include "model/field.hpp"

namespace quadrille::field {

class PhaseBoundary;

/// For each element, the greatest |v_h(x_h) - v_b(t)| + |dv/dn| |x_h - x(t)| over sampled points of its boundary edges;
/// 0 for elements without boundary edge. x_h is the point of the element and x(t) the point of the curve at the same
/// arc length; only the component of x_h - x(t) normal to the curve counts. For a field of kind "phase", the same for
/// the phase, in radians: |s_h - g| + |dphi/dn| |x_h - x(t)|. `phase_boundary`: the data of the phase on this mesh, if
/// they were computed before.
std::vector<double> boundary_misfit(const Field& field, const PhaseBoundary* phase_boundary = nullptr);

}  // namespace quadrille::field
