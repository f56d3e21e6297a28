#include "triangulate/triangulate.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "faces.hpp"
#include "mesh/tri_topology.hpp"
#include "spectral/quadrature.hpp"
#include "triangulate/curved_edges.hpp"

namespace quadrille::triangulate {
namespace {

using namespace testing_faces;

/// Integral of det J over all elements, exact for the polynomials that they are.
double area_of(const TriMesh& mesh) {
  const spectral::Quadrature along = spectral::gauss_legendre(mesh.order + 1),
                             across = spectral::gauss_jacobi(mesh.order + 1, 1, 0);
  double area = 0;
  for (const spectral::TriMap& map : mesh::tri_maps(mesh)) {
    for (std::size_t j = 0; j < across.points.size(); ++j) {
      for (std::size_t i = 0; i < along.points.size(); ++i) {
        const double eta1 = along.points[i], eta2 = across.points[j];
        Vec2 x;
        Mat2 dx_dxi;
        map.evaluate({(1 + eta1) * (1 - eta2) / 2 - 1, eta2}, x, dx_dxi);
        area += along.weights[i] * across.weights[j] / 2 * det(dx_dxi);
      }
    }
  }
  return area;
}

int euler_count(const TriMesh& mesh) {
  const mesh::TriTopology topology = mesh::tri_topology(mesh);
  return static_cast<int>(mesh.vertices.size()) - static_cast<int>(topology.edge2vertices.size()) + mesh.num_elems();
}

/// What every mesh must be: conforming, of the face's topology, on its curves, proved valid.
void expect_sound(const TriMesh& mesh) {
  EXPECT_EQ(euler_count(mesh), mesh.face.euler_characteristic());
  EXPECT_EQ(mesh.elem_layer.size(), mesh.elem2vertices.size());
  for (const double ratio : jacobian_ratio_bounds(mesh)) EXPECT_GT(ratio, 0);
  std::vector<double> reached(mesh.face.num_curves());
  for (int c = 0; c < mesh.face.num_curves(); ++c) reached[c] = mesh.face.curves[c].begin();
  for (const BoundaryEdge& edge : mesh.boundary_edges) {
    EXPECT_EQ(edge.t0, reached[edge.curve]);
    EXPECT_LT(edge.t0, edge.t1);
    reached[edge.curve] = edge.t1;
    const auto& v = mesh.elem2vertices[edge.elem];
    const Nurbs& curve = mesh.face.curves[edge.curve];
    const double tol = 1e-14 * mesh.face.diameter;
    EXPECT_NEAR(distance(mesh.vertices[v[edge.edge]], curve::point(curve, edge.t0)), 0, tol);
    EXPECT_NEAR(distance(mesh.vertices[v[(edge.edge + 1) % 3]], curve::point(curve, edge.t1)), 0, tol);
  }
  for (int c = 0; c < mesh.face.num_curves(); ++c) EXPECT_EQ(reached[c], mesh.face.curves[c].end());
}

TriMesh triangulated(const CadFace& face, const TriangulateOptions& options = {}) {
  Report report;
  return triangulate(face, options, report);
}

struct Shape {
  const char* name;
  CadFace face;
  double area;
};

std::vector<Shape> shapes() {
  return {{"square", square(), 1},
          {"half disc", half_disc(), pi / 2},
          {"annulus", annulus(), 0.75 * pi},
          {"L", l_shape(), 3},
          {"stadium", stadium(), 4 + pi},
          {"thin gap", make_face({circle({0, 0}, 1), hole({0.398, 0}, 0.6)}), 0.64 * pi},
          {"small hole", make_face({polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), hole({0.3, 0.6}, 1e-3)}), 1 - 1e-6 * pi},
          {"tiny fillet",
           make_face({{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {1, 0.999}),
                       curve::circular_arc({0.999, 0.999}, 1e-3, 0, half_pi), curve::segment({0.999, 1}, {0, 1}),
                       curve::segment({0, 1}, {0, 0})}}),
           1 - 1e-6 * (1 - pi / 4)},
          {"sliver", make_face({polygon({{0, 0}, {1, 0}, {1, 0.02}})}), 0.01}};
}

TEST(Triangulate, EveryMeshIsSoundAndHasTheExactArea) {
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    const TriMesh mesh = triangulated(shape.face);
    expect_sound(mesh);
    EXPECT_NEAR(area_of(mesh) / shape.area, 1, 1e-12);
  }
}

TEST(Triangulate, MovedScaledAndMirroredCopiesAreSoundToo) {
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    for (const bool mirrored : {false, true}) {
      for (const double scale : {1e-6, 1.0, 1e5}) {
        const TriMesh mesh = triangulated(moved(shape.face, scale, 0.7, {0.3 * scale, -scale}, mirrored));
        expect_sound(mesh);
        EXPECT_NEAR(area_of(mesh) / (scale * scale * shape.area), 1, 1e-11);
      }
    }
  }
}

TEST(Triangulate, ScalingByAPowerOfTwoChangesNothingElse) {
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    const TriMesh mesh = triangulated(shape.face), large = triangulated(moved(shape.face, 1024, 0, {}));
    EXPECT_EQ(mesh.elem2vertices, large.elem2vertices);
    ASSERT_EQ(mesh.vertices.size(), large.vertices.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
      EXPECT_NEAR(distance(1024 * mesh.vertices[v], large.vertices[v]), 0, 1e-9);
  }
}

TEST(Triangulate, TheSameFaceGivesTheSameMesh) {
  for (const Shape& shape : shapes()) {
    const TriMesh a = triangulated(shape.face), b = triangulated(shape.face);
    EXPECT_EQ(a.vertices, b.vertices);
    EXPECT_EQ(a.elem2vertices, b.elem2vertices);
    EXPECT_EQ(a.curved_nodes, b.curved_nodes);
  }
}

TEST(Triangulate, OnlyElementsOnCurvesAreCurved) {
  EXPECT_TRUE(triangulated(square()).curved_elems.empty());
  const TriMesh half = triangulated(half_disc());
  EXPECT_GT(half.curved_elems.size(), 0u);
  std::vector<int> on_arc;
  for (const BoundaryEdge& edge : half.boundary_edges)
    if (edge.curve == 1) on_arc.push_back(edge.elem);
  std::sort(on_arc.begin(), on_arc.end());
  on_arc.erase(std::unique(on_arc.begin(), on_arc.end()), on_arc.end());
  EXPECT_EQ(half.curved_elems, on_arc);
}

TEST(Triangulate, EveryOrderWorks) {
  for (int order = 1; order <= 16; ++order) {
    TriangulateOptions options;
    options.order = order;
    Report report;
    const TriMesh mesh = triangulate(half_disc(), options, report);
    expect_sound(mesh);
    EXPECT_EQ(mesh.order, order);
    // The default order follows the arcs to 1e-12; low orders say how far they are off.
    if (order >= 8 || order <= 5) {
      EXPECT_EQ(report.warnings().size(), order <= 5 ? 1u : 0u) << order;
    }
  }
}

TEST(Triangulate, SizeBoundsTheElements) {
  TriangulateOptions options;
  options.size = 0.1;
  const TriMesh mesh = triangulated(square(), options);
  expect_sound(mesh);
  for (const auto& v : mesh.elem2vertices)
    for (int k = 0; k < 3; ++k) EXPECT_LE(distance(mesh.vertices[v[k]], mesh.vertices[v[(k + 1) % 3]]), 0.2);
}

TEST(Triangulate, LayersOfAFanAreTold) {
  const TriMesh mesh = triangulated(l_shape());
  // Layer 0 touches the reflex corner.
  for (int e = 0; e < mesh.num_elems(); ++e) {
    double least = 10;
    for (const int v : mesh.elem2vertices[e]) least = std::min(least, distance(mesh.vertices[v], {1, 1}));
    EXPECT_EQ(mesh.elem_layer[e] == 0, least < 1e-14);
  }
}

TEST(Triangulate, DetailsCostFewElements) {
  for (const Shape& shape : shapes()) EXPECT_LT(triangulated(shape.face).num_elems(), 450) << shape.name;
}

TEST(Triangulate, TouchingBoundariesAreRefusedWithTheirPlace) {
  CadFace face = make_face({circle({0, 0}, 1), hole({0.5, 0}, 0.5)});
  face.origin = {100, 0};
  try {
    triangulated(face);
    FAIL() << "no error";
  } catch (const ComputeError& error) {
    EXPECT_NE(std::string(error.what()).find("(101"), std::string::npos) << error.what();
  }
}

TEST(Triangulate, SizesAtPointsHoldInsideOnTheBoundaryAndInFans) {
  for (const Vec2 at : {Vec2{0.5, 0.5}, Vec2{1, 0.3}, Vec2{1, 1}}) {  // inside, on the boundary, at the reflex corner
    TriangulateOptions options;
    options.size_points = {{at, 0.02, 0}};
    const TriMesh mesh = triangulated(l_shape(), options);
    expect_sound(mesh);
    for (const auto& v : mesh.elem2vertices)
      for (int k = 0; k < 3; ++k) {
        const Vec2 a = mesh.vertices[v[k]], b = mesh.vertices[v[(k + 1) % 3]];
        EXPECT_LT(distance(a, b), 2 * (0.02 + options.growth * distance((a + b) / 2, at)));
      }
  }
}

TEST(Triangulate, OptionsOutsideTheirIntervalsAreRefused) {
  const auto refused = [](auto change) {
    TriangulateOptions options;
    change(options);
    EXPECT_THROW(options.validate(), UsageError);
  };
  refused([](auto& o) { o.order = 0; });
  refused([](auto& o) { o.order = 17; });
  refused([](auto& o) { o.size = -1; });
  refused([](auto& o) { o.growth = 0; });
  refused([](auto& o) { o.fan_factor = 1; });
  refused([](auto& o) { o.curve_tol = 0; });
}

}  // namespace
}  // namespace quadrille::triangulate
