#include "galerkin/explicit_energy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <functional>

#include "../triangulate/faces.hpp"
#include "field/phase_boundary.hpp"

namespace quadrille::galerkin {
namespace {

using namespace testing_faces;
using Complex = std::complex<double>;

double energy_of(const CadFace& face, const PhaseNodes& asked) {
  const field::PhaseBoundary boundary(face, asked);
  return explicit_energy(face, asked, boundary.terms(), boundary.interior_angles());
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

/// L of explicit_energy.hpp and its turning from the begin of a side, from the terms.
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

/// The formula of explicit_energy.hpp on straight sides, where dPhi = 0, between these points.
double polygon_energy(const std::vector<Vec2>& points, const PhaseTerms& terms,
                      const std::vector<double>& interior_angles) {
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
  for (int c = 0; c < num_corners; ++c)
    energy -= terms.corner_angles[c].beta * interior_angles[c] / 2 * l.value(terms.corner_angles[c].apex, 2 * c);
  for (int k = 0; k < static_cast<int>(terms.nodes.size()); ++k)
    energy -= pi * terms.nodes[k].turns * l.value(terms.nodes[k].position, 2 * num_corners + k);
  return energy;
}

double error_on_polygon(const CadFace& face, const PhaseNodes& asked, const std::vector<Vec2>& points) {
  const field::PhaseBoundary boundary(face, asked);
  EXPECT_FALSE(boundary.terms().corner_angles.empty());
  return energy_of(face, asked) - polygon_energy(points, boundary.terms(), boundary.interior_angles());
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

}  // namespace
}  // namespace quadrille::galerkin
