// The phase form through the whole of its numerics: nodes away from the harmonic field's zeros, orders adapted.

#include <gtest/gtest.h>

#include <complex>
#include <fstream>
#include <sstream>

#include "../support/test_data.hpp"
#include "../triangulate/faces.hpp"
#include "adapt/adapt_loop.hpp"
#include "curve/chain.hpp"
#include "field/evaluate.hpp"
#include "galerkin/solve_phase.hpp"
#include "occ/read_face.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::adapt {
namespace {

using namespace testing_faces;
using Complex = std::complex<double>;

CadFace loaded(const std::string& shape) {
  std::ostringstream bytes;
  bytes << std::ifstream(test_data() + "/" + shape, std::ios::binary).rdbuf();
  Report report;
  return occ::read_face(occ::step_format(), bytes.str(), shape, {}, report).face;
}

Field adapted(const CadFace& face, const PhaseNodes& asked, Report& report) {
  const TriMesh mesh = triangulate::triangulate(face, {}, report);
  return adapt_loop(galerkin::solve_phase(mesh, std::vector<int>(mesh.num_elems(), 8), asked, report), {}, report);
}

// Corners have the valences nearest to their angles.
PhaseNodes with_corners(const CadFace& face, const std::vector<PhaseNode>& nodes) {
  PhaseNodes asked{nodes, {}, {}};
  for (int j = 0; j < face.num_curves(); ++j)
    if (face.joints[j].is_corner)
      asked.corners.push_back({j, static_cast<int>(std::lround(face.joints[j].interior_angle / half_pi))});
  return asked;
}

// Of the phase on the way from angle a to b about a point, modulo nothing.
double turning(const field::FieldEvaluator& field, Vec2 centre, double radius, double a, double b) {
  constexpr int steps = 400;
  double sum = 0, last = 0;
  for (int i = 0; i <= steps; ++i) {
    Vec2 value;
    EXPECT_TRUE(field.value_at(centre + radius * unit(a + (b - a) * i / steps), value));
    EXPECT_NEAR(norm(value), 1, 1e-14);
    if (i > 0) sum += wrap_pi(angle_of(value) - last);
    last = angle_of(value);
  }
  return sum;
}

// Greatest |phi - 4 theta_t| on the boundary, but for what the rounding of a point does beside a corner.
double misalignment(const field::FieldEvaluator& field) {
  const CadFace& face = field.field().mesh.face;
  double worst = 0;
  for (const BoundaryEdge& edge : field.field().mesh.boundary_edges) {
    const Nurbs& curve = face.curves[edge.curve];
    const curve::ArcLength length(curve);
    const double begin = length.at(edge.t0), end = length.at(edge.t1);
    for (const double f : {0.07, 0.33, 0.5, 0.8}) {
      const double t = length.parameter(begin + f * (end - begin));
      Vec2 x;
      Mat2 dx_dxi;
      const Vec2 value = field.value(edge.elem, spectral::tri_edge_point(edge.edge, f), x, dx_dxi);
      const double to_corner = std::min(distance(x, curve.poles.front()), distance(x, curve.poles.back()));
      if (to_corner < 1e-6 * face.diameter) continue;
      worst = std::max(worst, std::abs(wrap_pi(angle_of(value) - 4 * angle_of(curve::tangent(curve, t)))));
    }
  }
  return worst;
}

void expect_as_asked(const CadFace& face, const PhaseNodes& asked, double tol) {
  Report report;
  const Field field = adapted(face, asked, report);
  EXPECT_TRUE(report.warnings().empty()) << report.warnings()[0].message;
  const field::FieldEvaluator evaluator(field);
  for (const PhaseNode& node : asked.nodes)
    EXPECT_NEAR(turning(evaluator, node.position, 1e-4 * face.diameter, 0, 2 * pi), 2 * pi * (4 - node.valence), 1e-9);
  for (const CornerValence& corner : asked.corners) {
    const Joint& joint = face.joints[corner.joint];
    const double slack = 1e-4, from = joint.tangent_out + slack, to = from + joint.interior_angle - 2 * slack;
    const double turn = turning(evaluator, joint.position, 1e-5 * face.diameter, from, to);
    EXPECT_NEAR((4 * joint.interior_angle - turn) / (2 * pi), corner.valence, 0.01) << "joint " << corner.joint;
  }
  EXPECT_LT(misalignment(evaluator), tol);
}

TEST(AdaptPhase, OnTheDiscReachesTheClosedForm) {
  const std::vector<PhaseNode> nodes{{{0.5, 0.1}, 3}, {{-0.2, 0.45}, 3}, {{-0.55, -0.2}, 3}, {{0.1, -0.6}, 3}};
  Report report;
  const Field field = adapted(make_face({circle({0, 0}, 1)}), {nodes, {}, {}}, report);
  EXPECT_TRUE(report.warnings().empty());
  EXPECT_GT(field.adapt_steps.size(), 1u);
  const field::FieldEvaluator evaluator(field);
  double worst = 0;
  for (int e = 0; e < field.mesh.num_elems(); ++e) {
    for (const Vec2 xi : {Vec2{-0.3, -0.3}, {-0.9, -0.8}, {0.7, -0.9}, {-0.95, 0.9}}) {
      Vec2 x;
      Mat2 dx_dxi;
      const Vec2 value = evaluator.value(e, xi, x, dx_dxi);
      Complex product = 1;
      for (const PhaseNode& node : nodes) {
        const Complex a(node.position.x, node.position.y), z(x.x, x.y);
        product *= (z - a) * (1.0 - std::conj(a) * z);
      }
      worst = std::max(worst, std::abs(Complex(value.x, value.y) - product / std::abs(product)));
    }
  }
  EXPECT_LT(worst, 1e-8);
  EXPECT_LT(worst, *std::max_element(field.elem_error.begin(), field.elem_error.end()));
}

TEST(AdaptPhase, OnAPlateWithAHoleFollowsMovedNodes) {
  const CadFace face = loaded("plate_hole.step");
  const double step = 0.05 * face.diameter;
  expect_as_asked(face,
                  with_corners(face, {{Vec2{1.4309, 2.0717} + step * unit(2.0), 5},
                                      {Vec2{1.4418, 0.7363} + step * unit(4.0), 5},
                                      {Vec2{2.7603, 0.7338} + step * unit(-0.6), 5},
                                      {Vec2{2.7724, 2.0754} + step * unit(0.8), 5}}),
                  1e-8);
}

TEST(AdaptPhase, OnGeometry1FollowsMovedNodes) {
  const CadFace face = loaded("geometry_1.step");
  const double step = 0.05 * face.diameter;
  expect_as_asked(
      face,
      with_corners(face, {{Vec2{-1.0082, 4.268} + step * unit(-1.0), 3}, {Vec2{1.0082, 4.268} + step * unit(-2.5), 3}}),
      1e-8);
}

TEST(AdaptPhase, OnAChamferedPlateHasTheCornerValencesChosen) {
  const CadFace face = make_face({polygon({{0.6, 0}, {3.6, 0}, {4, 0.4}, {4, 3}, {0, 3}, {0, 0.6}})});
  // Three quads, and all four obtuse corners flat with two nodes inside.
  expect_as_asked(face, {{}, {{0, 1}, {1, 1}, {2, 2}, {3, 1}, {4, 1}, {5, 2}}, {}}, 1e-8);
  expect_as_asked(face, {{{{1, 1}, 3}, {{3.2, 0.9}, 3}}, {{0, 2}, {1, 2}, {2, 2}, {3, 1}, {4, 1}, {5, 2}}, {}}, 1e-8);
}

// 1e-7: the nose has a fan of small elements, which adapting weighs by their size.
TEST(AdaptPhase, RoundAThinAerofoilIsAsExact) {
  const CadFace face = loaded("geometry_5.step");
  expect_as_asked(face, with_corners(face, {{{-0.015196, 0.014972}, 5}, {{-0.015196, -0.014972}, 5}}), 1e-7);
  const double step = 0.05 * face.diameter;
  expect_as_asked(
      face,
      with_corners(face, {{Vec2{-0.015, 0.015} + step * unit(2.0), 5}, {Vec2{-0.015, -0.015} + step * unit(-2.2), 5}}),
      1e-7);
}

TEST(AdaptPhase, RoundAThinEllipseIsAsExact) {
  Loop ellipse = hole({0, 0}, 1);
  for (Vec2& pole : ellipse[0].poles) pole = {1.5 * pole.x, 0.1 * pole.y};
  const CadFace face = make_face({polygon({{-3, -2}, {3, -2}, {3, 2}, {-3, 2}}), ellipse});
  expect_as_asked(face, with_corners(face, {{{1.8, 0.2}, 5}, {{-1.7, 0.15}, 5}, {{-1.4, -0.4}, 5}, {{0.5, -0.3}, 5}}),
                  1e-8);
}

TEST(AdaptPhase, GoesOnWhereItEnded) {
  Report report;
  const Field field = adapted(half_disc(), {{{{0.4, 0.45}, 3}, {{-0.5, 0.5}, 3}}, {{0, 1}, {1, 1}}, {}}, report);
  const Field again = adapt_loop(field, {}, report);
  EXPECT_EQ(again.phase.s, field.phase.s);
  EXPECT_EQ(again.adapt_steps.size(), field.adapt_steps.size());
}

}  // namespace
}  // namespace quadrille::adapt
