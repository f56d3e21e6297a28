#include "occ/occ_triangles.hpp"

#include <gtest/gtest.h>

#include <BRepTools.hxx>
#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "../support/test_data.hpp"
#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/vec3.hpp"
#include "cad/load_face.hpp"
#include "cad/loaded_face.hpp"
#include "occ/occ_model.hpp"
#include "occ/read_face.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::occ {

namespace {

SpaceFace read(const std::string& file, const std::string& face, Report& report) {
  cad::LoadOptions options;
  options.face = face;
  return read_space_face(step_format(), test_bytes("curved/" + file), file, options, report);
}

SpaceFace read(const std::string& file, const std::string& face = "0") {
  Report report;
  return read(file, face, report);
}

double size_of(const SpaceFace& face) {
  double size = 0;
  for (const Vec3& v : face.vertices) size = std::max(size, distance(v, face.vertices.front()));
  return size;
}

void expect_curves_meet(const SpaceFace& face) {
  for (int l = 0; l + 1 < static_cast<int>(face.face.loop_offsets.size()); ++l) {
    const int begin = face.face.loop_offsets[l], end = face.face.loop_offsets[l + 1];
    for (int i = begin; i < end; ++i)
      EXPECT_EQ(face.curves[i].poles.back(), face.curves[i + 1 < end ? i + 1 : begin].poles.front());
  }
}

// The edges of the triangles cover each curve, from its start to its end, with the face on the left.
void expect_boundary_covers_curves(const SpaceFace& face) {
  std::set<std::pair<int, int>> sides;
  for (const auto& t : face.triangles)
    for (int k = 0; k < 3; ++k) sides.insert({t[k], t[(k + 1) % 3]});
  int curve = -1;
  double t = 0;
  for (const FineBoundaryEdge& e : face.boundary_edges) {
    if (e.curve != curve) {
      if (curve >= 0) {
        EXPECT_EQ(t, face.curves[curve].end());
      }
      ASSERT_EQ(e.curve, curve + 1);
      curve = e.curve, t = face.curves[curve].begin();
    }
    EXPECT_EQ(e.t0, t);
    EXPECT_LT(e.t0, e.t1);
    t = e.t1;
    EXPECT_TRUE(sides.contains({e.vertices[0], e.vertices[1]}));
    EXPECT_FALSE(sides.contains({e.vertices[1], e.vertices[0]}));
    for (const auto& [at, v] : {std::pair{e.t0, e.vertices[0]}, std::pair{e.t1, e.vertices[1]}})
      EXPECT_LT(distance(surface::point(face.curves[curve], at), face.vertices[v]), 2e-6 * size_of(face));
  }
  EXPECT_EQ(curve + 1, static_cast<int>(face.curves.size()));
  EXPECT_EQ(t, face.curves.back().end());
}

double area(const SpaceFace& face) {
  double sum = 0;
  for (const auto& t : face.triangles)
    sum += norm(cross(face.vertices[t[1]] - face.vertices[t[0]], face.vertices[t[2]] - face.vertices[t[0]])) / 2;
  return sum;
}

// With vertices on the surface and, as a whole, counter-clockwise against the normal: slivers may be turned over.
void expect_triangles_on_surface(const SpaceFace& face) {
  double area_along_normal = 0;
  for (std::size_t i = 0; i < face.triangles.size(); ++i) {
    std::array<Vec3, 3> x{};
    Vec2 middle{};
    for (int k = 0; k < 3; ++k) {
      x[k] = face.vertices[face.triangles[i][k]], middle += face.triangle_uv[i][k] / 3.0;
      EXPECT_LT(distance(surface::point(face.surface, face.triangle_uv[i][k]), x[k]), 1e-6 * size_of(face));
    }
    const auto p = surface::evaluate(face.surface, middle);
    area_along_normal +=
        (face.is_reversed ? -0.5 : 0.5) * dot(normalized(cross(p.xu, p.xv)), cross(x[1] - x[0], x[2] - x[0]));
  }
  EXPECT_GT(area_along_normal, 0.9 * area(face));
}

void expect_valid(const SpaceFace& face) {
  expect_curves_meet(face);
  expect_boundary_covers_curves(face);
  expect_triangles_on_surface(face);
}

TEST(ReadSpaceFace, a_half_cylinder_of_a_solid) {
  Report report;
  const SpaceFace face = read("half_cylinder.step", "0", report);
  expect_valid(face);
  EXPECT_EQ(face.face.loop_offsets, (std::vector<int>{0, 4}));
  EXPECT_NEAR(area(face), 2 * pi, 0.02);
  EXPECT_EQ(face.face.curve_names[2], "curve_2");
  EXPECT_EQ(face.face.unnamed_curves.size(), 4U);
  EXPECT_EQ(face.face.length_unit, "millimetre");
  EXPECT_EQ(face.surface.degree_u, 2);
  EXPECT_TRUE(report.warnings().empty());
}

TEST(ReadSpaceFace, seams_and_poles_disappear) {
  const SpaceFace tube = read("tube.step"), cap = read("sphere_cap.step"), cone = read("cone_tip.step");
  for (const SpaceFace* face : {&tube, &cap, &cone}) expect_valid(*face);
  EXPECT_EQ(tube.face.loop_offsets, (std::vector<int>{0, 1, 2}));
  EXPECT_TRUE(tube.surface.is_closed_u);
  EXPECT_EQ(cap.face.loop_offsets, (std::vector<int>{0, 1}));
  EXPECT_NEAR(area(cap), 2 * pi * 0.4, 0.01);
  EXPECT_EQ(cone.face.loop_offsets, (std::vector<int>{0, 3}));
}

TEST(ReadSpaceFace, holes_come_after_the_longest_loop) {
  const SpaceFace torus = read("torus_patch.step"), hills = read("hills_hole.step");
  expect_valid(torus), expect_valid(hills);
  EXPECT_EQ(torus.face.num_loops(), 2);
  EXPECT_EQ(torus.face.loop_offsets[1], 4);
  EXPECT_EQ(hills.face.loop_offsets[1], 4);
}

TEST(ReadSpaceFace, faces_of_a_solid_have_their_normal_outside) {
  for (int number = 0; number < 26; ++number) {
    const SpaceFace face = read("filleted_box.step", std::to_string(number));
    expect_valid(face);
    const auto p = surface::evaluate(face.surface, face.triangle_uv.front()[0]);
    Vec3 middle{};
    for (const Vec3& v : face.vertices) middle += v / static_cast<double>(face.vertices.size());
    const Vec3 normal = (face.is_reversed ? -1.0 : 1.0) * cross(p.xu, p.xv);
    EXPECT_GT(dot(normal, middle - Vec3{0.7, 0.7, 0.7}), 0) << number;
  }
}

std::string brep_of(const std::string& file) {
  std::ostringstream stream;
  BRepTools::Write(occ_load(step_format(), test_bytes(file), file).shape, stream);
  return stream.str();
}

void expect_same_face(const SpaceFace& face, const SpaceFace& expected) {
  expect_valid(face);
  EXPECT_EQ(face.face.loop_offsets, expected.face.loop_offsets);
  EXPECT_EQ(face.curve_faces, expected.curve_faces);
  ASSERT_EQ(face.inner_curves.size(), expected.inner_curves.size());
  for (std::size_t i = 0; i < face.inner_curves.size(); ++i)
    EXPECT_EQ(face.inner_curves[i].faces, expected.inner_curves[i].faces);
  EXPECT_NEAR(area(face), area(expected), 0.01 * area(expected));
}

TEST(ReadSpaceFace, regions_of_brep_are_those_of_step) {
  for (const std::string shape : {"spline", "window", "halves"}) {
    SCOPED_TRACE(shape);
    const std::string file = "curved_regions/" + shape + ".step";
    Report report;
    cad::LoadOptions options;
    options.face = "0,1";
    const SpaceFace step = read_space_face(step_format(), test_bytes(file), file, options, report);
    expect_same_face(read_space_face(brep_format(), brep_of(file), "a.brep", options, report), step);
  }
}

// Trimmed surfaces of IGES share no vertices and no edges, not even the two sides of a seam.
TEST(ReadSpaceFace, seams_and_regions_of_iges_are_those_of_step) {
  for (const auto& [name, step] : std::vector<std::pair<std::string, std::string>>{
           {"curved/tube", "curved/tube"},
           {"curved/half_sphere", "curved/half_sphere"},
           {"curved/halves", "curved_regions/halves"},
       }) {
    SCOPED_TRACE(name);
    Report report;
    const auto face_of = [&](const std::string& file) {
      return cad::load_space_face_guarded(test_bytes(file), file, {}, report);
    };
    const SpaceFace face = face_of(name + ".iges"), expected = face_of(step + ".step");
    expect_valid(face);
    EXPECT_EQ(face.face.loop_offsets, expected.face.loop_offsets);
    EXPECT_EQ(face.inner_curves.size(), expected.inner_curves.size());
    EXPECT_NEAR(area(face), area(expected), 0.01 * area(expected));
  }
}

TEST(ReadSpaceFace, closed_faces_are_refused) {
  expect_contains(message_of<FormatError>([] { read("sphere.step"); }), "sphere.step: face 0: the face is closed");
}

}  // namespace

}  // namespace quadrille::occ
