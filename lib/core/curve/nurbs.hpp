#pragma once
// Evaluation and elementary operations on NURBS curves (Piegl and Tiller, The NURBS Book, ch. 3-5). Parameters outside
// the domain are clamped to it. Inner knots must have a multiplicity of at most `degree`.

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::curve {

/// The point at t.
Vec2 point(const Nurbs& curve, double t);

/// The first derivative with respect to t, at the cost of one point; one-sided as below.
Vec2 derivative(const Nurbs& curve, double t, bool from_left = false);

struct PointAndDerivative {
  Vec2 point, derivative;
};

/// Point and first derivative with respect to t, from the right, at the cost of one point.
PointAndDerivative point_and_derivative(const Nurbs& curve, double t);

/// Point and first three derivatives with respect to t. At a knot the limit from the right, or from the left if
/// `from_left`; at the ends of the curve the only limit that exists.
std::array<Vec2, 4> derivatives(const Nurbs& curve, double t, bool from_left = false);

/// Unit tangent in the direction of rising t (one-sided as above). If the first derivative vanishes, the limit
/// direction, from the next derivative that does not.
Vec2 tangent(const Nurbs& curve, double t, bool from_left = false);

/// Signed curvature (1 / length; positive: the curve bends to the left) and its derivative by arc length; zeros where
/// the curve has no speed.
struct Bend {
  double curvature = 0, slope = 0;
};

/// One-sided as above.
Bend bend(const Nurbs& curve, double t, bool from_left = false);

/// bend().curvature.
double curvature(const Nurbs& curve, double t, bool from_left = false);

/// The same curve in the opposite direction, on the same parameter interval.
Nurbs reversed(const Nurbs& curve);

/// The part of the curve on [t0, t1], t0 < t1, by knot insertion: exact, with the same parameters.
Nurbs trimmed(const Nurbs& curve, double t0, double t1);

/// The curve from `start` to `end`, bit for bit. Each pole moves by the displacements of the two ends, interpolated
/// linearly in the length of the control polygon up to it: poles that coincide remain so, and no leg of the polygon
/// turns by more than about the displacements over the polygon's length. A segment remains one.
Nurbs with_ends(Nurbs curve, Vec2 start, Vec2 end);

/// Length of the control polygon.
double polygon_length(const Nurbs& curve);

/// Calls visit(t0, t1) for each knot span that is not empty.
template <class Visit>
void for_each_span(const Nurbs& curve, const Visit& visit) {
  for (std::size_t i = 1; i < curve.knots.size(); ++i)
    if (curve.knots[i - 1] < curve.knots[i]) visit(curve.knots[i - 1], curve.knots[i]);
}

/// A straight segment with parameter 0..length.
Nurbs segment(Vec2 a, Vec2 b);

/// A circular arc as rational quadratic pieces of at most 90 degrees, counter-clockwise from angle0 to angle1 > angle0
/// (clockwise when angle1 < angle0), parameter = angle swept.
Nurbs circular_arc(Vec2 centre, double radius, double angle0, double angle1);

/// Interpolating C2 cubic spline through `points` at rising `parameters`, with prescribed end tangents d/dt.
Nurbs cubic_spline(const std::vector<double>& parameters, const std::vector<Vec2>& points, Vec2 start_derivative,
                   Vec2 end_derivative);

/// Inner knots at which the curve, parametrised by arc length, is less than C3: tangent, curvature or its derivative
/// along the curve jumps by more than `relative_tol` of its own scale. Ascending. The double knots of a circle are
/// none.
std::vector<double> smoothness_breaks(const Nurbs& curve, double relative_tol = 1e-7);

/// Whether the curve is closed and has no break at the point where it closes: a whole circle.
bool has_smooth_seam(const Nurbs& curve, double relative_tol = 1e-7);

}  // namespace quadrille::curve
