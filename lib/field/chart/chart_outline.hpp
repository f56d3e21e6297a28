#pragma once
// The boundary of a chart: splines with the parameters of the curves in space.

#include <vector>

#include "chart/surface_mesh.hpp"
#include "model/space_face.hpp"

namespace quadrille::chart {

struct OutlineOptions {
  double tolerance = 1e-9;  ///< of the distance of the splines from the image: of their length, at most of the diameter
  double corner_angle = 0;  ///< radians, as ChartOptions
};

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
