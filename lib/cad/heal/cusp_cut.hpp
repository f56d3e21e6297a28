#pragma once
// Where the tip of a cusp is cut off. Private to this folder, except widest_cut().

#include <optional>

#include "model/cad_face.hpp"

namespace quadrille::heal {

/// The two curves of a cusp, `in` ending at its tip and `out` starting there, and how much may be cut off each of them,
/// a length. The pointers must outlive the object.
struct Cusp {
  const Nurbs* in = nullptr;
  const Nurbs* out = nullptr;
  double reach = 0;
};

/// `has_cusps_at_both_ends`: of one of the curves; then only half of the shorter curve may be cut off.
Cusp cusp_between(const Nurbs& in, const Nurbs& out, bool has_cusps_at_both_ends);

/// The least length to cut off both curves such that the distance of their new ends is `width`; std::nullopt if the
/// cusp is nowhere as wide within its reach.
std::optional<double> cut_length(const Cusp& cusp, double width);

/// The greatest width at which the cusp can be cut.
double widest_cut(const Cusp& cusp);

}  // namespace quadrille::heal
