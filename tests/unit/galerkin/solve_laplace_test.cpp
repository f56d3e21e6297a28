#include "galerkin/solve_laplace.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <string>

#include "../test_meshes.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "field/evaluate.hpp"

namespace quadrille::galerkin {
namespace {

Vec2 power(Vec2 x, int n) {
  const std::complex<double> z = std::pow(std::complex<double>(x.x, x.y), n);
  return {z.real(), z.imag()};
}

Field solve_power(const TriMesh& mesh, const std::vector<int>& orders, int n, FieldMethod method = FieldMethod::cg) {
  Report report;
  return LaplaceSolver(
             mesh, [&](int curve, double t) { return power(curve::point(mesh.face.curves[curve], t), n); }, method)
      .solve(orders, report);
}

// Greatest difference from z^n at points of every element, vertices and edges included.
double error_of_power(const Field& field, int n) {
  const field::FieldEvaluator evaluator(field);
  double worst = 0;
  for (int e = 0; e < field.mesh.num_elems(); ++e) {
    for (const Vec2 xi : spectral::tri_nodes(5)) {
      const field::FieldSample sample = evaluator.sample(e, xi);
      worst = std::max(worst, distance(sample.value, power(sample.x, n)));
    }
  }
  return worst;
}

// A fixed order map that changes from element to element.
std::vector<int> scattered_orders(int num_elems, int lowest, int spread) {
  std::vector<int> orders;
  for (int e = 0; e < num_elems; ++e) orders.push_back(lowest + (7 * e * e + 3 * e) % (spread + 1));
  return orders;
}

class HarmonicPolynomial : public testing::TestWithParam<int> {};

TEST_P(HarmonicPolynomial, IsReproducedOnStraightElements) {
  const int n = GetParam();
  const TriMesh mesh = parallelogram_mesh({-0.4, -0.3}, {0.9, 0.2}, {-0.3, 0.8}, 3);
  for (const int order : {n, n + 1, n + 3}) {
    const Field field = solve_power(mesh, std::vector<int>(mesh.num_elems(), order), n);
    EXPECT_LT(error_of_power(field, n), 1e-13) << order;
  }
}

TEST_P(HarmonicPolynomial, IsReproducedWithAnyOrderMap) {
  const int n = GetParam();
  const TriMesh mesh = parallelogram_mesh({-0.4, -0.3}, {0.9, 0.2}, {-0.3, 0.8}, 4);
  const Field field = solve_power(mesh, scattered_orders(mesh.num_elems(), n, 6), n);
  EXPECT_LT(error_of_power(field, n), 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Degrees, HarmonicPolynomial, testing::Values(1, 2, 3, 5, 8, 12, 16));

class HybridisedPolynomial : public testing::TestWithParam<int> {};

TEST_P(HybridisedPolynomial, IsReproducedOnStraightElements) {
  const int n = GetParam();
  const TriMesh mesh = parallelogram_mesh({-0.4, -0.3}, {0.9, 0.2}, {-0.3, 0.8}, 3);
  for (const int order : {n, n + 1, n + 3}) {
    const Field field = solve_power(mesh, std::vector<int>(mesh.num_elems(), order), n, FieldMethod::dg);
    EXPECT_LT(error_of_power(field, n), 1e-12) << order;
  }
}

TEST_P(HybridisedPolynomial, IsReproducedWithAnyOrderMap) {
  const int n = GetParam();
  const TriMesh mesh = parallelogram_mesh({-0.4, -0.3}, {0.9, 0.2}, {-0.3, 0.8}, 4);
  const Field field = solve_power(mesh, scattered_orders(mesh.num_elems(), n, 12 - n), n, FieldMethod::dg);
  EXPECT_LT(error_of_power(field, n), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Degrees, HybridisedPolynomial, testing::Values(1, 2, 3, 5, 8, 9));

TEST(Hybridised, JumpsAcrossEdgesFallWithTheOrder) {
  // z^9 is no polynomial of these orders; what is discontinuous is only as large as the error.
  const TriMesh mesh = parallelogram_mesh({-1, -1}, {2, 0.3}, {0.2, 2}, 3);
  double last = 1e9;
  for (const int order : {3, 5, 7}) {
    const Field field = solve_power(mesh, std::vector<int>(mesh.num_elems(), order), 9, FieldMethod::dg);
    const double error = error_of_power(field, 9);
    EXPECT_LT(error, last / 4);
    last = error;
  }
}

TEST(Hybridised, MeetsDataThatJumpInTheMeanOnly) {
  // Left in the data, the jumps of a parallelogram's corners cost accuracy beside them, and little far away.
  const TriMesh mesh = parallelogram_mesh({0, 0}, {2, 0}, {0.5, 1}, 6);
  const std::vector<int> orders(mesh.num_elems(), 10);
  Report report;
  const Field lifted = solve_laplace(mesh, orders, {FieldMethod::dg, CornerData::lift}, report);
  const Field direct = solve_laplace(mesh, orders, {FieldMethod::dg, CornerData::dg}, report);
  EXPECT_EQ(lifted.liftings.size(), 4u);
  EXPECT_TRUE(direct.liftings.empty());
  EXPECT_EQ(options_of(direct).corners, CornerData::dg);
  EXPECT_EQ(options_of(lifted).corners, CornerData::lift);
  const field::FieldEvaluator exact(lifted), rough(direct);
  Vec2 a, b;
  ASSERT_TRUE(exact.value_at({1.25, 0.5}, a));
  ASSERT_TRUE(rough.value_at({1.25, 0.5}, b));
  EXPECT_LT(distance(a, b), 1e-3);
  EXPECT_GT(distance(a, b), 1e-12);
}

TEST(SolveLaplace, ContinuousElementsRefuseDataThatJump) {
  const TriMesh mesh = parallelogram_mesh({0, 0}, {2, 0}, {0.5, 1}, 2);
  Report report;
  EXPECT_THROW(solve_laplace(mesh, std::vector<int>(mesh.num_elems(), 4), {FieldMethod::cg, CornerData::dg}, report),
               ComputeError);
  const TriMesh square = parallelogram_mesh({0, 0}, {1, 0}, {0, 1}, 2);
  EXPECT_NO_THROW(
      solve_laplace(square, std::vector<int>(square.num_elems(), 4), {FieldMethod::cg, CornerData::dg}, report));
}

TEST(SolveLaplace, MethodsAgreeOnALiftedField) {
  const TriMesh mesh = parallelogram_mesh({0, 0}, {2, 0}, {0.5, 1}, 6);
  const std::vector<int> orders(mesh.num_elems(), 12);
  Report report;
  const Field cg = solve_laplace(mesh, orders, {FieldMethod::cg, CornerData::lift}, report),
              dg = solve_laplace(mesh, orders, {FieldMethod::dg, CornerData::lift}, report);
  const field::FieldEvaluator a(cg), b(dg);
  for (int e = 0; e < mesh.num_elems(); ++e)
    EXPECT_LT(distance(a.sample(e, {-0.3, -0.4}).value, b.sample(e, {-0.3, -0.4}).value), 1e-6) << e;
}

TEST(SolveLaplace, OneElementWithoutUnknownsWorks) {
  TriMesh mesh = parallelogram_mesh({0, 0}, {1, 0}, {0, 1}, 1);
  const Field field = solve_power(mesh, {2, 2}, 2);
  EXPECT_LT(error_of_power(field, 2), 1e-14);
}

TEST(SolveLaplace, FieldIsContinuousAcrossEdgesOfUnequalOrder) {
  // z^9 is beyond most elements' order: the solution is not exact, but one-valued on every edge.
  const TriMesh mesh = parallelogram_mesh({-1, -1}, {2, 0.3}, {0.2, 2}, 3);
  const Field field = solve_power(mesh, scattered_orders(mesh.num_elems(), 2, 5), 9);
  const field::FieldEvaluator evaluator(field);
  const mesh::TriTopology& topology = evaluator.topology();
  double jump = 0;
  for (int e = 0; e < mesh.num_elems(); ++e) {
    for (int k = 0; k < 3; ++k) {
      const int other = topology.elem2neighbors[e][k];
      if (other < 0) continue;
      for (const double s : {0.0, 0.2, 0.7}) {
        const Vec2 here = evaluator.sample(e, spectral::tri_edge_point(k, s)).value;
        const Vec2 there =
            evaluator.sample(other, spectral::tri_edge_point(topology.elem2neighbor_edges[e][k], 1 - s)).value;
        jump = std::max(jump, distance(here, there));
      }
    }
  }
  EXPECT_LT(jump, 1e-11);
  EXPECT_GT(error_of_power(field, 9), 1e-3);
}

TEST(SolveLaplace, CrossesOfADiscAreZToTheFourth) {
  // Data (cos 4 theta, sin 4 theta) of the tangent: v = (Re z^4, Im z^4) (lib/method.md §5).
  const TriMesh mesh = disc_mesh(12, 10);
  Report report;
  const Field field = solve_laplace(mesh, std::vector<int>(mesh.num_elems(), 12), report);
  EXPECT_TRUE(field.liftings.empty());
  EXPECT_LT(error_of_power(field, 4), 2e-11);
}

TEST(SolveLaplace, CurvedElementsConvergeSpectrally) {
  const TriMesh mesh = disc_mesh(12, 10);
  double last = 1;
  for (const int order : {4, 6, 8, 10}) {
    const double error = error_of_power(solve_power(mesh, std::vector<int>(mesh.num_elems(), order), 6), 6);
    EXPECT_LT(error, 0.1 * last) << order;
    last = error;
  }
}

TEST(Hybridised, CurvedElementsReachTheAccuracyOfTheirGeometry) {
  const TriMesh mesh = disc_mesh(12, 10);
  double last = 1;
  for (const int order : {4, 6, 8, 10}) {
    const std::vector<int> orders(mesh.num_elems(), order);
    const double error = error_of_power(solve_power(mesh, orders, 6, FieldMethod::dg), 6);
    EXPECT_LT(error, 0.1 * last) << order;
    last = error;
  }
  EXPECT_LT(error_of_power(solve_power(mesh, scattered_orders(mesh.num_elems(), 10, 2), 4, FieldMethod::dg), 4), 1e-9);
}

TEST(SolveLaplace, ASolverReusedGivesTheSameBits) {
  const TriMesh mesh = parallelogram_mesh({-1, -1}, {2, 0.3}, {0.2, 2}, 3);
  const std::vector<int> first(mesh.num_elems(), 4), second = scattered_orders(mesh.num_elems(), 3, 4);
  Report report;
  LaplaceSolver solver(mesh);
  solver.solve(first, report);
  const Field reused = solver.solve(second, report), fresh = solve_laplace(mesh, second, report);
  EXPECT_EQ(reused.u, fresh.u);
  EXPECT_EQ(reused.v, fresh.v);
}

TEST(SolveLaplace, WarnsOfALineField) {
  // Sides at 0 and 45 degrees: v is a multiple of (1, 0) everywhere, and vanishes on curves.
  const TriMesh mesh = parallelogram_mesh({0, 0}, {1, 0}, {1, 1}, 2);
  Report report;
  const Field field = solve_laplace(mesh, std::vector<int>(mesh.num_elems(), 4), report);
  ASSERT_EQ(report.warnings().size(), 1);
  EXPECT_EQ(report.warnings()[0].code, "W-SOLVE-001");
  for (const double v : field.v) EXPECT_NEAR(v, 0, 1e-13);
}

TEST(SolveLaplace, ATurnedDomainGivesTheTurnedField) {
  const Vec2 p{-0.4, -0.3}, a{1.9, 0.2}, b{-0.3, 0.8};
  const double turn = 0.7;
  const auto turned = [&](Vec2 x) { return std::cos(turn) * x + std::sin(turn) * left_of(x); };
  const TriMesh mesh = parallelogram_mesh(p, a, b, 4);
  const TriMesh turned_mesh = parallelogram_mesh(turned(p), turned(a), turned(b), 4);
  const std::vector<int> orders = scattered_orders(mesh.num_elems(), 3, 5);
  Report report;
  const Field field = solve_laplace(mesh, orders, report), turned_field = solve_laplace(turned_mesh, orders, report);
  const field::FieldEvaluator here(field), there(turned_field);
  for (int e = 0; e < mesh.num_elems(); ++e) {
    const Vec2 value = here.sample(e, {-0.3, -0.4}).value, other = there.sample(e, {-0.3, -0.4}).value;
    // A cross turned by an angle is a field value turned by four times the angle.
    EXPECT_LT(distance(std::cos(4 * turn) * value + std::sin(4 * turn) * left_of(value), other), 1e-12);
  }
}

TEST(SolveLaplace, NamesTheElementThatIsFolded) {
  TriMesh mesh = parallelogram_mesh({0, 0}, {1, 0}, {0.4, 1}, 3);
  mesh.vertices[5] = {0.9, 0.1};  // an inner vertex pushed across its neighbours
  mesh.face.origin = {100, 200};
  Report report;
  try {
    solve_laplace(mesh, std::vector<int>(mesh.num_elems(), 4), report);
    FAIL() << "no exception";
  } catch (const ComputeError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("element ")) << error.what();
    EXPECT_NE(std::string(error.what()).find("near (100."), std::string::npos) << error.what();
  }
}

TEST(SolveLaplace, OblongCrossesAreExactWithLiftings) {
  // A parallelogram's data are two constants; the lifted problem still meets them on every side.
  const TriMesh mesh = parallelogram_mesh({0, 0}, {2, 0}, {0.5, 1}, 6);
  Report report;
  const Field field = solve_laplace(mesh, std::vector<int>(mesh.num_elems(), 10), report);
  ASSERT_EQ(field.liftings.size(), 4u);
  const field::FieldEvaluator evaluator(field);
  for (const BoundaryEdge& b : mesh.boundary_edges) {
    const Vec2 data = cross_value(angle_of(curve::tangent(mesh.face.curves[b.curve], b.t0)));
    for (const double s : {0.1, 0.4, 0.8}) {
      EXPECT_LT(distance(evaluator.sample(b.elem, spectral::tri_edge_point(b.edge, s)).value, data), 1e-9);
    }
  }
}

}  // namespace
}  // namespace quadrille::galerkin
