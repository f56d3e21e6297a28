#include "galerkin/phase_energy.hpp"

#include <gtest/gtest.h>

#include <complex>

#include "../triangulate/faces.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::galerkin {
namespace {

using namespace testing_faces;
using Complex = std::complex<double>;

TriMesh fine_mesh(const CadFace& face) {
  Report report;
  triangulate::TriangulateOptions options;
  options.size = face.diameter / 10;
  return triangulate::triangulate(face, options, report);
}

// One mesh for many sets of nodes.
class Energy {
 public:
  explicit Energy(const TriMesh& mesh) : mesh_(mesh), solver_(mesh_, std::vector<int>(mesh.num_elems(), 12)) {}
  std::vector<Vec2> gradient(const PhaseNodes& asked) { return solver_.energy(asked).gradient; }
  double value(const PhaseNodes& asked) { return solver_.energy(asked).value; }

 private:
  TriMesh mesh_;
  PhaseSolver solver_;
};

double disc_energy(const std::vector<PhaseNode>& nodes) {
  double energy = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      const Complex a(nodes[i].position.x, nodes[i].position.y), b(nodes[j].position.x, nodes[j].position.y);
      if (i != j) energy -= pi * std::log(std::abs(a - b));
      energy -= pi * std::log(std::abs(1.0 - a * std::conj(b)));
    }
  }
  return energy;
}

TEST(PhaseEnergy, GradientOnTheDiscIsThatOfTheClosedForm) {
  const PhaseNodes asked{{{{0.5, 0.1}, 3}, {{-0.2, 0.45}, 3}, {{-0.55, -0.2}, 3}, {{0.1, -0.6}, 3}}, {}, {}};
  const std::vector<Vec2> gradient = Energy(fine_mesh(make_face({circle({0, 0}, 1)}))).gradient(asked);
  const double h = 1e-5;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto difference = [&](Vec2 d) {
      std::vector<PhaseNode> ahead = asked.nodes, behind = asked.nodes;
      ahead[k].position += d;
      behind[k].position -= d;
      return (disc_energy(ahead) - disc_energy(behind)) / (2 * h);
    };
    EXPECT_NEAR(gradient[k].x, difference({h, 0}), 1e-7);
    EXPECT_NEAR(gradient[k].y, difference({0, h}), 1e-7);
  }
}

TEST(PhaseEnergy, OfASquareOfNodesInTheDiscIsLeastAtItsKnownRadius) {
  Energy energy(fine_mesh(make_face({circle({0, 0}, 1)})));
  const double least = std::pow(3.0 / 11, 1.0 / 8);
  const auto outward = [&](double radius) {
    PhaseNodes asked;
    for (int k = 0; k < 4; ++k) asked.nodes.push_back({radius * unit(0.4 + half_pi * k), 3});
    const std::vector<Vec2> gradient = energy.gradient(asked);
    double sum = 0;
    for (int k = 0; k < 4; ++k) sum += dot(gradient[k], unit(0.4 + half_pi * k));
    return sum;
  };
  EXPECT_NEAR(outward(least), 0, 1e-8);
  EXPECT_LT(outward(least - 1e-4), -1e-2);
  EXPECT_GT(outward(least + 1e-4), 1e-2);
}

TEST(PhaseEnergy, OnTheDiscIsTheClosedForm) {
  Energy energy(fine_mesh(make_face({circle({0, 0}, 1)})));
  const std::vector<PhaseNode> nodes{{{0.5, 0.1}, 3}, {{-0.2, 0.45}, 3}, {{-0.55, -0.2}, 3}, {{0.1, -0.6}, 3}};
  const double constant = energy.value({nodes, {}, {}}) - disc_energy(nodes);
  for (const Vec2 x : {Vec2{0.7, 0.3}, {0.05, 0.02}, {0.1, -0.9}, {0.985, 0}}) {
    std::vector<PhaseNode> moved = nodes;
    moved[0].position = x;
    EXPECT_NEAR(energy.value({moved, {}, {}}), disc_energy(moved) + constant, 1e-8) << x.x;
  }
}

// Corners of all kinds, curved sides, a boundary node, a hole and its winding.
TEST(PhaseEnergy, GradientIsThatOfTheValue) {
  Energy energy(
      fine_mesh(make_face({{curve::segment({-2, -1}, {2, -0.8}), curve::circular_arc({2, 0.2}, 1, -half_pi, half_pi),
                            curve::segment({2, 1.2}, {-2, 1}),
                            curve::circular_arc({-2.75, 0}, 1.25, std::atan2(1, 0.75), -std::atan2(1, 0.75))},
                           polygon({{0.4, 0}, {0.6, 0.4}, {1, 0.1}})})));
  const PhaseNodes asked{{{{-0.5, -0.5}, 3}, {{0.9, 0.7}, 3}, {{1.9, -0.3}, 5}},
                         {{0, 0}, {1, 1}, {2, 2}, {3, 1}, {4, 3}, {5, 3}, {6, 4}},
                         {{2, 1.7, 3}}};
  const std::vector<Vec2> gradient = energy.gradient(asked);
  const double h = 1e-3;
  for (std::size_t k = 0; k < asked.nodes.size(); ++k) {
    const auto difference = [&](Vec2 d) {  // of order 4
      const auto at = [&](double steps) {
        PhaseNodes moved = asked;
        moved.nodes[k].position += steps * d;
        return energy.value(moved);
      };
      return (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h);
    };
    EXPECT_NEAR(gradient[k].x, difference({h, 0}), 1e-6) << k;
    EXPECT_NEAR(gradient[k].y, difference({0, h}), 1e-6) << k;
  }
}

// A gradient's own derivatives are symmetric: with corners of all kinds, a hole and its winding.
TEST(PhaseEnergy, GradientIsOneOfAFunctionWhereThereAreHolesAndCorners) {
  Energy energy(fine_mesh(
      make_face({polygon({{0, 0}, {4, 0.3}, {3.6, 3}, {0.4, 3.3}}), polygon({{2.4, 1.3}, {2.6, 2}, {3, 1.5}})})));
  const PhaseNodes asked{
      {{{1.1, 1.2}, 3}, {{1.3, 2.1}, 5}, {{2, 0.8}, 5}}, {{0, 1}, {1, 1}, {2, 2}, {3, 1}, {4, 3}, {5, 3}, {6, 2}}, {}};
  constexpr int size = 6;
  const double h = 1e-4;
  const auto entry = [](const std::vector<Vec2>& g, int i) { return i % 2 == 0 ? g[i / 2].x : g[i / 2].y; };
  double hessian[size][size];
  for (int i = 0; i < size; ++i) {
    PhaseNodes ahead = asked, behind = asked;
    (i % 2 == 0 ? ahead.nodes[i / 2].position.x : ahead.nodes[i / 2].position.y) += h;
    (i % 2 == 0 ? behind.nodes[i / 2].position.x : behind.nodes[i / 2].position.y) -= h;
    const std::vector<Vec2> a = energy.gradient(ahead), b = energy.gradient(behind);
    for (int j = 0; j < size; ++j) hessian[i][j] = (entry(a, j) - entry(b, j)) / (2 * h);
  }
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < i; ++j) EXPECT_NEAR(hessian[i][j], hessian[j][i], 1e-5) << i << ", " << j;
  }
  EXPECT_GT(std::abs(hessian[0][2]), 0.1);  // the nodes feel each other
}

}  // namespace
}  // namespace quadrille::galerkin
