#include "occ/occ_curves.hpp"

#include <gtest/gtest.h>

#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <gp_Elips.hxx>
#include <gp_Parab.hxx>

#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::occ {
namespace {

const gp_Ax2 plane_axes({1, 2, 0}, {0, 0, 1});

PlaneCurve converted(const Handle(Geom_Curve) & curve, double first, double last) {
  return plane_curve(curve, first, last, PlaneFrame(), 1e-6);
}

std::string refusal(const Handle(Geom_Curve) & curve, double first, double last) {
  return message_of<FormatError>([&] { converted(curve, first, last); });
}

/// Greatest |f| on the curve.
double greatest(const Nurbs& curve, const std::function<double(Vec2)>& f) {
  double greatest = 0;
  for (int i = 0; i <= 20; ++i)
    greatest = std::max(greatest, std::abs(f(curve::point(curve, std::lerp(curve.begin(), curve.end(), i / 20.0)))));
  return greatest;
}

void expect_ends(const PlaneCurve& c, const Handle(Geom_Curve) & curve, double first, double last) {
  const gp_Pnt a = curve->Value(first), b = curve->Value(last);
  EXPECT_LT(distance(c.curve.poles.front(), {a.X(), a.Y()}), 1e-14);
  EXPECT_LT(distance(c.curve.poles.back(), {b.X(), b.Y()}), 1e-14);
  EXPECT_EQ(c.error, 0);
}

/// Through 0 and 1 at knots of multiplicity one: closed, and not clamped.
Handle(Geom_BSplineCurve) closed_spline() {
  TColgp_Array1OfPnt poles(1, 4);
  poles(1) = {1, 0, 0}, poles(2) = {0, 1, 0}, poles(3) = {-1, 0, 0}, poles(4) = {0, -2, 0};
  TColStd_Array1OfReal knots(1, 5);
  TColStd_Array1OfInteger multiplicities(1, 5);
  for (int i = 1; i <= 5; ++i) knots(i) = i - 1, multiplicities(i) = 1;
  return new Geom_BSplineCurve(poles, knots, multiplicities, 2, true);
}

TEST(PlaneCurve, lines_and_conics_are_exact) {
  const Handle(Geom_Line) line = new Geom_Line(gp_Pnt(1, 2, 3), gp_Dir(1, 0, 0));
  expect_ends(converted(line, 2, 5), line, 2, 5);
  EXPECT_EQ(converted(line, 2, 5).height, 3);

  const Handle(Geom_Circle) circle = new Geom_Circle(plane_axes, 2);
  const PlaneCurve arc = converted(circle, 0.3, 4);
  expect_ends(arc, circle, 0.3, 4);
  EXPECT_LT(greatest(arc.curve, [](Vec2 x) { return distance(x, {1, 2}) - 2; }), 1e-14);

  const Handle(Geom_Ellipse) ellipse = new Geom_Ellipse(plane_axes, 3, 1);
  const PlaneCurve oval = converted(ellipse, -1, 2);
  expect_ends(oval, ellipse, -1, 2);
  EXPECT_LT(greatest(oval.curve, [](Vec2 x) { return (x.x - 1) * (x.x - 1) / 9 + (x.y - 2) * (x.y - 2) - 1; }), 1e-14);

  const Handle(Geom_Parabola) parabola = new Geom_Parabola(plane_axes, 0.5);
  const PlaneCurve bow = converted(parabola, -1, 3);
  expect_ends(bow, parabola, -1, 3);
  EXPECT_LT(greatest(bow.curve, [](Vec2 x) { return (x.y - 2) * (x.y - 2) - 2 * (x.x - 1); }), 1e-13);
}

TEST(PlaneCurve, trims_of_trims_are_those_of_the_curve) {
  const Handle(Geom_Circle) circle = new Geom_Circle(plane_axes, 2);
  const Handle(Geom_Curve) half = new Geom_TrimmedCurve(circle, 0, pi);
  expect_ends(converted(new Geom_TrimmedCurve(half, 0.5, 3), 1, 2), circle, 1, 2);
}

TEST(PlaneCurve, curves_off_the_plane_have_a_height) {
  const Handle(Geom_Circle) upright = new Geom_Circle(gp_Ax2({0, 0, 0}, {0, 1, 0}, {1, 0, 0}), 1);
  EXPECT_NEAR(converted(upright, 0, 2 * pi).height, 1, 1e-14);
  const Handle(Geom_BSplineCurve) spline = closed_spline();
  spline->SetPole(2, gp_Pnt(0, 1, -0.25));
  EXPECT_NEAR(converted(spline, 0, 4).height, 0.25, 1e-14);
}

TEST(PlaneCurve, closed_splines_run_on_across_their_seam) {
  const Handle(Geom_BSplineCurve) spline = closed_spline();
  for (const double shift : {0.0, 4.0, -8.0}) {
    const PlaneCurve c = converted(spline, 3.5 + shift, 4.75 + shift);
    expect_ends(c, spline, 3.5, 0.75);
    EXPECT_NEAR(c.curve.begin(), 3.5, 1e-12);
    EXPECT_NEAR(c.curve.end(), 4.75, 1e-12);
    for (const double t : {3.75, 4.0, 4.25}) {
      const gp_Pnt p = spline->Value(t);
      EXPECT_LT(distance(curve::point(c.curve, t), {p.X(), p.Y()}), 1e-14) << t;
    }
  }
  expect_ends(converted(spline, 4, 8), spline, 0, 4);
}

TEST(PlaneCurve, wrong_intervals_are_refused) {
  const Handle(Geom_Circle) circle = new Geom_Circle(plane_axes, 2);
  EXPECT_EQ(refusal(circle, 0, 2 * pi), "");
  EXPECT_EQ(refusal(circle, 0, 2 * pi + 1e-3), "an arc goes round more than once");
  EXPECT_EQ(refusal(circle, 1, 1), "a curve has an empty parameter interval");
  EXPECT_EQ(refusal(new Geom_Line(gp_Pnt(), gp_Dir(1, 0, 0)), 1, 0), "") << "a line runs both ways";
  const Handle(Geom_BSplineCurve) spline = closed_spline();
  EXPECT_EQ(refusal(spline, 1, 0), "a B-spline curve has an empty parameter interval");
  spline->SetNotPeriodic();
  EXPECT_EQ(refusal(spline, 3, 4 + 1e-3), "");
  EXPECT_EQ(refusal(spline, 5, 6), "the ends of the edge lie off its B-spline curve");
  EXPECT_EQ(refusal(spline, -2, -1), "the ends of the edge lie off its B-spline curve");
}

/// The curve at a distance from an ellipse is no conic.
TEST(PlaneCurve, other_curves_are_approximated_within_the_tolerance) {
  const Handle(Geom_Curve) offset = new Geom_OffsetCurve(new Geom_Ellipse(plane_axes, 3, 1), 0.5, gp_Dir(0, 0, 1));
  const PlaneCurve c = converted(offset, 0, 2);
  EXPECT_GT(c.error, 0);
  EXPECT_LE(c.error, 1e-6);
  for (const double t : {0.0, 0.3, 1.1, 2.0}) {
    const gp_Pnt p = offset->Value(t);
    EXPECT_LT(distance(curve::point(c.curve, t), {p.X(), p.Y()}), 2e-6) << t;
  }
}

}  // namespace
}  // namespace quadrille::occ
