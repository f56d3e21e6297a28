#include "refine/size_energy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "base/angle.hpp"
#include "refine/size_relaxer.hpp"
#include "refine/validity.hpp"

namespace quadrille::refine {
namespace {

QuadMesh mesh_of(const SeparatrixGraph& graph, double size, int order) {
  return refined(graph, {.size = size, .order = order, .geometry_tol = 1e-2, .relax = Relax::none});
}

std::vector<Vec2> equal_sizes(const QuadMesh& mesh, double size) {
  return std::vector<Vec2>(mesh.num_elems(), Vec2{size, size});
}

TEST(SizeEnergy, OfSquaresOfThePrescribedSizeIsTwoForEachWhateverTheUnit) {
  const QuadMesh mesh = mesh_of(hand_made::unit_square(), 0.25, 3);
  const RelaxProblem problem(mesh, {});
  SizeEnergy energy(problem, mesh);
  for (const double size : {0.25, 1.0}) {  // sizes count but for a common factor
    energy.set_sizes(equal_sizes(mesh, size));
    EXPECT_NEAR(energy.value(VertexMoves(problem.num_vertices())), 2 * 16, 1e-9);
  }
}

TEST(SizeEnergy, OfRectanglesOfThePrescribedLengthsIsTheSame) {
  QuadMesh mesh = mesh_of(hand_made::unit_square(), 0.25, 2);
  const RelaxProblem problem(mesh, {});
  SizeEnergy energy(problem, mesh);
  energy.set_sizes(std::vector<Vec2>(mesh.num_elems(), Vec2{0.25, 0.5}));
  // Squares in place of rectangles 1 : 2: a^2 = 2, b^2 = 1/2, J = 1, mu = 5/4.
  EXPECT_NEAR(energy.value(VertexMoves(problem.num_vertices())), 16 * ((16 + 1.0 / 16) / 2 + std::pow(1.25, 3)), 1e-9);
}

TEST(SizeEnergy, ElementsInSharpCornersAreLighter) {
  QuadMesh mesh = mesh_of(hand_made::unit_square(), 0.25, 2);
  const auto shear = [](Vec2& x) { x.x += 5 * x.y; };  // corners of atan(1 / 5), 11.3 degrees, and as many of 168.7
  std::ranges::for_each(mesh.nodes, shear);
  for (Nurbs& curve : mesh.face.curves) std::ranges::for_each(curve.poles, shear);
  measure_elements(mesh);
  const RelaxProblem problem(mesh, {});
  const SizeEnergy energy(problem, mesh);
  EXPECT_EQ(std::ranges::count(energy.shape_weights, 1.0), 14);
  const double sine = std::sin(std::atan(0.2));
  EXPECT_NEAR(std::ranges::min(energy.shape_weights), std::pow(sine / 0.5, 3), 1e-12);
  for (const double weight : energy.skew_weights) EXPECT_NEAR(weight, std::pow(sine / 0.5, 12), 1e-12) << "of all";
}

TEST(SizeEnergy, PartsOfTheResolutionRatioAreThoseOfTheMesh) {
  for (const SeparatrixGraph& graph : {hand_made::cut_annulus(3), hand_made::l_shape()}) {
    QuadMesh mesh = mesh_of(graph, 0.3, 4);
    const RelaxProblem problem(mesh, {});
    SizeEnergy energy(problem, mesh);
    energy.set_sizes(equal_sizes(mesh, 0.1));
    energy.positions(VertexMoves(problem.num_vertices()));
    std::vector<double> lengths;
    for (int elem = 0; elem < mesh.num_elems(); ++elem) lengths.push_back(mesh::resolution_length(mesh, elem));
    const mesh::Resolution of_mesh = mesh::resolution(mesh), here = mesh::resolution(mesh, {}, energy.powers(lengths));
    EXPECT_NEAR(here.ratio, of_mesh.ratio, 1e-2 * of_mesh.ratio);
    for (int elem = 0; elem < mesh.num_elems(); ++elem)
      EXPECT_NEAR(here.parts[elem][0], of_mesh.parts[elem][0], 2e-2 * of_mesh.parts[elem][0]);
  }
}

TEST(SizeEnergy, SizesAreShorterAlongBentSidesAndALittleAcross) {
  const QuadMesh mesh = mesh_of(hand_made::quarter_annulus(), 0.3, 3);
  const RelaxProblem problem(mesh, {});
  SizeEnergy energy(problem, mesh);
  energy.positions(VertexMoves(problem.num_vertices()));
  std::vector<bool> is_bent(mesh.num_elems(), false);
  for (const QuadBoundaryEdge& edge : mesh.boundary_edges) {
    if (mesh.face.curves[edge.curve].degree == 1) continue;
    is_bent[edge.elem] = true;
    const double radius = norm(mesh.nodes[side_start(mesh, edge.elem, edge.side)]);
    const double x = 0.3 / radius * 3 / (2 * pi);  // three elements of this size to a wave
    const Vec2 factors = energy.bend_factors(edge.elem, 0.3);
    const auto [along, across] = edge.side % 2 == 0 ? std::pair(factors.x, factors.y) : std::pair(factors.y, factors.x);
    EXPECT_NEAR(along, std::pow(1 + 36.0 / 5 * x * x + std::pow(x, 4), -1.0 / 8), 1e-3);
    EXPECT_NEAR(across, std::pow(1 + 6.0 / 5 * x * x + std::pow(x, 4) / 70, -1.0 / 8), 1e-3);
    EXPECT_LT(along, across);
  }
  EXPECT_GT(std::ranges::count(is_bent, true), 0);
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    EXPECT_EQ(energy.bend_factors(elem, 0.3) == (Vec2{1, 1}), !is_bent[elem]) << elem;
}

TEST(SizeEnergy, BentEdgesInsideDoNotShortenSizes) {
  const QuadMesh mesh =
      refined(hand_made::quarter_annulus(),
              {.size = 0.3, .order = 3, .geometry_tol = 1e-2, .inner_edges = InnerEdges::curved, .relax = Relax::none});
  const RelaxProblem problem(mesh, {});
  SizeEnergy energy(problem, mesh);
  energy.positions(VertexMoves(problem.num_vertices()));
  std::vector<bool> is_on_arc(mesh.num_elems(), false);
  for (const QuadBoundaryEdge& edge : mesh.boundary_edges)
    if (mesh.face.curves[edge.curve].degree > 1) is_on_arc[edge.elem] = true;
  EXPECT_GT(std::ranges::count(is_on_arc, false), 0);
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    EXPECT_EQ(energy.bend_factors(elem, 0.3) == (Vec2{1, 1}), !is_on_arc[elem]) << elem;
}

TEST(SizeEnergy, OfRelaxationHasSizesThatAreShorterAtBends) {
  const QuadMesh mesh = mesh_of(hand_made::quarter_annulus(), 0.3, 3);
  const RelaxProblem problem(mesh, {});
  const sizing::SizeField field(0.3);
  const SizeRelaxer relaxer(problem, mesh, {field});
  SizeEnergy energy(problem, mesh);
  const VertexMoves none(problem.num_vertices());
  energy.positions(none);
  std::vector<Vec2> sizes;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) sizes.push_back(0.3 * energy.bend_factors(elem, 0.3));
  energy.set_sizes(sizes);
  EXPECT_NEAR(relaxer.value, energy.value(none), 1e-9);
  energy.set_sizes(equal_sizes(mesh, 0.3));
  EXPECT_GT(std::abs(relaxer.value - energy.value(none)), 1e-2);
}

TEST(SizeEnergy, OfAFoldedMeshIsInfinite) {
  const QuadMesh mesh = mesh_of(hand_made::unit_square(), 0.5, 2);
  const RelaxProblem problem(mesh, {});
  SizeEnergy energy(problem, mesh);
  VertexMoves moves(problem.num_vertices());
  for (int v = 0; v < problem.num_vertices(); ++v)
    if (problem.follow.on_boundary(v) < 0) moves[v] = {0.7, 0};
  EXPECT_EQ(energy.value(moves), std::numeric_limits<double>::infinity());
}

TEST(SizeEnergy, InAMetricRectanglesOfItsLengthsAreSquares) {
  const QuadMesh mesh = mesh_of(hand_made::unit_square(), 0.25, 2);
  const RelaxProblem problem(mesh, {});
  SizeEnergy energy(problem, mesh);
  energy.stretches.assign(mesh.num_elems(), tensor_of({2, 0.5, half_pi}));  // of edges 4 : 1
  energy.set_sizes(equal_sizes(mesh, 0.25));
  // Squares are rectangles 1 : 4 there: a^2 = 1/4, b^2 = 4, J = 1, mu = 17/8.
  const double stretched = energy.value(VertexMoves(problem.num_vertices()));
  EXPECT_NEAR(stretched, 16 * ((std::pow(4, 4) + std::pow(4, -4)) / 2 + std::pow(17.0 / 8, 3)), 1e-9);
}

TEST(SizeEnergy, SidesThatFollowDirectionsAddNothingAndAt45DegreesFourTimesTheirWeight) {
  const QuadMesh mesh = mesh_of(hand_made::unit_square(), 0.25, 2);
  const RelaxProblem problem(mesh, {});
  SizeEnergy energy(problem, mesh);
  energy.set_sizes(equal_sizes(mesh, 0.25));
  for (const auto& [angle, more] : {std::pair(0.0, 0.0), {half_pi, 0.0}, {pi / 4, 4 * 3.0}, {pi / 8, 2 * 3.0}}) {
    energy.directions.assign(mesh.num_elems(), 3 * unit(4 * angle));
    EXPECT_NEAR(energy.value(VertexMoves(problem.num_vertices())), 16 * (2 + more), 1e-9);
  }
}

/// On a ring all kinds of vertices occur but fixed ones; on a rectangle some are fixed.
void expect_gradient_of_differences(bool is_stretched, double growth = 0) {
  for (const SeparatrixGraph& graph : {hand_made::cut_annulus(3), hand_made::quarter_annulus()})
    for (const int order : {1, 4}) {
      const QuadMesh mesh = mesh_of(graph, 0.4, order);
      const RelaxProblem problem(mesh, {});
      SizeEnergy energy(problem, mesh);
      for (int elem = 0; is_stretched && elem < mesh.num_elems(); ++elem) {
        energy.stretches.push_back(tensor_of({1.5, 1 / 1.5, 0.7 * elem}));
        energy.directions.push_back(2 * unit(1.3 * elem));
      }
      std::vector<Vec2> log_size_gradients;
      for (int elem = 0; growth > 0 && elem < mesh.num_elems(); ++elem)
        log_size_gradients.push_back(growth * unit(2.1 * elem));
      energy.set_sizes(equal_sizes(mesh, 0.4), log_size_gradients);
      VertexMoves moves(problem.num_vertices());
      for (int v = 0; v < problem.num_vertices(); ++v) {
        moves[v] = 0.02 * Vec2{std::sin(5.0 * v), std::cos(3.0 * v)};
        if (problem.is_fixed[v]) moves[v] = {};
        if (problem.follow.on_boundary(v) >= 0) moves[v].y = 0;
      }
      const EnergyDerivatives at = energy.with_derivatives(moves, true);
      EXPECT_NEAR(at.value, energy.value(moves), 1e-10);
      for (int v = 0; v < problem.num_vertices(); ++v)
        for (const Vec2 d : {Vec2{1, 0}, Vec2{0, 1}}) {
          const bool is_along = problem.follow.on_boundary(v) < 0 || d.x == 1;
          const double h = 1e-6;
          VertexMoves more = moves, less = moves;
          more[v] += h * d, less[v] += -h * d;
          const double slope = (energy.value(more) - energy.value(less)) / (2 * h);
          const double expected = problem.is_fixed[v] || !is_along ? 0 : slope;
          EXPECT_NEAR(dot(at.gradient[v], d), expected, 2e-6 * (1 + std::abs(slope))) << order << ", vertex " << v;
          EXPECT_GT(at.blocks[v][0] * at.blocks[v][2], at.blocks[v][1] * at.blocks[v][1]);
        }
    }
}

TEST(SizeEnergy, GradientIsThatOfDifferencesAlsoAlongCurves) { expect_gradient_of_differences(false); }

TEST(SizeEnergy, GradientIsThatOfDifferencesWithAMetricAndDirections) { expect_gradient_of_differences(true); }

TEST(SizeEnergy, GradientIsThatOfDifferencesWhereSizesGrow) {
  for (const bool is_stretched : {false, true}) expect_gradient_of_differences(is_stretched, 0.8);
}

}  // namespace
}  // namespace quadrille::refine
