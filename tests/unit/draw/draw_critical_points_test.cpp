#include <gtest/gtest.h>

#include "square_samples.hpp"

namespace quadrille::draw {
namespace {

/// One of everything, 1000 pixels a unit over the square.
CriticalPoints resolved_points() {
  CriticalPoints points;
  points.form = NodeForm::phase;
  points.critical_points = {{{0.2, 0.5}, 1, 3, 0, {}, {}, 0, NodeSource::cluster},
                            {{0.4, 0.5}, 1, 3, 0, {}, {}, 0, NodeSource::cluster},
                            {{0.7, 0.3}, -1, 5, 0, {}, {}, 0.05, NodeSource::zero}};
  points.corners = {{0, {0, 0}, 90, 2, {3, 0}, NodeSource::absorb}, {1, {1, 0}, 90, 0, {0, 1}}};
  points.boundary_nodes = {{1, 0.5, {1, 0.5}, 3, NodeSource::feature}};
  points.clusters = {{{0.3, 0.5}, 0.04, 2, {{0.29, 0.5}, {0.31, 0.5}}, {1, 1}}};
  points.changes = {{ChangeKind::cluster, "two < four", {{{0.3, 0.5}, 2}}, {{{0.2, 0.5}, 3}, {{0.4, 0.5}, 3}}},
                    {ChangeKind::absorb,
                     "near",
                     {{{0, 0}, 1, NodeLocation::corner}, {{0.1, 0.1}, 5}},
                     {{{0, 0}, 2, NodeLocation::corner}}},
                    {ChangeKind::cancel, "a pair", {{{0.6, 0.8}, 3}, {{0.65, 0.8}, 5}}, {}},
                    {ChangeKind::place, "hardly moved", {{{0.7, 0.301}, 5}}, {{{0.7, 0.3}, 5}}},
                    {ChangeKind::line, "by rule", {}, {{{1, 0}, 0, NodeLocation::corner}}}};
  points.certificate.cells_examined = 321;
  points.certificate.cells = {{1, {0.7, 0.2, 0.8, 0.3, 0.6, 0.3}, CellVerdict::zero},
                              {0, {0.3, 0.4, 0.4, 0.5, 0.2, 0.5}, CellVerdict::open}};
  points.certificate.disc_centres = {{0, 0}};
  points.certificate.disc_radii = {0.0625};
  return points;
}

TEST(DrawCriticalPoints, CriticalPointsShowValences) {
  CriticalPoints points;
  points.critical_points = {{{0.5, 0.5}, 1, 3, 0, {}, {}}, {{0.25, 0.5}, -1, 5, 0, {}, {}}};
  points.corners = {{0, {0, 0}, 90, 1, {3, 0}}};
  const std::string alone = draw_points(points, nullptr, {});
  expect_sound(alone);
  EXPECT_EQ(count(alone, "<title>critical point of valence 3"), 1);
  EXPECT_EQ(count(alone, "<title>critical point of valence 5"), 1);
  const Field field = linear_field();
  const std::string with_field = draw_points(points, &field, {});
  expect_sound(with_field);
  EXPECT_EQ(count(with_field, "<title>boundary curve"), 4);
}

TEST(DrawCriticalPoints, ErrorBarsAreCirclesWhereTheyCanBeSeen) {
  const Field field = linear_field();
  CriticalPoints points = resolved_points();
  EXPECT_EQ(count(draw_points(points, &field, thousand_pixels_a_unit()),
                  "<circle class=\"error\" cx=\"700\" cy=\"300\" r=\"50\">"),
            1);
  points.critical_points[2].error = 1e-9;
  const std::string svg = draw_points(points, &field, thousand_pixels_a_unit());
  EXPECT_EQ(count(svg, "class=\"error\""), 0) << "no legend either";
  EXPECT_EQ(count(svg, "valence 5 at (0.7, 0.3) ± 1e-09<"), 1);
}

TEST(DrawCriticalPoints, CertificateShowsCellsAndDiscsInsideTheFace) {
  const Field field = linear_field();
  const std::string svg = draw_points(resolved_points(), &field, thousand_pixels_a_unit());
  expect_counts(svg, {{"<path class=\"cell-zero\" d=\"M700 200L800 300L600 300z\">", 1},
                      {"<title>cell in element 1: holds exactly one zero<", 1},
                      {"<title>cell in element 0: could not be decided<", 1},
                      {"<circle class=\"disc\" cx=\"0\" cy=\"0\" r=\"62.5\">", 1},
                      {"<clipPath ", 1},
                      {"321 cells searched", 1}});
}

TEST(DrawCriticalPoints, ClustersAreDashedCirclesWithTheirIndex) {
  const Field field = linear_field();
  CriticalPoints points = resolved_points();
  std::string svg = draw_points(points, &field, thousand_pixels_a_unit());
  EXPECT_EQ(count(svg, "<circle class=\"cluster\" cx=\"300\" cy=\"500\" r=\"40\">"), 1);
  EXPECT_EQ(count(svg, ">+2</text>"), 1);
  EXPECT_EQ(count(svg, "class=\"member\""), 2);
  points.clusters[0].radius = 1e-12;
  svg = draw_points(points, &field, thousand_pixels_a_unit());
  EXPECT_EQ(count(svg, "<circle class=\"cluster\" cx=\"300\" cy=\"500\" r=\"17\">"), 1) << "never smaller than a mark";
}

TEST(DrawCriticalPoints, ChangesAreArrowsFromBeforeToAfterWithTheirReason) {
  const Field field = linear_field();
  CriticalPoints points = resolved_points();
  const auto changes = points.changes;
  const auto heads = [&](std::size_t i) {  // without that of the legend
    points.changes = {changes[i]};
    return count(draw_points(points, &field, thousand_pixels_a_unit()), "class=\"head\"") - 1;
  };
  EXPECT_EQ(heads(0), 2) << "one cluster, two nodes";
  EXPECT_EQ(heads(1), 1) << "from the absorbed node; the corner stays";
  EXPECT_EQ(heads(2), 0) << "nothing is left of a pair";
  EXPECT_EQ(heads(3), 0) << "no room: a ring";
  EXPECT_EQ(heads(4), 0) << "nothing was before: a ring";
  points.changes = {changes[3]};
  EXPECT_EQ(count(draw_points(points, &field, thousand_pixels_a_unit()), "<circle class=\"change\""), 1);
  const std::string svg = draw_points(resolved_points(), &field, thousand_pixels_a_unit());
  expect_sound(svg);
  EXPECT_EQ(count(svg, "<g><title>cluster: two &lt; four</title>"), 1);
  EXPECT_EQ(count(svg, "<g><title>absorb: near</title>"), 1);
  EXPECT_EQ(count(svg, "5 changes"), 1);
}

TEST(DrawCriticalPoints, AbsorbedCornersAndBoundaryNodesAreMarked) {
  const Field field = linear_field();
  const std::string svg = draw_points(resolved_points(), &field, {});
  EXPECT_EQ(count(svg, "class=\"taker\""), 2) << "the corner and its legend";
  EXPECT_EQ(count(svg, "90 degrees, valence 2, source: absorb<"), 1);
  EXPECT_EQ(count(svg, "90 degrees, valence 0, degenerate<"), 1);
  EXPECT_EQ(count(svg, "<title>boundary node of valence 3 at (1, 0.5)"), 1);
  EXPECT_EQ(count(svg, "<title>irregular node of valence 3"), 2);
  EXPECT_EQ(count(svg, "<title>critical point of valence 5"), 1);
  EXPECT_EQ(count(svg, ">node on the boundary<"), 1);
}

TEST(DrawCriticalPoints, LegendsAreForWhatOccurs) {
  CriticalPoints points = resolved_points();
  points.clusters.clear();
  points.changes.clear();
  points.boundary_nodes.clear();
  points.certificate = {};
  points.corners[0].source = NodeSource::angle;
  const std::string svg = draw_points(points, nullptr, {});
  expect_sound(svg);
  for (const char* label :
       {">cluster and its index<", ">change<", ">cancelled<", ">node before a change<", ">node on the boundary<",
        ">undecided cell<", ">cell with one zero<", ">left to the corner<", ">corner that absorbed a node<"}) {
    EXPECT_EQ(count(svg, label), 0) << label;
    EXPECT_EQ(count(draw_points(resolved_points(), nullptr, {}), label), 1) << label;
  }
}

TEST(DrawCriticalPoints, OnePointAloneHasRoomAroundIt) {
  CriticalPoints points;
  points.critical_points = {{{7, 7}, 1, 3, 0, {}, {}, 0.5}};
  const std::string svg = draw_points(points, nullptr, {});
  expect_sound(svg);
  EXPECT_LT(svg.size(), 10000u);
}

TEST(DrawCriticalPoints, NoCriticalPointsAtAllIsAPictureToo) { expect_sound(draw_points({}, nullptr, {})); }

TEST(DrawCriticalPoints, OverAPhaseFormThereAreNoZeroContours) {
  const Field field = phase_field();
  const std::string svg = draw_points(resolved_points(), &field, {});
  EXPECT_EQ(count(svg, "class=\"zero-"), 0);
  EXPECT_EQ(count(svg, "class=\"cross\""), 1);
}

}  // namespace
}  // namespace quadrille::draw
