#include "galerkin/phase_energy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <functional>

#include "../test_meshes.hpp"
#include "../triangulate/faces.hpp"
#include "base/error.hpp"
#include "field/explicit_value.hpp"
#include "field/phase_boundary.hpp"
#include "galerkin/solve_phase.hpp"
#include "mesh/tri_topology.hpp"
#include "spectral/orthogonal_basis.hpp"
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

void expect_gradient_of_value(Energy& energy, const PhaseNodes& asked) {
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
  expect_gradient_of_value(energy, asked);
}

// The turns about the slit are centred in its bend, where the data jump.
TEST(PhaseEnergy, GradientIsThatOfTheValueBesideAnAcuteSlit) {
  Energy energy(fine_mesh(bent_slit(radians(150.0))));
  expect_gradient_of_value(energy,
                           {{{{0.7, 0.3}, 3}}, {{0, 1}, {1, 1}, {2, 1}, {3, 1}, {4, 4}, {5, 1}, {6, 4}, {7, 4}}, {}});
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

double energy_of(const CadFace& face, const PhaseNodes& asked) {
  const field::PhaseBoundary boundary(face, asked);
  return explicit_energy(face, asked, boundary.terms(), boundary.apex_turns());
}

/// With the images of all nodes at 1 / conj a, s is constant in the unit disc, so that the explicit part is the whole
/// energy: -pi sum d_i d_j ln |a_i - a_j| - pi sum d_i d_j ln |1 - a_i conj a_j|.
double disc_energy(const std::vector<PhaseTurn>& nodes) {
  double energy = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      const Complex a(nodes[i].position.x, nodes[i].position.y), b(nodes[j].position.x, nodes[j].position.y);
      const double product = nodes[i].turns * nodes[j].turns;
      if (i != j) energy -= pi * product * std::log(std::abs(a - b));
      energy -= pi * product * std::log(std::abs(1.0 - a * std::conj(b)));
    }
  return energy;
}

PhaseTerms with_images(const std::vector<PhaseTurn>& nodes) {
  PhaseTerms terms;
  terms.nodes = nodes;
  for (const PhaseTurn& node : nodes) terms.images.push_back({node.position / norm2(node.position), node.turns});
  return terms;
}

TEST(ExplicitEnergy, InTheDiscIsTheClosedForm) {
  const CadFace disc = make_face({circle({0, 0}, 1)});
  for (const Vec2 x : {Vec2{0.5, 0.1}, {0.02, 0.01}, {0.95, 0}, {0.6, -0.799}}) {
    const std::vector<PhaseTurn> nodes{{x, 1}, {{-0.2, 0.45}, 1}, {{-0.55, -0.2}, 1}, {{0.1, -0.6}, 1}};
    EXPECT_NEAR(explicit_energy(disc, {}, with_images(nodes), {}), disc_energy(nodes), 1e-9) << x.x;
  }
  const std::vector<PhaseTurn> opposites{{{0.3, 0}, 2}, {{-0.4, 0.2}, 2}, {{0.1, 0.5}, -1}, {{0, -0.5}, 1}};
  EXPECT_NEAR(explicit_energy(disc, {}, with_images(opposites), {}), disc_energy(opposites), 1e-9);
}

/// An equilateral triangle with a node of valence 3 in it: beta = 4 - 2 pi / (pi / 3) = -2 at each corner.
CadFace triangle() { return make_face({polygon({{0, 0}, {1, 0}, {0.5, std::sqrt(0.75)}})}); }
PhaseNodes one_node(Vec2 x) { return {{{x, 3}}, {{0, 1}, {1, 1}, {2, 1}}, {}}; }

/// L of phase_energy.hpp and its turning from the begin of a side, from the terms.
struct LogSum {
  std::vector<Vec2> at;
  std::vector<double> weight;

  explicit LogSum(const PhaseTerms& terms) {
    const auto add = [&](Vec2 x, double w) { at.push_back(x), weight.push_back(w); };
    for (const CornerAngle& c : terms.corner_angles) add(c.apex, c.beta), add(c.pole, -c.beta);
    for (const auto* turns : {&terms.nodes, &terms.holes, &terms.images})
      for (const PhaseTurn& turn : *turns) add(turn.position, turn.turns);
  }
  double value(Vec2 x, int omitted = -1) const {
    double sum = 0;
    for (int i = 0; i < static_cast<int>(at.size()); ++i)
      if (i != omitted) sum += weight[i] * std::log(std::max(distance(at[i], x), 1e-300));
    return sum;
  }
  /// dA / ds along a unit direction.
  double turning(Vec2 x, Vec2 along) const {
    double sum = 0;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const Vec2 r = x - at[i];
      if (std::abs(cross(r, along)) > 1e-12) sum += weight[i] * cross(r, along) / norm2(r);
    }
    return sum;
  }
};

/// int_0^1 f by the double exponential rule, which logarithms at the ends do not disturb.
double integral(const std::function<double(double)>& f) {
  const double step = 1.0 / 128;
  double sum = 0;
  for (int k = -420; k <= 420; ++k) {
    const double u = half_pi * std::sinh(k * step), cosine = std::cosh(u);
    sum += step * half_pi * std::cosh(k * step) / (2 * cosine * cosine) * f(1 / (1 + std::exp(-2 * u)));
  }
  return sum;
}

/// The formula of phase_energy.hpp on straight sides, where dPhi = 0, between these points.
double polygon_energy(const std::vector<Vec2>& points, const PhaseTerms& terms,
                      const std::vector<field::ApexTurn>& apex_turns) {
  const LogSum l(terms);
  double energy = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 from = points[i], to = points[(i + 1) % points.size()], along = normalized(to - from);
    const double length = distance(from, to);
    energy -= length * integral([&](double t) {
                const Vec2 x = from + t * length * along;
                return l.value(x) * l.turning(x, along) / 2;
              });
  }
  const int num_corners = static_cast<int>(terms.corner_angles.size());
  for (int c = 0; c < num_corners; ++c) energy += apex_turns[c].turn * l.value(terms.corner_angles[c].apex, 2 * c);
  for (int k = 0; k < static_cast<int>(terms.nodes.size()); ++k)
    energy -= pi * terms.nodes[k].turns * l.value(terms.nodes[k].position, 2 * num_corners + k);
  return energy;
}

double error_on_polygon(const CadFace& face, const PhaseNodes& asked, const std::vector<Vec2>& points) {
  const field::PhaseBoundary boundary(face, asked);
  EXPECT_FALSE(boundary.terms().corner_angles.empty());
  return energy_of(face, asked) - polygon_energy(points, boundary.terms(), boundary.apex_turns());
}

TEST(ExplicitEnergy, OnATriangleIsTheIntegralOfItsFormula) {
  const std::vector<Vec2> points{{0, 0}, {1, 0}, {0.5, std::sqrt(0.75)}};
  for (const Vec2 x : {Vec2{0.5, 0.25}, {0.2, 0.1}, {0.5, 0.02}})
    EXPECT_NEAR(error_on_polygon(triangle(), one_node(x), points), 0, 1e-7) << x.y;
}

TEST(ExplicitEnergy, AlsoWithANodeOnASide) {
  // A rectangle, whose corners have no angle terms; a node of valence 3 on its floor has beta = 4 - 2 * 3.
  const CadFace face = make_face({polygon({{0, 0}, {3, 0}, {3, 1}, {0, 1}})});
  const PhaseNodes asked{{{{1, 0.4}, 3}}, {{0, 1}, {1, 1}, {2, 1}, {3, 1}}, {{0, 1.7, 3}}};
  EXPECT_NEAR(error_on_polygon(face, asked, {{0, 0}, {1.7, 0}, {3, 0}, {3, 1}, {0, 1}}), 0, 1e-7);
}

TEST(ExplicitEnergy, GrowsWithTheSizeOfTheFaceAsItsDiscsDo) {
  // The energy outside discs of radius r does not change with the face's size; W subtracts from it pi d^2 ln(1 / r) for
  // each node and omega beta^2 / 2 ln(1 / r) for each corner.
  const double scale = 2.5;
  const CadFace disc = make_face({circle({0, 0}, 1)}), corners = triangle();
  const PhaseNodes nodes{{{{0.3, 0}, 2}, {{-0.4, 0.2}, 3}, {{0.1, -0.5}, 3}}, {}, {}};
  const auto growth = [&](const CadFace& face, PhaseNodes asked) {
    const double before = energy_of(face, asked);
    for (PhaseNode& node : asked.nodes) node.position = scale * node.position;
    return energy_of(moved(face, scale, 0, {}), asked) - before;
  };
  EXPECT_NEAR(growth(disc, nodes), pi * (4 + 1 + 1) * std::log(scale), 1e-9);
  EXPECT_NEAR(growth(corners, one_node({0.5, 0.3})), (pi + 3 * pi / 3 * 4 / 2) * std::log(scale), 1e-7);
}

TEST(ExplicitEnergy, DoesNotDependOnWhereTheFaceLiesOrItsCurveBegins) {
  const PhaseNodes asked{{{{0.5, 0.1}, 3}, {{-0.2, 0.45}, 3}, {{-0.55, -0.2}, 3}, {{0.1, -0.6}, 3}}, {}, {}};
  const auto turned_seam = [](double angle) {
    return make_face({{curve::circular_arc({0, 0}, 1, angle, angle + 2 * pi)}});
  };
  EXPECT_NEAR(energy_of(turned_seam(0), asked), energy_of(turned_seam(1.3), asked), 1e-9);
  PhaseNodes shifted = one_node({0.4, 0.3});
  const double here = energy_of(triangle(), shifted);
  for (PhaseNode& node : shifted.nodes) node.position = left_of(node.position) + Vec2{3, 1};
  EXPECT_NEAR(energy_of(moved(triangle(), 1, half_pi, {3, 1}), shifted), here, 1e-8);
}

// W of two nodes in the whole plane is -2 pi d_1 d_2 ln |a_1 - a_2|: nodes of one sign repel each other.
TEST(PhaseGradient, OfTwoNodesIsAlongTheLineBetweenThem) {
  PhaseTerms terms;
  terms.nodes = {{{1, 0}, 1}, {{-1, 0}, 1}};
  EXPECT_NEAR(distance(phase_energy_gradient(terms, 0, {}), {-pi, 0}), 0, 1e-14);
  EXPECT_NEAR(distance(phase_energy_gradient(terms, 1, {}), {pi, 0}), 0, 1e-14);
  terms.nodes[1].turns = -1;
  EXPECT_NEAR(distance(phase_energy_gradient(terms, 0, {}), {pi, 0}), 0, 1e-14);
}

TEST(PhaseGradient, AddsTheRemainderTurnedByAQuarterTurn) {
  PhaseTerms terms;
  terms.nodes = {{{1, 0}, -2}};
  EXPECT_NEAR(distance(phase_energy_gradient(terms, 0, {3, 4}), 4 * pi * Vec2{4, -3}), 0, 1e-13);
}

TEST(PhaseGradient, OfTheRemainderIsInThePlane) {
  const spectral::TriMap map({Vec2{0.1, -0.2}, Vec2{1.3, 0.1}, Vec2{0.4, 0.9}});
  const std::vector<double> coefs{0.3, -1, 0.7, 0.2, 0.5, -0.4};
  const Vec2 xi{-0.3, -0.5};
  const auto at = [&](Vec2 p) { return spectral::orthogonal_sum(2, coefs.data(), coefs.data(), p).x; };
  const Vec2 slope = field::remainder_sample(map, 2, coefs.data(), xi).slope;
  const double h = 1e-5;
  for (const Vec2 step : {Vec2{h, 0}, Vec2{0, h}}) {
    const Vec2 dx = map.position(xi + step) - map.position(xi - step);
    EXPECT_NEAR(dot(slope, dx), at(xi + step) - at(xi - step), 1e-9 * h);
  }
}

TEST(PhaseGradient, NodesMustLieInTheMesh) {
  TriMesh mesh = parallelogram_mesh({0, 0}, {2, 0}, {0, 1}, 2);
  mesh.face.origin = {10, 0};
  const std::vector<spectral::TriMap> maps = mesh::tri_maps(mesh);
  const mesh::Locator locator(mesh, maps);
  const mesh::Location at = locate_node(locator, mesh, {0.3, 0.4});
  EXPECT_NEAR(distance(maps[at.elem].position(at.xi), {0.3, 0.4}), 0, 1e-14);
  try {
    locate_node(locator, mesh, {3, 0.5});
    FAIL();
  } catch (const ComputeError& error) {
    EXPECT_EQ(std::string(error.what()), "the irregular node at (13, 0.5) is outside the mesh");
  }
}

}  // namespace
}  // namespace quadrille::galerkin
