#include "space/boundary_loops.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "grid_face.hpp"

namespace quadrille::space {

namespace {

std::string refusal(const RawSpaceFace& raw) {
  return message_of<FormatError>([&] { boundary_loops(raw); });
}

TEST(BoundaryLoops, edges_follow_each_other_with_the_face_on_the_left) {
  const auto loops = boundary_loops(grid_face(flat_square(), 3));
  ASSERT_EQ(loops.size(), 1U);
  ASSERT_EQ(loops[0].size(), 4U);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(loops[0][i].polygon, i);
    EXPECT_EQ(loops[0][i].is_reversed, i >= 2);
  }
}

// Without its middle square, the grid has a hole.
TEST(BoundaryLoops, the_longest_loop_comes_first) {
  RawSpaceFace raw = grid_face(flat_square(), 3);
  raw.triangles.erase(raw.triangles.begin() + 8, raw.triangles.begin() + 10);
  raw.triangle_uv.erase(raw.triangle_uv.begin() + 8, raw.triangle_uv.begin() + 10);
  add_edge(raw, {5, 6, 10, 9, 5}, tests::line(raw.vertices[5], raw.vertices[5]));
  const auto loops = boundary_loops(raw);
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(loops[0].size(), 4U);
  ASSERT_EQ(loops[1].size(), 1U);
  EXPECT_EQ(loops[1][0].polygon, 4);
  EXPECT_TRUE(loops[1][0].is_reversed);
}

TEST(BoundaryLoops, triangles_that_are_no_surface_are_refused) {
  RawSpaceFace raw = grid_face(flat_square(), 2);
  raw.triangles.push_back(raw.triangles.front());
  expect_contains(refusal(raw), "a.step: the CAD kernel's triangles of the face overlap at (0, 0, 0)");
  raw.triangles.clear();
  expect_contains(refusal(raw), "finds no triangles");
}

TEST(BoundaryLoops, an_edge_that_the_boundary_has_in_part_is_refused) {
  RawSpaceFace raw = grid_face(flat_square(), 3);
  raw.triangles.erase(raw.triangles.begin());
  expect_contains(refusal(raw), "the CAD kernel's triangles of the face end beside its edges");
}

TEST(BoundaryLoops, a_closed_surface_is_refused) {
  RawSpaceFace raw = grid_face(flat_square(), 1);
  raw.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  raw.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  expect_contains(refusal(raw), "the face is closed, without a boundary");
}

}  // namespace

}  // namespace quadrille::space
