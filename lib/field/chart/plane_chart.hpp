#pragma once
// A face in a plane is its own chart.

#include <optional>

#include "chart/surface_mesh.hpp"

namespace quadrille::chart {

struct PlaneChart {
  CadFace face;  ///< the curves in the plane, exactly: without a chart
  SurfaceMesh mesh;
};

/// Of a face whose surface and curves lie in one plane; std::nullopt for others. `corner_angle`: as ChartOptions.
std::optional<PlaneChart> plane_chart(const SpaceFace& face, double corner_angle);

}  // namespace quadrille::chart
