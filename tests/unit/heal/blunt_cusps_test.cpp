#include "heal/blunt_cusps.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/chain.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::heal {

namespace {

Loop loop_of(const std::vector<Nurbs>& curves) {
  Loop loop;
  for (const Nurbs& curve : curves) loop.push_back({curve, static_cast<int>(loop.size()), "side"});
  return loop;
}

// Between a line and an arc that touches it at (0, 0), curve 0 starting there.
Loop line_and_arc() {
  const Vec2 top{std::cos(pi / 6), 0.5};
  return loop_of(
      {curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, top), curve::circular_arc({0, 1}, 1, -pi / 6, -half_pi)});
}

// Between two arcs that touch each other at (0, 0).
Loop two_arcs() {
  const Vec2 top{std::cos(pi / 6), 0.5};
  return loop_of({curve::circular_arc({0, -1}, 1, half_pi, pi / 6), curve::segment({top.x, -0.5}, top),
                  curve::circular_arc({0, 1}, 1, -pi / 6, -half_pi)});
}

// Between a half circle and two smaller ones on its diameter: cusps at both ends of each.
Loop arbelos() {
  return loop_of({curve::circular_arc({0, 0}, 1, 0, pi), curve::circular_arc({-0.5, 0}, 0.5, pi, 0),
                  curve::circular_arc({0.5, 0}, 0.5, pi, 0)});
}

std::vector<Repair> blunt(Loop& loop, double width, Report& report) {
  std::vector<Loop> loops{loop};
  std::vector<Repair> repairs;
  blunt_cusps(loops, {"f.step", 1, width}, repairs, report);
  loop = loops.front();
  return repairs;
}

std::vector<Repair> blunt(Loop& loop, double width) {
  Report report;
  return blunt(loop, width, report);
}

std::string refusal(Loop loop, double width) {
  return message_of<FormatError>([&] {
    if (width > 0)
      blunt(loop, width);
    else
      refuse_cusps({loop}, {"f.step", 1, 0});
  });
}

void expect_closed_without_cusps(const Loop& loop) {
  for (size_t i = 0; i < loop.size(); ++i) {
    const Nurbs &in = loop[i].curve, &out = loop[(i + 1) % loop.size()].curve;
    EXPECT_LE(distance(in.poles.back(), out.poles.front()), 1e-15);
    EXPECT_FALSE(is_cusp(interior_angle(in, out)));
  }
}

TEST(BluntCusps, CutsBothCurvesAtTheWidth) {
  for (Loop loop : {line_and_arc(), two_arcs()}) {
    const auto repairs = blunt(loop, 0.01);
    ASSERT_EQ(loop.size(), 4U);
    expect_closed_without_cusps(loop);
    EXPECT_NEAR(curve::ArcLength(loop[3].curve).total(), 0.01, 1e-12);
    EXPECT_EQ(loop[3].name, "");
    EXPECT_EQ(loop[3].cad_edge, 2);
    ASSERT_EQ(repairs.size(), 1U);
    EXPECT_EQ(repairs[0].kind, RepairKind::cusp);
    EXPECT_EQ(repairs[0].cad_edge, 2);
    EXPECT_LE(norm(repairs[0].position), 1e-15);
  }
}

TEST(BluntCusps, CutsAsMuchAsGeometryAsks) {
  Loop loop = two_arcs();
  const auto repairs = blunt(loop, 0.02);
  // Half the width is 1 - cos(cut).
  EXPECT_NEAR(repairs[0].distance, std::acos(0.99), 1e-12);
  EXPECT_NEAR(loop[3].curve.poles[0].x, std::sin(repairs[0].distance), 1e-12);
  EXPECT_NEAR(loop[3].curve.poles[0].y, 0.01, 1e-12);
  EXPECT_NEAR(loop[3].curve.poles[1].y, -0.01, 1e-12);
}

TEST(BluntCusps, CutsBothEndsOfAnEdge) {
  Loop loop = arbelos();
  const auto repairs = blunt(loop, 0.02);
  EXPECT_EQ(repairs.size(), 3U);
  EXPECT_EQ(loop.size(), 6U);
  expect_closed_without_cusps(loop);
  EXPECT_NEAR(repairs[0].distance, repairs[1].distance, 1e-12);
}

TEST(BluntCusps, LeavesLoopsWithoutCusps) {
  Loop loop = loop_of({curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {0, 1}), curve::segment({0, 1}, {0, 0})});
  Report report;
  EXPECT_TRUE(blunt(loop, 0.01, report).empty());
  EXPECT_EQ(loop.size(), 3U);
  EXPECT_EQ(refusal(loop, 0), "");
}

TEST(BluntCusps, RefusesWidthsThatTheEdgesDoNotHave) {
  const std::string text = refusal(line_and_arc(), 2);
  expect_contains(text,
                  "f.step: edges 2 and 0 meet in a cusp at (0, 0), which cannot be cut off at a width of 2, as its "
                  "edges are too short: give --blunt 0.44, the largest that would do, or less");
  EXPECT_EQ(refusal(line_and_arc(), 0.435), "");
  expect_contains(refusal(line_and_arc(), 0.45), "--blunt 0.44");
  expect_contains(refusal(line_and_arc(), 1e-6), "give 1.1e-05 or more");
}

TEST(BluntCusps, RefusalsOfCuspsProposeAWidth) {
  expect_contains(refusal(line_and_arc(), 0),
                  "f.step: edges 2 and 0 meet in a cusp at (0, 0), an angle of zero, which holds no quad: give --blunt "
                  "0.001 to cut its tip off at that width");
}

Loop wedge(double angle, double size = 1) {
  return loop_of({curve::segment({0, 0}, {size, 0}), curve::segment({size, 0}, size * unit(angle)),
                  curve::segment(size * unit(angle), {})});
}

TEST(BluntCusps, AutomaticCutsAreAThousandthWideAndWarn) {
  Loop loop = line_and_arc();
  Report report;
  EXPECT_EQ(blunt(loop, automatic_width, report).size(), 1U);
  EXPECT_NEAR(curve::ArcLength(loop[3].curve).total(), 1e-3, 1e-12);
  ASSERT_EQ(report.warnings().size(), 1U);
  EXPECT_EQ(report.warnings()[0].code, "W-CAD-011");
  EXPECT_EQ(report.warnings()[0].message,
            "f.step: no quad fits into a tip, which is cut off: edges 2 and 0 meet in a cusp at (0, 0), 0.045 long and "
            "0.001 wide: give --blunt WIDTH for another width, --blunt 0 to refuse such faces");
  Report of_many;
  Loop many = arbelos();
  EXPECT_EQ(blunt(many, automatic_width, of_many).size(), 3U);
  expect_contains(of_many.warnings().at(0).message, "3 tips, which are cut off: ");
  Report asked;
  Loop other = line_and_arc();
  blunt(other, 1e-3, asked);
  EXPECT_TRUE(asked.warnings().empty());
}

TEST(BluntCusps, AutomaticCutsOfShortEdgesAreHalfOfWhatFits) {
  Loop loop = wedge(radians(0.1));
  blunt(loop, automatic_width);
  const double most = 0.95 * std::sin(radians(0.1));
  EXPECT_NEAR(curve::ArcLength(loop[3].curve).total(), most / 2, 1e-3 * most);
  Loop tiny = wedge(radians(0.1), 1e-3);
  EXPECT_TRUE(blunt(tiny, automatic_width).empty()) << "as narrow as edges that healing removes: it stays";
  EXPECT_EQ(tiny.size(), 3U);
}

TEST(BluntCusps, InAFarFieldTheBodiesAreTheMeasure) {
  Loop outline = loop_of({curve::circular_arc({0, 0}, 50, 0, 2 * pi)}), body = two_arcs();
  outline.front().name = "farfield";
  const double across = std::hypot(std::cos(pi / 6), 1);
  for (const bool is_far : {true, false}) {
    if (!is_far) outline.front().name = "wall";
    std::vector<Loop> loops{outline, body};
    std::vector<Repair> repairs;
    Report report;
    blunt_cusps(loops, {"f.step", 100, automatic_width}, repairs, report);
    ASSERT_EQ(loops[1].size(), 4U);
    EXPECT_NEAR(curve::ArcLength(loops[1][3].curve).total(), is_far ? 1e-3 * across : 0.1, 1e-6);
  }
}

TEST(BluntCusps, SharpCornersAreCutOffButNotRefused) {
  Loop sharp = wedge(radians(0.19)), wide = wedge(radians(0.21));
  EXPECT_EQ(refusal(sharp, 0), "");
  EXPECT_EQ(blunt(sharp, 1e-3).size(), 1U);
  EXPECT_EQ(sharp.size(), 4U);
  EXPECT_TRUE(blunt(wide, 1e-3).empty());
  EXPECT_EQ(
      refusal(wedge(radians(0.1)), 1),
      "f.step: edges 2 and 0 meet in a corner of 0.1 degrees at (0, 0), which cannot be cut off at a width of 1, as "
      "its edges are too short: give --blunt 0.0016, the largest that would do, or less");
}

}  // namespace

}  // namespace quadrille::heal
