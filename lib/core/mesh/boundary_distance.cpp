#include "mesh/boundary_distance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/message_text.hpp"
#include "base/warning_codes.hpp"
#include "curve/nurbs.hpp"
#include "model/quad_mesh.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"
#include "surface/positions.hpp"

namespace quadrille::mesh {
namespace {

constexpr int least_span_samples = 8;

int samples_per_side(int order) { return 4 * (order + 1); }

/// From the nodes of a side to its Bernstein coefficients, and to samples on it.
struct SideMaps {
  Eigen::MatrixXd to_bezier, to_samples;

  explicit SideMaps(int order) {
    Eigen::MatrixXd bernstein = Eigen::MatrixXd::Zero(order + 1, order + 1);
    for (int i = 0; i <= order; ++i) {
      const double t = (1 + spectral::gll_points(order)[i]) / 2;
      bernstein(i, 0) = 1;
      for (int degree = 1; degree <= order; ++degree)  // de Casteljau's triangle
        for (int k = degree; k >= 0; --k)
          bernstein(i, k) = (1 - t) * bernstein(i, k) + (k > 0 ? t * bernstein(i, k - 1) : 0.0);
    }
    to_bezier = bernstein.inverse();
    std::vector<double> samples;
    for (int i = 0; i < samples_per_side(order); ++i) samples.push_back(-1 + (2.0 * i + 1) / samples_per_side(order));
    to_samples = spectral::interpolation_matrix(spectral::gll_points(order), samples);
  }
};

std::vector<Vec2> mapped(const Eigen::MatrixXd& map, const std::vector<Vec2>& nodes) {
  std::vector<Vec2> result(map.rows());
  for (int i = 0; i < map.rows(); ++i)
    for (int k = 0; k < map.cols(); ++k) result[i] += map(i, k) * nodes[k];
  return result;
}

std::vector<Vec2> side_positions(const QuadMesh& mesh, const QuadBoundaryEdge& edge) {
  std::vector<Vec2> positions;
  for (const int node : side_nodes(mesh, edge.elem, edge.side)) positions.push_back(mesh.nodes[node]);
  return positions;
}

Nurbs bezier_curve(std::vector<Vec2> poles) {
  Nurbs curve;
  curve.degree = static_cast<int>(poles.size()) - 1;
  curve.knots.assign(poles.size(), 0.0);
  curve.knots.resize(2 * poles.size(), 1.0);
  curve.weights.assign(poles.size(), 1.0);
  curve.poles = std::move(poles);
  return curve;
}

/// The mesh's side of the comparison: its boundary as curves, points on it, and its mean spacing of points.
struct MeshBoundary {
  std::vector<Nurbs> curves;
  std::vector<Vec2> samples;
  double spacing = 0;
};

MeshBoundary mesh_boundary(const QuadMesh& mesh) {
  const SideMaps& maps = spectral::table_per_order<SideMaps>(mesh.order);
  MeshBoundary boundary;
  double length = 0;
  std::vector<QuadBoundaryEdge> edges = mesh.boundary_edges;
  for (const QuadBoundaryEdge& edge : mesh.interface_edges)
    if (mesh.face.is_interface(edge.curve) && edge.curve < mesh.face.partners[edge.curve])
      edges.push_back(edge);  // both sides have the same nodes
  for (const QuadBoundaryEdge& edge : edges) {
    const std::vector<Vec2> nodes = side_positions(mesh, edge);
    boundary.curves.push_back(bezier_curve(mapped(maps.to_bezier, nodes)));
    const std::vector<Vec2> samples = mapped(maps.to_samples, nodes);
    boundary.samples.insert(boundary.samples.end(), samples.begin(), samples.end());
    length += distance(nodes.front(), nodes.back());
  }
  boundary.spacing = length / static_cast<double>(boundary.samples.size());
  return boundary;
}

void append_samples(const Nurbs& curve, double spacing, std::vector<Vec2>& samples) {
  curve::for_each_span(curve, [&](double t0, double t1) {
    const Vec2 middle = curve::point(curve, (t0 + t1) / 2);
    const double length = distance(curve::point(curve, t0), middle) + distance(middle, curve::point(curve, t1));
    const int count = std::max(least_span_samples, static_cast<int>(std::ceil(length / spacing)));
    for (int i = 0; i < count; ++i) samples.push_back(curve::point(curve, t0 + (t1 - t0) * i / count));
  });
}

}  // namespace

BoundaryDistance boundary_distance(const QuadMesh& mesh) {
  const MeshBoundary boundary = mesh_boundary(mesh);
  std::vector<Vec2> cad_samples;
  for (const Nurbs& curve : mesh.face.curves) append_samples(curve, boundary.spacing, cad_samples);
  BoundaryDistance result{curve::CurveTree(mesh.face.curves).farthest(boundary.samples),
                          curve::CurveTree(boundary.curves).farthest(cad_samples)};
  result.mesh_to_cad.distance += mesh.face.fit_distance;
  result.cad_to_mesh.distance += mesh.face.fit_distance;
  return result;
}

void report_distance(const BoundaryDistance& distance, const CadFace& face, double tolerance, Report& report) {
  const curve::FarthestPoint& worst = distance.worst();
  report.set("boundary.mesh_to_cad", distance.mesh_to_cad.distance);
  report.set("boundary.cad_to_mesh", distance.cad_to_mesh.distance);
  report.set("boundary.position", surface::position_in_file(face, worst.position));
  report.set("boundary.tolerance", tolerance);
  if (distance.is_within(tolerance)) return;
  const bool is_by_fit = 2 * face.fit_distance > tolerance;
  report.warn(warning::geometry_tol_missed,
              fmt::format("the boundary of the mesh deviates from the CAD curves by up to {:.2g} diameters at {}, "
                          "more than the geometric tolerance {:.2g}: {}",
                          worst.distance / face.diameter, surface::position_text(face, worst.position),
                          tolerance / face.diameter,
                          is_by_fit ? "lower --fit-tolerance of cad2tri" : "raise --order or lower --size"));
}

}  // namespace quadrille::mesh
