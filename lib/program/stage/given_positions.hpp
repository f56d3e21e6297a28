#pragma once
// Positions that users give in files, on the face: of a planar face (x, y), relative to face.origin; of a curved face
// (x, y, z), as they are in space.

#include <functional>
#include <string>
#include <vector>

#include "model/cad_face.hpp"
#include "model/given_metric.hpp"
#include "model/size_sources.hpp"

namespace quadrille::stage {

/// Joins the points of a table, at these positions in the plane or in the chart, by triangles:
/// triangulate::add_size_triangles, which the library for other programs has in another component.
using JoinPoints = std::function<void(SizeSources& sources, const std::vector<Vec2>& positions)>;

/// Those of a size field as it was read (io/size_field_io.hpp), the points of a table joined by triangles; of a table
/// in space, points farther than a hundredth of the diameter from the face are left out. Throws UsageError, which
/// begins with `where`, for positions with two coordinates on a curved face, for those with three of points and boxes
/// on a planar one, for a table without a point at the face, and for a table without `join`.
SizeSources sizes_on_face(SizeSources sources, const CadFace& face, const JoinPoints& join, const std::string& where);

/// The samples in the plane or in the chart, of the samples in space those at the face as above: by the tensor J^T M J,
/// J the derivatives of the position in space by that in the chart. Throws UsageError as above, and for a metric of two
/// dimensions on a curved face.
std::vector<MetricSample> metric_on_face(const GivenMetric& metric, const CadFace& face, const std::string& where);

/// The same of directions. Those of points, curves and boxes are angles in a plane: on a curved face they are refused.
/// Those without a width have that of D / 20.
AlignmentRequest alignment_on_face(const GivenAlignment& alignment, const CadFace& face, const std::string& where);

}  // namespace quadrille::stage
