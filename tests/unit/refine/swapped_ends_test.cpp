#include "refine/swapped_ends.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "../chart_samples.hpp"
#include "../curved_surfaces.hpp"
#include "base/angle.hpp"
#include "mesh/lifted_mesh.hpp"

namespace quadrille::refine {
namespace {

constexpr double height = 0.8;

/// Of the cylinder of radius 1, whose chart is exp(-z + i angle).
Vec2 in_chart(double angle, double z) { return std::exp(-z) * unit(angle); }
Vec3 in_space(double angle, double z) { return {std::cos(angle), std::sin(angle), z}; }

SpaceCurve rim(const Nurbs& curve, double z) {
  SpaceCurve result{curve.degree, curve.knots, {}, curve.weights};
  for (const Vec2 pole : curve.poles) result.poles.push_back({std::exp(z) * pole.x, std::exp(z) * pole.y, z});
  return result;
}

/// The outline is at z = 0, the hole at z = `height`.
CadFace tube_face() {
  CadFace face;
  face.diameter = 2;
  face.loop_offsets = {0, 4, 8};
  Chart chart;
  for (int k = 0; k < 8; ++k) {
    const double z = k < 4 ? 0 : height;
    Nurbs curve = samples::quarter_circle(std::exp(-z), k < 4 ? k : 7 - k);
    if (k >= 4) std::ranges::reverse(curve.poles);
    chart.space_curves.push_back(rim(curve, z));
    face.curves.push_back(curve);
    face.curve_names.push_back("rim");
    face.curve_cad_edges.push_back(k);
    face.joints.push_back({curve.poles.front(), 0, 0, pi, false});
  }
  constexpr int sectors = 16;
  chart.order = 8;
  const auto add = [&](int i, double side) {  // from corner (i, 0) or, for `side` -1, from its opposite
    chart.elem2vertices.push_back({});
    for (const Vec2 xi : spectral::tri_nodes(chart.order)) {
      const double p = (1 + xi.x) / 2, q = (1 + xi.y) / 2;
      const double angle = 2 * pi / sectors * (side > 0 ? i + p : i + 1 - p), z = height * (side > 0 ? q : 1 - q);
      chart.nodes.push_back(in_chart(angle, z)), chart.space_nodes.push_back(in_space(angle, z));
      chart.uv.push_back({angle, z / height}), chart.log_scale.push_back(z);
    }
  };
  for (int i = 0; i < sectors; ++i) {
    const int next = (i + 1) % sectors;
    add(i, 1), chart.elem2vertices.back() = {i, next, sectors + i};
    add(i, -1), chart.elem2vertices.back() = {sectors + next, sectors + i, next};
  }
  chart.elem_surface.assign(chart.elem2vertices.size(), 0);
  chart.surfaces = {tests::cylinder(1, height)};
  face.chart = std::make_shared<const Chart>(std::move(chart));
  return face;
}

/// Eight by two elements of order 3, those at the outline shorter than the others.
QuadMesh uneven_mesh(const CadFace& face) {
  constexpr int around = 8, order = 3, width = order * around;
  QuadMesh mesh;
  mesh.face = face;
  mesh.order = order;
  for (int j = 0; j <= 2 * order; ++j)
    for (int i = 0; i < width; ++i)
      mesh.nodes.push_back(in_chart(2 * pi * i / width, height * std::pow(j / (2.0 * order), 1.3)));
  for (int layer = 0; layer < 2; ++layer)
    for (int e = 0; e < around; ++e) {
      for (int j = 0; j <= order; ++j)
        for (int i = 0; i <= order; ++i)
          mesh.elem_nodes.push_back((layer * order + j) * width + (e * order + i) % width);
      mesh.elem_block.push_back(0);
    }
  for (int e = 0; e < around; ++e) mesh.boundary_edges.push_back({e, 0, e / 2});
  for (int e = around - 1; e >= 0; --e) mesh.boundary_edges.push_back({around + e, 2, 7 - e / 2});
  return mesh;
}

TEST(SwappedEnds, APlaneBetweenThemIsFound) {
  const CadFace tube = tube_face();
  const auto mirror = end_mirror(mesh::ChartMap(tube), tube);
  ASSERT_TRUE(mirror);
  EXPECT_LT(distance((*mirror)(in_space(1, 0.1)), in_space(1, height - 0.1)), 1e-12);
}

TEST(SwappedEnds, TheBoundaryAndTheSurfaceMustBeSymmetric) {
  CadFace face = tube_face();
  Chart chart = *face.chart;
  for (Vec3& node : chart.space_nodes) node = node * (1 + 1e-3 * node.z);
  face.chart = std::make_shared<const Chart>(chart);
  EXPECT_FALSE(end_mirror(mesh::ChartMap(face), face));
  chart = *tube_face().chart;
  for (Vec3& pole : chart.space_curves.front().poles) pole.z -= 1e-3;
  face.chart = std::make_shared<const Chart>(chart);
  EXPECT_FALSE(end_mirror(mesh::ChartMap(face), face));
}

TEST(SwappedEnds, NodesBecomeSymmetricInSpaceAndInTheChart) {
  const CadFace tube = tube_face();
  const mesh::ChartMap map(tube);
  QuadMesh mesh = uneven_mesh(tube);
  mesh::lift_nodes(map, mesh);
  const SpaceMirror mirror = end_mirror(map, tube).value();
  const auto farthest = [&] {
    double most = 0;
    for (const Vec3 x : mesh.space_nodes) {
      double least = HUGE_VAL;
      for (const Vec3 y : mesh.space_nodes) least = std::min(least, distance(mirror(x), y));
      most = std::max(most, least);
    }
    return most;
  };
  EXPECT_GT(farthest(), 0.02);
  symmetrise(map, mirror, mesh);
  EXPECT_LT(farthest(), 1e-10);
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    EXPECT_LT(distance(map.lift(mesh.nodes[node]), mesh.space_nodes[node]), 1e-9) << node;
    EXPECT_NEAR(std::hypot(mesh.space_nodes[node].x, mesh.space_nodes[node].y), 1, 1e-12) << node;
  }
}

TEST(SwappedEnds, AMeshWithoutEdgesAtTheOtherEndStays) {
  const CadFace tube = tube_face();
  const mesh::ChartMap map(tube);
  QuadMesh mesh = uneven_mesh(tube);
  std::erase_if(mesh.boundary_edges, [](const QuadBoundaryEdge& e) { return e.curve >= 4; });
  mesh::lift_nodes(map, mesh);
  const std::vector<Vec3> before = mesh.space_nodes;
  symmetrise(map, end_mirror(map, tube).value(), mesh);
  EXPECT_EQ(mesh.space_nodes, before);
}

}  // namespace
}  // namespace quadrille::refine
