#pragma once
// The boundary of a chart: splines with the parameters of the curves in space.

#include <vector>

#include "chart/surface_mesh.hpp"
#include "curve/least_squares_spline.hpp"
#include "model/space_face.hpp"

namespace quadrille::chart {

struct OutlineOptions {
  double tolerance = 1e-9;  ///< of the distance of the splines from the image: of their length, at most of the diameter
  double corner_angle = 0;  ///< radians, as ChartOptions
};

/// The image of one curve: points with ascending parameters, and the derivatives by the parameter at both ends.
struct CurveSamples {
  std::vector<curve::FitPoint> points;
  Vec2 start_derivative, end_derivative;
};

/// The spline through the image, with the parameters of the curve in space and as smooth at its knots; `tolerance`: a
/// length. Throws ComputeError if the curve is too short.
Nurbs fitted_curve(const SpaceCurve& space_curve, const CurveSamples& samples, double tolerance);

/// The tolerance of the splines of a chart, as in OutlineOptions: of one without elements, and of one that is closed.
inline constexpr double rough_outline_tolerance = 2e-3;
double outline_tolerance(double closedness);

/// The angle inside the face between the curve that ends at the start of `curve` and `curve`, in space, radians in
/// (0, 2 pi).
double space_angle(const SpaceFace& face, int curve, Vec3 normal);

/// The face in the plane of the image: splines through the images of the boundary nodes, which meet at the angles of
/// the curves in space. Their distance from the image may exceed the tolerance where the image is not smooth.
CadFace outline_of_image(const SpaceFace& face, const std::vector<SpaceLength>& lengths, const SurfaceMesh& mesh,
                         const OutlineOptions& options);

/// The joint at the start of `curve` of a face whose curves are known; its interior angle is given.
Joint joint_of(const CadFace& face, int curve, double interior_angle, double corner_angle);

/// Greatest distance between points of the outline.
double outline_diameter(const CadFace& face);

}  // namespace quadrille::chart
