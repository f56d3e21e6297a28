// Every picture of small models made by hand: the number of elements, no value that is no number, the same bytes twice.
#include "draw/draw.hpp"

#include <gtest/gtest.h>

#include "../region_samples.hpp"
#include "../support/block_sides.hpp"
#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::draw {
namespace {

void expect_sound(const std::string& svg) {
  EXPECT_EQ(count(svg, "nan"), 0);
  EXPECT_EQ(count(svg, "inf"), 0);
  EXPECT_EQ(svg.rfind("<?xml", 0), 0u);
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
  EXPECT_EQ(count(svg, "http"), 1) << "only the name space";
}

/// `field` may be null.
std::string draw_points(const CriticalPoints& points, const Field* field, DrawOptions options) {
  options.field = field;
  return draw_stage(points, options);
}

/// The unit square as a face; its curve 1 is called "out < let".
CadFace square() {
  CadFace face;
  const Vec2 corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int i = 0; i < 4; ++i) {
    face.curves.push_back(curve::segment(corners[i], corners[(i + 1) % 4]));
    face.joints.push_back({corners[i], wrap_pi(half_pi * (i - 1)), wrap_pi(half_pi * i), half_pi, true});
  }
  face.curve_names = {"wall", "out < let", "", ""};
  face.curve_cad_edges = {0, 1, 2, 3};
  face.loop_offsets = {0, 4};
  face.diameter = std::sqrt(2.0);
  return face;
}

TriMesh two_triangles() {
  TriMesh mesh;
  mesh.face = square();
  mesh.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.elem2vertices = {{0, 1, 2}, {0, 2, 3}};
  mesh.boundary_edges = {{0, 0, 0, 0, 1}, {0, 1, 1, 0, 1}, {1, 1, 2, 0, 1}, {1, 2, 3, 0, 1}};
  mesh.elem_layer = {-1, 0};
  return mesh;
}

/// u = 2 x - 1, v = 2 y - 1: zero in the middle.
Field linear_field() {
  Field field;
  field.mesh = two_triangles();
  field.elem_order = {1, 1};
  field.coef_offsets = {0, 3, 6};
  // The orthonormal basis of degree 1: sqrt(1/2), then sqrt(3/4)-ish multiples; fitted through the vertices.
  for (int e = 0; e < 2; ++e) {
    const auto& v = field.mesh.elem2vertices[e];
    const auto coefs = [&](auto f) {
      const double a = f(field.mesh.vertices[v[0]]), b = f(field.mesh.vertices[v[1]]), c = f(field.mesh.vertices[v[2]]);
      const double mean = (a + b + c) / 3;
      // f = mean + c1 phi1 + c2 phi2 with phi(0, 1) ~ (1 + 3 xi2) / 2 and phi(1, 0) ~ xi1 + (1 + xi2) / 2.
      const double along2 = (c - mean), along1 = (b - a) / 2;
      return std::array<double, 3>{mean * std::sqrt(2.0), along2, along1 * 2 / std::sqrt(3.0)};
    };
    for (const double value : coefs([](Vec2 x) { return 2 * x.x - 1; })) field.u.push_back(value);
    for (const double value : coefs([](Vec2 x) { return 2 * x.y - 1; })) field.v.push_back(value);
  }
  return field;
}

TEST(Draw, InterfacesAndSlitsAreDrawnOnce) {
  const std::string regions = draw_stage(samples::two_regions_mesh(), {});
  expect_sound(regions);
  EXPECT_EQ(count(regions, "<title>boundary curve"), 6);
  EXPECT_EQ(count(regions, "<title>interface, curves 1 and 7: fluid-solid"), 1);
  EXPECT_EQ(count(regions, "class=\"interface\""), 2) << "the line and its mark in the legend";
  EXPECT_EQ(count(regions, ">interface of two regions<"), 1);
  EXPECT_EQ(count(regions, ">fluid<"), 1);
  EXPECT_EQ(count(regions, ">solid<"), 1);
  EXPECT_EQ(count(regions, ", 2 regions"), 1);
  const std::string slit = draw_stage(samples::slit_mesh(), {});
  EXPECT_EQ(count(slit, "<title>slit, curves 4 and 5: crack"), 1);
  EXPECT_EQ(count(slit, "class=\"slit\""), 2);
  EXPECT_EQ(count(slit, "class=\"interface\""), 0);
  EXPECT_EQ(count(slit, "regions"), 0);
}

TEST(Draw, FieldsAndPointsOfRegions) {
  const Field field = samples::two_regions_field(), phase = samples::two_regions_phase_field();
  for (const std::string show : {"psi", "u", "order"}) {
    DrawOptions options;
    options.show = show;
    for (const std::string& svg : {draw_stage(field, options), draw_stage(phase, options)}) {
      expect_sound(svg);
      EXPECT_EQ(count(svg, "class=\"interface\""), 2);
      EXPECT_EQ(count(svg, ", 2 regions"), 1);
    }
  }
  EXPECT_EQ(count(draw_stage(phase, {}), "24 coefficients, 1 node asked for, 8 corner valences"), 1);
  const std::string points = draw_points(samples::two_regions_points(), &field, {});
  expect_sound(points);
  EXPECT_EQ(count(points, "class=\"corner\""), 9) << "8 and the legend";
  EXPECT_EQ(count(points, "class=\"interface\""), 2);
}

TEST(Draw, TriMeshShowsEveryElement) {
  const std::string svg = draw_stage(two_triangles(), {});
  expect_sound(svg);
  EXPECT_EQ(count(svg, "id=\"elem-"), 2);
  EXPECT_EQ(count(svg, "<title>boundary curve"), 4);
  EXPECT_EQ(count(svg, "<title>corner at"), 4);
  EXPECT_EQ(count(svg, "boundary curve 1: out &lt; let"), 1);
  EXPECT_EQ(svg, draw_stage(two_triangles(), {}));
}

TEST(Draw, WidthIsThatOfTheOptions) {
  DrawOptions options;
  options.width = 640;
  EXPECT_EQ(count(draw_stage(two_triangles(), options), "width=\"640\""), 1);
}

TEST(Draw, FieldShowsCellsAndBothZeroContours) {
  for (const char* show : {"psi", "u", "v"}) {
    DrawOptions options;
    options.show = show;
    const std::string svg = draw_stage(linear_field(), options);
    expect_sound(svg);
    EXPECT_GT(count(svg, "<path fill="), 10) << show;
    EXPECT_GE(count(svg, "class=\"zero-u\""), 1) << show;
    EXPECT_GE(count(svg, "class=\"zero-v\""), 1) << show;
    EXPECT_EQ(svg, draw_stage(linear_field(), options));
  }
}

TEST(Draw, OrderMapShowsEveryElement) {
  DrawOptions options;
  options.show = "order";
  const std::string svg = draw_stage(linear_field(), options);
  expect_sound(svg);
  EXPECT_EQ(count(svg, "id=\"elem-"), 2);
}

TEST(Draw, UnknownQuantityIsAUsageError) {
  DrawOptions options;
  options.show = "w";
  EXPECT_THROW(draw_stage(linear_field(), options), UsageError);
}

TEST(Draw, CriticalPointsShowValences) {
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

TEST(Draw, AnAlignedFieldShowsThePrescribedDirectionsInsideTheFace) {
  Field field = linear_field();
  EXPECT_EQ(count(draw_stage(field, {}), "class=\"prescribed\""), 0);
  field.alignment = {{{0.25, 0.5}, 0.1, 1, 0.3},
                     {{0.25, 0.5}, 0.1, 0.5, 1},
                     {{0.75, 0.5}, 0.1, 1, 0.3},
                     {{0.5, 0.25}, 0.1, 1e-3, 0.3},
                     {{2, 0.5}, 0.1, 1, 0.3}};
  const std::string svg = draw_stage(field, {});
  expect_sound(svg);
  EXPECT_EQ(count(svg, "class=\"prescribed\""), 2) << "one path, and that of the legend";
  const std::size_t begin = svg.find("class=\"prescribed\"");
  EXPECT_EQ(count(svg.substr(begin, svg.find("/>", begin) - begin), "M"), 2) << "one in each place, none outside";
}

TEST(Draw, AMeshByAMetricShowsItsDirections) {
  QuadMesh mesh = samples::quad_mesh();
  mesh.elem_prescribed_stretch = {{}, {}};
  EXPECT_EQ(count(draw_stage(mesh, {}), "class=\"prescribed\""), 0) << "lengths are equal";
  mesh.elem_prescribed_stretch = {{}, tensor_of({2, 0.5, 0})};
  const std::string svg = draw_stage(mesh, {});
  expect_sound(svg);
  EXPECT_EQ(count(svg, "class=\"prescribed\""), 2) << "one path, and that of the legend";
}

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

DrawOptions thousand_pixels_a_unit() {
  DrawOptions options;
  options.width = 1072;
  return options;
}

TEST(Draw, ErrorBarsAreCirclesWhereTheyCanBeSeen) {
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

TEST(Draw, CertificateShowsCellsAndDiscsInsideTheFace) {
  const Field field = linear_field();
  const std::string svg = draw_points(resolved_points(), &field, thousand_pixels_a_unit());
  expect_counts(svg, {{"<path class=\"cell-zero\" d=\"M700 200L800 300L600 300z\">", 1},
                      {"<title>cell in element 1: holds exactly one zero<", 1},
                      {"<title>cell in element 0: could not be decided<", 1},
                      {"<circle class=\"disc\" cx=\"0\" cy=\"0\" r=\"62.5\">", 1},
                      {"<clipPath ", 1},
                      {"321 cells searched", 1}});
}

TEST(Draw, ClustersAreDashedCirclesWithTheirIndex) {
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

TEST(Draw, ChangesAreArrowsFromBeforeToAfterWithTheirReason) {
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

TEST(Draw, AbsorbedCornersAndBoundaryNodesAreMarked) {
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

TEST(Draw, LegendsAreForWhatOccurs) {
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

TEST(Draw, OnePointAloneHasRoomAroundIt) {
  CriticalPoints points;
  points.critical_points = {{{7, 7}, 1, 3, 0, {}, {}, 0.5}};
  const std::string svg = draw_points(points, nullptr, {});
  expect_sound(svg);
  EXPECT_LT(svg.size(), 10000u);
}

/// Half a turn of the square's cross field: phi = 0, one node of valence 3 asked for (its terms are not drawn).
Field phase_field() {
  Field field = linear_field();
  field.kind = FieldKind::phase;
  field.phase.s.assign(field.u.size(), 0.0);
  field.u.clear();
  field.v.clear();
  field.phase.prescribed.nodes = {{{0.5, 0.5}, 3}};
  field.phase.prescribed.corners = {{0, 2}};
  field.phase.prescribed.boundary_nodes = {{1, 0.25, 3}};
  return field;
}

TEST(Draw, PhaseFormShowsTheNodesAskedForAndNoZeroContours) {
  for (const char* show : {"psi", "u", "v", "order"}) {
    DrawOptions options = thousand_pixels_a_unit();
    options.show = show;
    const std::string svg = draw_stage(phase_field(), options);
    expect_sound(svg);
    EXPECT_EQ(count(svg, ">Phase form: "), 2) << "the title and what is seen of it; " << show;
    EXPECT_EQ(count(svg, "class=\"zero-"), 0);
    EXPECT_EQ(count(svg, "6 coefficients, 1 node asked for, 1 boundary node, 1 corner valence<"), 1);
    EXPECT_EQ(count(svg, "<title>node of valence 3 asked for at (0.5, 0.5)<"), 1);
    EXPECT_EQ(count(svg, "<title>boundary node of valence 3 asked for on curve 1<"), 1);
  }
  const Field field = phase_field();
  const std::string svg = draw_points(resolved_points(), &field, {});
  EXPECT_EQ(count(svg, "class=\"zero-"), 0);
  EXPECT_EQ(count(svg, "class=\"cross\""), 1);
}

TEST(Draw, NoCriticalPointsAtAllIsAPictureToo) { expect_sound(draw_points({}, nullptr, {})); }

SeparatrixGraph halved_square() {
  SeparatrixGraph graph;
  graph.face = square();
  graph.splines = {curve::segment({0, 0.5}, {1, 0.5})};
  for (int i = 0; i < 4; ++i) graph.nodes.push_back({graph.face.joints[i].position, NodeKind::corner, 1, i, 0});
  graph.nodes.push_back({{1, 0.5}, NodeKind::boundary, 2, 1, 0.5});
  graph.nodes.push_back({{0, 0.5}, NodeKind::cut, 2, 3, 0.5});
  graph.arcs = {{0, 1, true, 0, {{0, 0, 1}}}, {1, 4, true, 0, {{1, 0, 0.5}}}, {4, 2, true, 0, {{1, 0.5, 1}}},
                {2, 3, true, 0, {{2, 0, 1}}}, {3, 5, true, 0, {{3, 0, 0.5}}}, {5, 0, true, 0, {{3, 0.5, 1}}},
                {5, 4, false, 0, {{4, 0, 1}}}};
  graph.lines = {{5, 4, LineKind::cut, {6}}};
  return graph;
}

TEST(Draw, SeparatricesShowLinesAndNodes) {
  const std::string svg = draw_stage(halved_square(), {});
  expect_sound(svg);
  EXPECT_EQ(count(svg, "id=\"line-"), 1);
  EXPECT_EQ(count(svg, "<title>node "), 6);
}

TEST(Draw, SeparatricesTellTheirCertificate) {
  SeparatrixGraph graph = halved_square();
  EXPECT_EQ(count(draw_stage(graph, {}), "index sum"), 0);
  graph.certificate.method = LayoutMethod::traced;
  graph.certificate.index_sum = 4;
  graph.certificate.face_valence_histogram = {{4, 2}};
  graph.certificate.largest_deviation_degrees = 2.34;
  EXPECT_EQ(count(draw_stage(graph, {}), "traced: 2 faces of 4 corners, index sum 4, turned by 2.3° at most"), 1);
}

TEST(Draw, ArcsOfNoLineAreDrawnAllTheSame) {
  SeparatrixGraph graph = halved_square();
  graph.lines.clear();
  EXPECT_EQ(count(draw_stage(graph, {}), "<title>arc 6<"), 1);
}

TEST(Draw, BlocksShowNumbersInTheirMiddle) {
  const SeparatrixGraph graph = halved_square();
  BlockLayout layout;
  layout.face = graph.face;
  layout.splines = graph.splines;
  layout.nodes = graph.nodes;
  layout.arcs = graph.arcs;
  layout.block2nodes = {{0, 1, 4, 5}, {5, 4, 2, 3}};
  layout.block2arcs = {block_sides({0, 1, -7, 5}), block_sides({6, 2, 3, 4})};
  layout.arc_chord = {0, 1, 2, 0, 2, 1, 0};
  layout.block_names = {"inlet block", ""};
  DrawOptions options;
  options.width = 1072;  // 1000 pixels a unit
  const std::string svg = draw_stage(layout, options);
  expect_sound(svg);
  EXPECT_EQ(count(svg, "id=\"block-"), 2);
  EXPECT_EQ(count(svg, "<title>block 0: inlet block<"), 1);
  EXPECT_EQ(count(svg, "x=\"500\" y=\"754\">0</text>"), 1) << svg;
  EXPECT_EQ(count(svg, "x=\"500\" y=\"254\">1</text>"), 1);
  EXPECT_EQ(count(svg, "3 chords"), 1);
  EXPECT_EQ(count(svg, "class=\"worst\""), 0) << "not known";

  layout.block_scaled_jacobian = {0.25, 0.75};
  layout.nodes[4].valence = 3;
  layout.nodes[4].kind = NodeKind::boundary;
  const std::string measured = draw_stage(layout, options);
  expect_sound(measured);
  EXPECT_EQ(count(measured, "<title>block 0, scaled Jacobian 0.25<"), 1);
  EXPECT_EQ(count(measured, "class=\"worst\""), 2) << "block 0 and the legend";
  EXPECT_EQ(count(measured, "<title>irregular node on the boundary of valence 3 at (1, 0.5)<"), 1) << measured;
  EXPECT_EQ(count(measured, "on the boundary, valence 3<"), 1);
  EXPECT_EQ(count(measured, "1 irregular node"), 1);

  layout.block_scaled_jacobian = {0.25, 0.25};
  EXPECT_EQ(count(draw_stage(layout, options), "class=\"worst\""), 2) << "one mark for the worst";
  layout.block_scaled_jacobian = {1, 0.5};
  EXPECT_EQ(count(draw_stage(layout, options), "class=\"worst\""), 0) << "nothing to complain of";
}

/// Two quads of order N side by side in the unit square, the right one with the given quality.
QuadMesh two_quads(int order, double quality) {
  QuadMesh mesh;
  mesh.face = square();
  mesh.order = order;
  const auto& points = spectral::gll_points(order);
  const int m = order + 1;
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < 2 * order + 1; ++i) {
      const double s = i <= order ? (points[i] + 1) / 4 : 0.5 + (points[i - order] + 1) / 4;
      mesh.nodes.push_back({s, (points[j] + 1) / 2});
    }
  for (int e = 0; e < 2; ++e)
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < m; ++i) mesh.elem_nodes.push_back(j * (2 * order + 1) + e * order + i);
  mesh.elem_block = {0, 1};
  mesh.elem_jacobian_bound = {0.1, 0.1};
  mesh.elem_scaled_jacobian = {1, quality};
  return mesh;
}

TEST(Draw, QuadsAreColouredAndTheWorstIsRinged) {
  const std::string svg = draw_stage(two_quads(3, 0.25), {});
  expect_sound(svg);
  EXPECT_EQ(count(svg, "id=\"elem-"), 2);
  EXPECT_EQ(count(svg, "<title>quad 1 at (0.75, 0.5): scaled Jacobian 0.250<"), 1);
  EXPECT_EQ(count(svg, "<circle class=\"ring\""), 2) << "the ring and its legend";
  EXPECT_EQ(count(svg, "class=\"edge\""), 1) << "the border between two blocks";
}

TEST(Draw, QuadsThatAreNotProvedAreOutlinedAndSaid) {
  QuadMesh mesh = two_quads(2, -1);
  EXPECT_EQ(count(draw_stage(mesh, {}), "class=\"worst\""), 0);
  mesh.elem_jacobian_bound[1] = -0.2;
  mesh.is_valid = false;
  const std::string svg = draw_stage(mesh, {});
  expect_sound(svg);
  EXPECT_EQ(count(svg, "class=\"worst\""), 2) << "the quad and the legend";
  EXPECT_EQ(count(svg, "not proved valid (1)<"), 1);
  EXPECT_EQ(count(svg, "NOT VALID: 2 quads"), 1);
}

TEST(Draw, LengthsOfQuadsAreInTheCaptionIfTheFileHasThem) {
  QuadMesh mesh = two_quads(2, 0.5);
  EXPECT_EQ(count(draw_stage(mesh, {}), "edge ratio"), 0);
  mesh.elem_edge_ratio = {1, 2.5};
  mesh.elem_area_jump = {3, 3};
  mesh.elem_node_distance = {0.25, 0.125};
  DrawOptions wide;  // enough for a caption of one line
  wide.width = 1500;
  const std::string svg = draw_stage(mesh, wide);
  EXPECT_EQ(count(svg, "greatest edge ratio 2.5, greatest area jump 3, least node distance 0.125<"), 1);
  EXPECT_EQ(count(svg, "scaled Jacobian 0.500, edge ratio 2.5<"), 1);
}

TEST(Draw, OnlyTheWorstIsRingedAndOnlyIfItIsPoor) {
  QuadMesh mesh = two_quads(1, 0.49);
  mesh.elem_scaled_jacobian[0] = 0.49;
  EXPECT_EQ(count(draw_stage(mesh, {}), "<circle class=\"ring\""), 2) << "the ring and its legend";
  for (const double quality : {0.5, 1.0})
    EXPECT_EQ(count(draw_stage(two_quads(1, quality), {}), "class=\"ring\""), 0) << quality;
}

}  // namespace
}  // namespace quadrille::draw
