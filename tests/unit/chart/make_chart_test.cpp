#include "chart/make_chart.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <string>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "chart/surface_mesh.hpp"
#include "check/check.hpp"
#include "curve/nurbs.hpp"
#include "mesh/chart_map.hpp"
#include "space_faces.hpp"

namespace quadrille {
namespace {

using Complex = std::complex<double>;
using tests::face_of;
using tests::line;
using tests::profile_arc;
using tests::revolved;

const double cap_latitude = std::acos(0.8);  // its rim has radius 0.8

SpaceFace cylinder_patch() { return face_of(revolved(line({2, 0, 0}, {2, 0, 3}), 0, 2), {{0, 1, 2, 3}}, 12, 5); }
SpaceFace cap() { return face_of(revolved(profile_arc(0, 1, cap_latitude, pi / 2), 0, 2 * pi), {{0}}, 24, 8); }
SpaceFace half_cap() { return face_of(revolved(profile_arc(0, 1, cap_latitude, pi / 2), 0, pi), {{0, 1, 3}}, 12, 8); }
SpaceFace torus_patch() { return face_of(revolved(profile_arc(3, 1, -1, 1), 0, 1), {{0, 1, 2, 3}}, 12, 8); }

CadFace chart_of(const SpaceFace& face, double closedness = 1e-6) {
  Report report;
  chart::ChartOptions options;
  options.closedness = closedness;
  CadFace charted = chart::make_chart(face, options, report);
  EXPECT_LE(charted.chart->closedness, closedness);
  for (const check::Violation& fault : check::check_stage(charted, check::CheckDepth::full))
    ADD_FAILURE() << fault.rule << ": " << fault.text;
  return charted;
}

Complex stereographic(Vec3 x) { return Complex(x.x, x.y) / (1 + x.z); }

/// Greatest distance of the nodes of the chart from exact(x), the best motion removed.
double misfit(const Chart& chart, const std::function<Complex(Vec3)>& exact) {
  const std::size_t n = chart.nodes.size();
  std::vector<Complex> z, w;
  Complex z_mean, w_mean, turn;
  for (std::size_t i = 0; i < n; ++i) {
    z.emplace_back(chart.nodes[i].x, chart.nodes[i].y), w.push_back(exact(chart.space_nodes[i]));
    z_mean += z[i], w_mean += w[i];
  }
  z_mean /= static_cast<double>(n), w_mean /= static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) turn += (w[i] - w_mean) * std::conj(z[i] - z_mean);
  turn /= std::abs(turn);
  double most = 0;
  for (std::size_t i = 0; i < n; ++i) most = std::max(most, std::abs((z[i] - z_mean) * turn - (w[i] - w_mean)));
  return most;
}

TEST(MakeChart, DevelopableFacesAreUnrolled) {
  const CadFace cylinder = chart_of(cylinder_patch(), 1e-9);
  EXPECT_LT(misfit(*cylinder.chart, [](Vec3 x) { return Complex(2 * std::atan2(x.y, x.x), x.z); }), 1e-9);
  const CadFace cone = chart_of(face_of(revolved(line({1, 0, 1}, {3, 0, 3}), 0, 3), {{0, 1, 2, 3}}, 16, 5), 1e-9);
  const auto unrolled = [](Vec3 x) { return std::polar(norm(x), -std::atan2(x.y, x.x) / std::sqrt(2)); };
  EXPECT_LT(misfit(*cone.chart, unrolled), 1e-9);
  for (const double scale : cone.chart->log_scale) EXPECT_NEAR(scale, 0, 1e-9);
}

TEST(MakeChart, ATipHasTheAngleOfTheUnrolledCone) {
  const double angle = 2.5;
  const CadFace cone = chart_of(tests::cone_with_apex(angle));
  const auto unrolled = [](Vec3 x) { return std::polar(norm(x), -std::atan2(x.y, x.x) / std::sqrt(2)); };
  EXPECT_LT(misfit(*cone.chart, unrolled), 1e-6);
  const auto tip = std::ranges::find_if(
      cone.joints, [](const Joint& joint) { return std::abs(joint.interior_angle - half_pi) > 0.1; });
  ASSERT_NE(tip, cone.joints.end());
  EXPECT_NEAR(tip->interior_angle, angle / std::sqrt(2), 1e-6);
  // lambda is 0; its error in the tiny triangles at the tip must not look like a gradient.
  EXPECT_LT(mesh::ChartMap(cone).greatest_gradient(), 100);
}

// The fourth triangle of a row of them has no size, which makes all numbers of the chart useless.
TEST(MakeChart, TheMostFoldedElementIsFound) {
  chart::SurfaceMesh mesh;
  mesh.order = 1;
  for (int e = 0; e < 5; ++e) {
    const double x = e, height = e == 3 ? 0 : e == 2 ? -1 : 1;
    mesh.plane.elem2vertices.push_back({3 * e, 3 * e + 1, 3 * e + 2});
    for (const Vec3 node : {Vec3{x, 0, 0}, Vec3{x + 1, 0, 0}, Vec3{x, height, 0}}) mesh.nodes.push_back(node);
    for (int k = 0; k < 3; ++k) mesh.normals.push_back({0, 0, 1});
  }
  const std::vector<double> ratios = chart::least_area_ratios(mesh);
  ASSERT_EQ(ratios.size(), 5U);
  for (const int e : {0, 1, 4}) EXPECT_NEAR(ratios[e], 1, 1e-14);
  EXPECT_NEAR(ratios[2], -1, 1e-14);
  EXPECT_EQ(ratios[3], -std::numeric_limits<double>::infinity());
}

// Those at a tip of nearly 180 degrees (4.4 on the cone) turned over where they were smaller.
TEST(MakeChart, TrianglesAtATipAreNotShorterThanTheGoal) {
  for (const double angle : {1.0, 2.5, 4.2, 4.4}) {
    const CadFace cone = chart_of(tests::cone_with_apex(angle));
    double least = cone.diameter;
    const Chart& chart = *cone.chart;
    for (int elem = 0; elem < chart.num_elems(); ++elem) {
      const Vec2* corner = &chart.nodes[static_cast<std::size_t>(elem) * chart.nodes_per_elem()];
      for (int k = 0; k < 3; ++k) least = std::min(least, distance(corner[k], corner[(k + 1) % 3]));
    }
    EXPECT_GT(least, 0.3e-6 * cone.diameter);
    EXPECT_LT(chart.closedness, 1e-7);
    for (const double scale : chart.log_scale) EXPECT_NEAR(scale, 0, 0.1);
  }
}

// The face turns over at a cusp, z^2 = x^3, however small its elements are.
TEST(MakeChart, RefusesASurfaceThatTurnsOver) {
  NurbsSurface cusp{3, 1, {-1, -1, -1, -1, 1, 1, 1, 1}, {0, 0, 1, 1}, {}, {}};
  for (const Vec2 p : {Vec2{1, -1}, Vec2{-1.0 / 3, 1}, Vec2{-1.0 / 3, -1}, Vec2{1, 1}})
    for (const double y : {0.0, 1.0}) cusp.poles.push_back({p.x, y, p.y}), cusp.weights.push_back(1);
  Report report;
  try {
    chart::make_chart(face_of(cusp, {{0, 1, 2, 3}}, 20, 8), {}, report);
    ADD_FAILURE() << "has a chart";
  } catch (const ComputeError& e) {
    EXPECT_NE(std::string(e.what()).find("turn over near"), std::string::npos) << e.what();
  }
}

TEST(MakeChart, CapsAreStereographicWithThePoleInside) {
  const CadFace cap_chart = chart_of(cap());
  EXPECT_LT(misfit(*cap_chart.chart, [](Vec3 x) { return 1.6 * stereographic(x); }), 1e-8);
  EXPECT_NEAR(cap_chart.diameter, 1.6, 1e-4);  // arc lengths on the outline are those of space
  // The half sphere: lambda = ln(2 / (1 + r^2)).
  const CadFace half = chart_of(face_of(revolved(profile_arc(0, 1, 0, pi / 2), 0, 2 * pi), {{0}}, 24, 12));
  EXPECT_LT(misfit(*half.chart, stereographic), 1e-8);
  for (std::size_t i = 0; i < half.chart->nodes.size(); ++i)
    EXPECT_NEAR(half.chart->log_scale[i], std::log(2 / (1 + std::norm(stereographic(half.chart->space_nodes[i])))),
                1e-6);
}

double length_of(const Nurbs& curve) {
  constexpr int num_chords = 10000;
  double length = 0;
  for (int i = 0; i < num_chords; ++i) {
    const auto at = [&](int k) {
      return curve::point(curve, curve.begin() + (curve.end() - curve.begin()) * k / num_chords);
    };
    length += distance(at(i), at(i + 1));
  }
  return length;
}

// The stereographic image of a circle is a circle: the chart of a half cap is its holomorphic image, with e^lambda.
TEST(MakeChart, HalfCapKeepsAnglesAndLengthsOfItsOutline) {
  const CadFace face = chart_of(half_cap());
  ASSERT_EQ(face.num_curves(), 3);
  EXPECT_NEAR(face.joints[0].interior_angle, pi / 2, 1e-12);
  EXPECT_NEAR(face.joints[1].interior_angle, pi / 2, 1e-12);
  EXPECT_NEAR(face.joints[2].interior_angle, pi, 1e-12);
  EXPECT_TRUE(face.joints[0].is_corner && face.joints[1].is_corner);
  EXPECT_FALSE(face.joints[2].is_corner);  // at the pole
  EXPECT_NEAR(length_of(face.curves[0]), 0.8 * pi, 1e-6);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(face.curves[i].poles.back(), face.curves[face.next_in_loop(i)].poles.front());
}

TEST(MakeChart, CurvesHaveTheParametersOfThoseInSpace) {
  const CadFace face = chart_of(cap());  // the rim is a circle of four rational arcs
  const SpaceCurve& rim = face.chart->space_curves[0];
  ASSERT_EQ(rim.begin(), face.curves[0].begin());
  ASSERT_EQ(rim.end(), face.curves[0].end());
  for (int k = 0; k <= 40; ++k) {
    const double t = rim.begin() + (rim.end() - rim.begin()) * k / 40;
    const Vec3 x = surface::point(rim, t);
    EXPECT_NEAR(std::hypot(x.x, x.y), 0.8, 1e-12);
    EXPECT_NEAR(x.z, 0.6, 1e-12);
    const Complex turned =
        Complex(curve::point(face.curves[0], t).x, curve::point(face.curves[0], t).y) / Complex(x.x, x.y);
    EXPECT_NEAR(std::abs(turned), 1, 1e-7);
  }
  EXPECT_TRUE(curve::smoothness_breaks(face.curves[0]).empty());
  EXPECT_TRUE(curve::has_smooth_seam(face.curves[0]));
}

TEST(MakeChart, TubesAreRings) {
  const CadFace tube = chart_of(face_of(revolved(line({1, 0, 0}, {1, 0, 1}), 0, 2 * pi), {{0}, {2}}, 36, 5));
  EXPECT_LT(misfit(*tube.chart, [](Vec3 x) { return std::polar(std::exp(-x.z), std::atan2(x.y, x.x)); }), 1e-7);
}

TEST(MakeChart, HolesAreNotFilled) {
  const SpaceFace zone = face_of(revolved(profile_arc(0, 1, cap_latitude, 1.2), 0, 2 * pi), {{0}, {2}}, 36, 5);
  EXPECT_LT(misfit(*chart_of(zone).chart, [](Vec3 x) { return 1.6 * stereographic(x); }), 1e-8);
  const CadFace face = chart_of(tests::cap_with_hole(1, 0.4, 0.3, 36, 8));  // beside the middle: its image closes
  EXPECT_LT(face.chart->closedness, 1e-7);
  EXPECT_EQ(face.num_loops(), 2);
}

// A bent strip, whose third derivatives jump at knots that are close together: its image is as fast as its edges.
TEST(MakeChart, KnotsMayBeCloseTogether) {
  NurbsSurface strip{3, 1, {0, 0, 0, 0, 0.5, 0.502, 0.51, 1, 1, 1, 1}, {0, 0, 1, 1}, {}, {}};
  for (std::size_t i = 0; i < 7; ++i)
    for (const double y : {0.0, 1.0}) {
      const double x = (strip.knots_u[i + 1] + strip.knots_u[i + 2] + strip.knots_u[i + 3]) / 3;
      strip.poles.push_back({3 * x, y, 0.3 * std::sin(5 * x)}), strip.weights.push_back(1);
    }
  const CadFace face = chart_of(face_of(strip, {{0, 1, 2, 3}}, 16, 5), 1e-4);
  for (const int curve : {0, 2})
    for (int k = 0; k <= 1000; ++k) {
      const double t = k / 1000.0, speed = norm(surface::derivatives(face.chart->space_curves[curve], t)[1]);
      EXPECT_NEAR(norm(curve::derivatives(face.curves[curve], t)[1]), speed, 1e-2 * speed) << curve << " at " << t;
    }
}

// Its rim has no smooth derivatives by the parameter, but at the seam: chart_of checks that its image fits the curve.
TEST(MakeChart, ClosedCurvesMayHaveJumpsOfCurvature) {
  const CadFace face = chart_of(tests::rim_of_quadratic_pieces(6, 8), 1e-4);
  const SpaceCurve& rim = face.chart->space_curves[0];
  for (int k = 0; k <= 1200; ++k) {
    const double t = k / 200.0, speed = norm(surface::derivatives(rim, t)[1]);
    EXPECT_NEAR(norm(curve::derivatives(face.curves[0], t)[1]), speed, 1e-3 * speed) << t;
  }
}

TEST(MakeChart, ChartOfASymmetricFaceIsSymmetric) {
  const CadFace face = chart_of(torus_patch(), 1e-9);
  // The longest curve, on the outer side or beside it, runs to the right: the mirror axis of z -> -z is an axis of the
  // chart.
  double most = 0;
  for (int side = 0; side < 4; ++side) {
    const Nurbs &a = face.curves[side], &b = face.curves[side == 1 ? 3 : side == 3 ? 1 : side];
    for (int k = 0; k <= 10; ++k) {
      const Vec2 x = curve::point(a, a.begin() + (a.end() - a.begin()) * k / 10),
                 y = curve::point(b, b.end() + (b.begin() - b.end()) * k / 10);
      most = std::max(most, std::min(distance(x, {-y.x, y.y}), distance(x, {y.x, -y.y})));
    }
  }
  EXPECT_LT(most, 1e-9);
}

TEST(MakeChart, PlaneFacesAreTheirOwnCharts) {
  const SpaceFace face = face_of(revolved(line({1, 0, 3}, {2, 0, 3}), 0, 1), {{0, 1, 2, 3}}, 12, 5);  // faces downwards
  const CadFace charted = chart_of(face);
  EXPECT_EQ(charted.chart->closedness, 0);
  EXPECT_EQ(charted.curves[0].degree, face.curves[0].degree);
  const auto from_below = [](Vec3 x) { return Complex(x.x, -x.y); };
  EXPECT_LT(misfit(*charted.chart, from_below), 1e-13);
}

TEST(MakeChart, IsTheSameEachTime) {
  const CadFace a = chart_of(half_cap()), b = chart_of(half_cap());
  EXPECT_EQ(a.chart->nodes, b.chart->nodes);
  EXPECT_EQ(a.curves[1].poles, b.curves[1].poles);
}

void expect_refusal(const SpaceFace& face, const std::string& text) {
  Report report;
  try {
    chart::make_chart(face, {}, report);
    ADD_FAILURE() << "no refusal: " << text;
  } catch (const ComputeError& error) {
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
  }
}

TEST(MakeChart, RefusesScalesThatDifferTooMuch) {
  expect_refusal(face_of(revolved(line({1, 0, 0}, {1, 0, 8}), 0, 2 * pi), {{0}, {2}}, 36, 40),
                 "scales between 1 and 2.98e+03");
}

TEST(MakeChart, RefusesAChartThatOverlapsItself) {
  NurbsSurface ramp = revolved(line({1, 0, 1}, {3, 0, 1.2}), 0, 3 * pi);  // one and a half turns of a flat cone
  ramp.is_closed_u = false;
  expect_refusal(face_of(ramp, {{0, 1, 2, 3}}, 60, 5), "overlaps itself");
}

TEST(MakeChart, OptionsAreChecked) {
  chart::ChartOptions options;
  options.closedness = 0;
  EXPECT_THROW(options.validate(), UsageError);
  options = {};
  options.greatest_scale_range = 1;
  EXPECT_THROW(options.validate(), UsageError);
}

}  // namespace
}  // namespace quadrille
