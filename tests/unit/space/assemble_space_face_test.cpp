#include "space/assemble_space_face.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "base/vec3.hpp"
#include "grid_face.hpp"

namespace quadrille::space {

namespace {

TEST(AssembleSpaceFace, curves_run_along_the_loop_and_meet) {
  Report report;
  RawSpaceFace raw = grid_face(flat_square(), 2);
  raw.labels.wires.front()[2].name = "top";
  const SpaceFace face = assemble_space_face(raw, -1, report);
  EXPECT_EQ(face.face.loop_offsets, (std::vector<int>{0, 4}));
  EXPECT_EQ(face.face.curve_names, (std::vector<std::string>{"curve_0", "curve_1", "top", "curve_3"}));
  EXPECT_EQ(face.face.unnamed_curves, (std::vector<int>{0, 1, 3}));
  EXPECT_EQ(face.face.curve_cad_edges, (std::vector<int>{0, 1, 2, 3}));
  for (int i = 0; i < 4; ++i) EXPECT_EQ(face.curves[i].poles.back(), face.curves[(i + 1) % 4].poles.front());
  ASSERT_EQ(face.boundary_edges.size(), 8U);
  EXPECT_EQ(face.boundary_edges[4].vertices, (std::array<int, 2>{8, 7}));
  EXPECT_EQ(face.boundary_edges[4].t0, 0);
  EXPECT_EQ(face.boundary_edges[4].t1, 0.5);
}

TEST(AssembleSpaceFace, gaps_within_the_tolerance_are_closed_wider_ones_refused) {
  RawSpaceFace raw = grid_face(flat_square(), 2);
  raw.curves[1].poles[0].z = 2e-5;
  Report report;
  const SpaceFace face = assemble_space_face(raw, -1, report);
  EXPECT_EQ(face.curves[1].poles[0], (Vec3{2, 0, 1e-5}));
  EXPECT_EQ(face.curves[0].poles[1], (Vec3{2, 0, 1e-5}));
  raw.curves[1].poles[0].z = 1e-3;
  const std::string message = message_of<FormatError>([&] { assemble_space_face(raw, -1, report); });
  expect_contains(message, "a.step: edge 0 ends at (2, 0, 0), 0.001 from the start of edge 1 (0.00018 diameters");
  expect_contains(message, "give --heal-tolerance 0.00018");
  EXPECT_NO_THROW(assemble_space_face(raw, 1e-3, report));
}

TEST(AssembleSpaceFace, warns_of_edges_off_the_surface_but_not_of_other_parameters_along_them) {
  RawSpaceFace raw = grid_face(flat_square(), 2);
  raw.curves[0] = {2, {0, 0, 0, 1, 1, 1}, {{0, 0, 0}, {0.5, 0, 0}, {2, 0, 0}}, {1, 1, 1}};
  Report report;
  assemble_space_face(raw, -1, report);
  EXPECT_TRUE(report.warnings().empty());
  raw.curves[0].poles[1].z = 0.02;
  assemble_space_face(raw, -1, report);
  ASSERT_EQ(report.warnings().size(), 1U);
  expect_contains(report.warnings()[0].message, "edges lie off the surface of the face by up to 0.01, most edge 0");
}

TEST(AssembleSpaceFace, edges_are_cut_at_kinks) {
  RawSpaceFace raw = grid_face(roof(1), 2);
  for (const int edge : {0, 2}) {
    const double y = edge == 0 ? 0 : 2, z = raw.vertices[1].z;
    raw.curves[edge] = {1, {0, 0, 0.5, 1, 1}, {{0, y, 0}, {1, y, z}, {2, y, 0}}, {1, 1, 1}};
  }
  Report report;
  const SpaceFace face = assemble_space_face(raw, -1, report);
  EXPECT_EQ(face.face.curve_cad_edges, (std::vector<int>{0, 0, 1, 2, 2, 3}));
  EXPECT_EQ(face.curves[1].begin(), 0.5);
  EXPECT_EQ(face.boundary_edges.size(), 8U);
}

}  // namespace

}  // namespace quadrille::space
