#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "../support/block_sides.hpp"
#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "cad/load_face.hpp"
#include "curve/nurbs.hpp"
#include "occ/write_cad.hpp"

namespace quadrille::occ {
namespace {

// A half disc of radius 1, cut into two blocks along the y axis, whose arc pieces and names are those of the face.
BlockLayout two_blocks() {
  BlockLayout layout;
  CadFace& face = layout.face;
  face.curves = {curve::segment({-1, 0}, {1, 0}), curve::circular_arc({0, 0}, 1, 0, pi)};
  face.curve_names = {"floor", "roof"};
  face.loop_offsets = {0, 2};
  face.diameter = 2;
  face.length_unit = "inch";
  face.metres_per_unit = 0.0254;
  face.plane_origin = {1, 2, 3};
  face.plane_y = {0, 0.8, 0.6};
  layout.splines = {curve::segment({0, 0}, {0, 1})};
  const auto on_roof = [](double angle) { return unit(angle); };
  for (const Vec2 x : {Vec2{-1, 0}, {0, 0}, {1, 0}, on_roof(pi / 4), {0, 1}, on_roof(3 * pi / 4)})
    layout.nodes.push_back({x, NodeKind::boundary, 1, 0, 0});
  const auto arc = [&](int from, int to, int curve, double t0, double t1) {
    layout.arcs.push_back({from, to, curve < 2, 0, {{curve, t0, t1}}});
  };
  arc(0, 1, 0, 0, 1);
  arc(1, 2, 0, 1, 2);
  arc(2, 3, 1, 0, pi / 4);
  arc(3, 4, 1, pi / 4, pi / 2);
  arc(5, 4, 1, 3 * pi / 4, pi / 2);
  arc(5, 0, 1, 3 * pi / 4, pi);
  arc(4, 1, 2, 1, 0);
  layout.block2nodes = {{0, 1, 4, 5}, {1, 2, 3, 4}};
  layout.block2arcs = {block_sides({0, -7, -5, 5}), block_sides({1, 2, 3, 6})};
  layout.block_names = {"left", "right"};
  return layout;
}

TEST(WriteStep, faces_share_edges_and_vertices) {
  const std::string step = step_of_blocks(two_blocks());
  EXPECT_EQ(count(step, "ADVANCED_FACE("), 2);
  EXPECT_EQ(count(step, "EDGE_CURVE("), 7);
  EXPECT_EQ(count(step, "ORIENTED_EDGE("), 8);
  EXPECT_EQ(count(step, "VERTEX_POINT("), 6);
  EXPECT_EQ(count(step, "OPEN_SHELL("), 1);
}

TEST(WriteStep, names_and_unit_are_kept) {
  const std::string step = step_of_blocks(two_blocks());
  expect_counts(step, {{"ADVANCED_FACE('left'", 1},
                       {"ADVANCED_FACE('right'", 1},
                       {"EDGE_CURVE('floor'", 2},
                       {"EDGE_CURVE('roof'", 4},
                       {"'INCH'", 1},
                       {"'1970-01-01T00:00:00'", 1}});
}

TEST(WriteStep, the_same_layout_gives_the_same_bytes) {
  const std::string first = step_of_blocks(two_blocks());
  EXPECT_EQ(step_of_blocks(two_blocks()), first);
}

TEST(WriteStep, the_result_is_a_step_file_of_two_faces_with_a_shared_edge) {
  Report report;
  const CadFace face = cad::load_face_guarded(step_of_blocks(two_blocks()), "blocks.step", {}, report).face;
  EXPECT_EQ(face.region_names, (std::vector<std::string>{"left", "right"}));
  EXPECT_EQ(std::count_if(face.partners.begin(), face.partners.end(), [](int p) { return p >= 0; }), 2);
}

TEST(WriteStep, one_block_is_read_again_with_its_numbers) {
  BlockLayout layout = two_blocks();
  layout.block2nodes.pop_back();
  layout.block2arcs.pop_back();
  layout.face.origin = {10, 0};
  Report report;
  const CadFace face = cad::load_face_guarded(step_of_blocks(layout), "block.step", {}, report).face;
  EXPECT_EQ(face.name, "left");
  EXPECT_EQ(face.length_unit, "inch");
  ASSERT_EQ(face.num_curves(), 4);
  EXPECT_EQ(face.curve_names, (std::vector<std::string>{"floor", "curve_1", "roof", "roof"}));
  const Vec2 corner = face.joints[0].position;
  const std::array<double, 3> expected{1 + 9, 2, 3};
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(face.plane_origin[k] + corner.x * face.plane_x[k] + corner.y * face.plane_y[k], expected[k], 1e-13);
  for (double t = 0; t <= 1; t += 0.125) {
    const Nurbs& roof = face.curves[3];
    const Vec2 x = curve::point(roof, roof.begin() + t * (roof.end() - roof.begin()));
    const Vec2 centre = curve::point(face.curves[0], face.curves[0].end());
    EXPECT_NEAR(distance(x, centre), 1, 1e-13);
  }
}

TEST(WriteStep, refuses_arcs_that_miss_their_nodes) {
  BlockLayout layout = two_blocks();
  layout.nodes[4].position.y += 0.01;
  EXPECT_THROW(step_of_blocks(layout), ComputeError);
}

}  // namespace
}  // namespace quadrille::occ
