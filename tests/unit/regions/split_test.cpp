#include "regions/split.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../regions/faces_of_regions.hpp"
#include "adapt/adapt_loop.hpp"
#include "base/error.hpp"
#include "choice/choose_nodes.hpp"
#include "field/error_estimate.hpp"
#include "galerkin/solve_laplace.hpp"
#include "galerkin/solve_phase.hpp"
#include "regions/region_work.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::regions {

namespace {

using testing_faces::disc_in_square;

TriMesh mesh_of(const CadFace& face) {
  Report report;
  const std::vector<CadFace> parts = split(face);
  return join(face, map_regions<TriMesh>(face, 1, report, [&](int r, int, Report& part) {
                return triangulate::triangulate(parts[r], {}, part);
              }));
}

Field solved(const TriMesh& mesh) {
  Report report;
  const std::vector<TriMesh> parts = split(mesh);
  return join(mesh, map_regions<Field>(mesh.face, 1, report, [&](int r, int, Report& part) {
                Field field = galerkin::solve_laplace(parts[r], std::vector<int>(parts[r].num_elems(), 6), {}, part);
                field.elem_error = field::error_estimate(field);
                return field;
              }));
}

CriticalPoints nodes_of(const Field& field) {
  Report report;
  const std::vector<Field> parts = split(field);
  return join(field.mesh, map_regions<CriticalPoints>(field.mesh.face, 1, report, [&](int r, int, Report& part) {
                return choice::choose_nodes(parts[r], {}, 1, part);
              }));
}

TEST(Split, a_region_is_a_face_of_its_own) {
  const CadFace whole = disc_in_square();
  const std::vector<CadFace> parts = split(whole);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].loop_offsets, (std::vector<int>{0, 4, 5}));
  EXPECT_EQ(parts[1].loop_offsets, (std::vector<int>{0, 1}));
  EXPECT_TRUE(parts[0].partners.empty()) << "its neighbour is another region";
  EXPECT_NEAR(parts[0].diameter, std::sqrt(32.0), 1e-12);
  EXPECT_NEAR(parts[1].diameter, 2, 1e-12);
  EXPECT_EQ(parts[1].num_regions(), 1);
  EXPECT_EQ(parts[1].unnamed_curves, std::vector<int>{0});
}

TEST(Split, meshes_and_fields_are_those_that_were_joined) {
  const TriMesh mesh = mesh_of(disc_in_square());
  Report report;
  const std::vector<CadFace> faces = split(mesh.face);
  const std::vector<TriMesh> parts = split(mesh);
  const std::vector<Field> fields = split(solved(mesh));
  for (int r = 0; r < 2; ++r) {
    const TriMesh alone = triangulate::triangulate(faces[r], {}, report);
    EXPECT_EQ(parts[r].elem2vertices, alone.elem2vertices);
    EXPECT_EQ(parts[r].vertices, alone.vertices);
    EXPECT_EQ(parts[r].curved_elems, alone.curved_elems);
    EXPECT_EQ(parts[r].curved_nodes, alone.curved_nodes);
    EXPECT_EQ(parts[r].elem_layer, alone.elem_layer);
    ASSERT_EQ(parts[r].boundary_edges.size(), alone.boundary_edges.size());
    EXPECT_EQ(parts[r].boundary_edges.back().elem, alone.boundary_edges.back().elem);
    EXPECT_EQ(parts[r].boundary_edges.back().curve, alone.boundary_edges.back().curve);
    const Field field = galerkin::solve_laplace(alone, std::vector<int>(alone.num_elems(), 6), {}, report);
    EXPECT_EQ(fields[r].u, field.u);
    EXPECT_EQ(fields[r].v, field.v);
    EXPECT_EQ(fields[r].coef_offsets, field.coef_offsets);
  }
}

TEST(Split, all_regions_have_the_alignment) {
  Field whole = solved(mesh_of(disc_in_square()));
  whole.alignment = {{{0.5, 0}, 0.2, 3, 0.1}};
  const std::vector<Field> parts = split(whole);
  for (const Field& part : parts) EXPECT_EQ(part.alignment, whole.alignment);
  EXPECT_EQ(join(whole.mesh, parts).alignment, whole.alignment);
}

TEST(Split, a_history_of_adaptation_returns) {
  const std::vector<Field> starts = split(solved(mesh_of(disc_in_square())));
  Report report;
  std::vector<Field> adapted;
  for (const Field& start : starts) adapted.push_back(adapt::adapt_loop(start, {}, report));
  const Field whole = join(mesh_of(disc_in_square()), adapted);
  const Field again = join(whole.mesh, split(whole));
  ASSERT_EQ(again.adapt_steps.size(), whole.adapt_steps.size());
  for (std::size_t i = 0; i < again.adapt_steps.size(); ++i) {
    EXPECT_EQ(again.adapt_steps[i].elem_order, whole.adapt_steps[i].elem_order);
    EXPECT_EQ(again.adapt_steps[i].num_unknowns, whole.adapt_steps[i].num_unknowns);
    EXPECT_EQ(again.adapt_steps[i].num_raised, whole.adapt_steps[i].num_raised);
  }
  EXPECT_EQ(again.elem_sensor, whole.elem_sensor);
}

TEST(Split, nodes_belong_to_the_region_of_their_position) {
  const Field field = solved(mesh_of(disc_in_square()));
  CriticalPoints points = nodes_of(field);
  EXPECT_EQ(points.critical_points.size(), 8U) << "four in the disc and four about it";
  EXPECT_EQ(points.index_sum, 4);
  EXPECT_EQ(points.index_sum_expected, 4) << "the square with its hole has 0";
  for (CriticalPoint& node : points.critical_points) node.elem = 0;  // as after an edit
  const std::vector<CriticalPoints> parts = split(points, field.mesh);
  EXPECT_EQ(parts[0].critical_points.size(), 4U);
  EXPECT_EQ(parts[1].critical_points.size(), 4U);
  EXPECT_EQ(parts[0].index_sum_expected, 0);
  EXPECT_EQ(parts[1].index_sum_expected, 4);
  EXPECT_EQ(parts[0].corners.size(), 4U);
  points.critical_points[0].position = {5, 5};
  EXPECT_THROW(split(points, field.mesh), FormatError);
}

TEST(Split, a_phase_returns) {
  const TriMesh mesh = mesh_of(disc_in_square());
  const CriticalPoints points = nodes_of(solved(mesh));
  const std::vector<TriMesh> meshes = split(mesh);
  const std::vector<CriticalPoints> nodes = split(points, mesh);
  Report report;
  std::vector<Field> parts;
  for (int r = 0; r < 2; ++r) {
    galerkin::PhaseSolver solver(meshes[r], std::vector<int>(meshes[r].num_elems(), 6), 1);
    parts.push_back(solver.solve(phase_nodes_of(nodes[r]), {}, report));
  }
  const std::vector<Field> again = split(join(mesh, parts));
  for (int r = 0; r < 2; ++r) {
    EXPECT_EQ(again[r].phase.prescribed, parts[r].phase.prescribed);
    EXPECT_EQ(again[r].phase.s, parts[r].phase.s);
    EXPECT_EQ(again[r].phase.hole_winding, parts[r].phase.hole_winding);
  }
}

TEST(RegionWork, reports_by_region_and_names_the_region_of_an_error) {
  const CadFace face = disc_in_square();
  Report report;
  for_each_region(face, 2, report, [](int r, int, Report& part) {
    part.set("solve.size", r + 10);
    part.warn("W-X-001", "large");
  });
  ASSERT_EQ(report.entries().size(), 2U);
  EXPECT_EQ(report.entries()[1].first, "regions.1.solve.size");
  EXPECT_EQ(report.warnings()[0].message, "region region_0: large");
  try {
    for_each_region(face, 1, report, [](int r, int, Report&) {
      if (r == 1) throw ComputeError("no result");
    });
    FAIL();
  } catch (const ComputeError& error) {
    EXPECT_STREQ(error.what(), "region region_1: no result");
  }
}

}  // namespace

}  // namespace quadrille::regions
