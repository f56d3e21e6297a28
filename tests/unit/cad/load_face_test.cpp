#include "cad/load_face.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support/test_data.hpp"
#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/chain.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::cad {

namespace {

struct Loaded {
  CadFace face;
  Report report;
  double area() const {
    for (const auto& [key, value] : report.entries())
      if (key == "face.area") return std::get<double>(value);
    return -1;
  }
  double perimeter() const {
    double sum = 0;
    for (const Nurbs& curve : face.curves) sum += curve::ArcLength(curve).total();
    return sum;
  }
};

Loaded load(const std::string& file, double corner_angle = radians(1)) {
  Loaded l;
  l.face = load_face_guarded(test_bytes(file), file, LoadOptions{corner_angle}, l.report).face;
  return l;
}

std::string refusal(const std::string& file) {
  return message_of<FormatError>([&] { load(file); });
}

void expect_refused(const std::string& file, const std::string& reason) {
  const std::string message = refusal(file);
  EXPECT_NE(message.find(reason), std::string::npos) << file << ": " << message;
  EXPECT_EQ(message.find(file), 0U) << message;
}

// What every face promises to the later stages.
void expect_consistent(const CadFace& face) {
  ASSERT_EQ(face.curves.size(), face.joints.size());
  ASSERT_EQ(face.curves.size(), face.curve_names.size());
  ASSERT_EQ(face.curves.size(), face.curve_cad_edges.size());
  ASSERT_EQ(face.loop_offsets.back(), face.num_curves());
  for (int i = 0; i < face.num_curves(); ++i) {
    const Nurbs& curve = face.curves[i];
    EXPECT_EQ(curve.knots.size(), curve.poles.size() + curve.degree + 1);
    EXPECT_EQ(curve.poles.back(), face.curves[face.next_in_loop(i)].poles.front());
    EXPECT_EQ(face.joints[i].position, curve.poles.front());
    EXPECT_NEAR(wrap_pi(face.joints[i].tangent_out - angle_of(curve::tangent(curve, curve.begin()))), 0, 1e-15);
  }
  // Turning: 2 pi around the outline, -2 pi around a hole.
  for (int l = 0; l < face.num_loops(); ++l) {
    double turning = 0;
    for (int i = face.loop_offsets[l]; i < face.loop_offsets[l + 1]; ++i) {
      turning += pi - face.joints[i].interior_angle;
      const Nurbs& curve = face.curves[i];
      for (int k = 0; k < 1000; ++k) {
        const double span = (curve.end() - curve.begin()) / 1000, t = curve.begin() + k * span;
        const Vec2 a = curve::tangent(curve, t), b = curve::tangent(curve, t + span, true);
        turning += std::atan2(cross(a, b), dot(a, b));
      }
    }
    EXPECT_NEAR(turning, l == 0 ? 2 * pi : -2 * pi, 1e-7);
  }
}

TEST(LoadFace, half_disc) {
  const Loaded l = load("half_disc.step");
  const CadFace& face = l.face;
  expect_consistent(face);
  ASSERT_EQ(face.num_curves(), 2);
  EXPECT_NEAR(l.area(), pi / 2, 1e-14);
  EXPECT_NEAR(l.perimeter(), pi + 2, 1e-14);
  EXPECT_EQ(face.diameter, 2);
  EXPECT_EQ(face.length_unit, "millimetre");
  EXPECT_EQ(face.metres_per_unit, 0.001);
  EXPECT_EQ(face.origin, (Vec2{0, 0}));
  EXPECT_EQ(face.curve_names, (std::vector<std::string>{"curve_0", "curve_1"}));
  for (const Joint& joint : face.joints) {
    EXPECT_TRUE(joint.is_corner);
    EXPECT_NEAR(joint.interior_angle, half_pi, 1e-14);
  }
  EXPECT_EQ(face.curves[1].poles.size(), 5U) << "two pieces of 90 degrees";
  EXPECT_TRUE(l.report.warnings().empty());
}

TEST(LoadFace, a_hole_is_walked_clockwise_and_its_seam_is_smooth) {
  const Loaded l = load("annulus.step");
  expect_consistent(l.face);
  ASSERT_EQ(l.face.num_loops(), 2);
  EXPECT_EQ(l.face.euler_characteristic(), 0);
  EXPECT_LT(curve::curvature(l.face.curves[1], 1), 0);
  for (const Joint& joint : l.face.joints) {
    EXPECT_EQ(joint.interior_angle, pi);
    EXPECT_FALSE(joint.is_corner);
  }
}

TEST(LoadFace, smooth_junctions_of_edges_are_no_corners) {
  const CadFace face = load("stadium.step").face;
  expect_consistent(face);
  ASSERT_EQ(face.num_curves(), 4);
  for (const Joint& joint : face.joints) EXPECT_EQ(joint.interior_angle, pi);
}

TEST(LoadFace, the_corner_angle_decides_what_a_corner_is) {
  const CadFace face = load("l_shape.step", radians(100)).face;
  for (const Joint& joint : face.joints) {
    EXPECT_FALSE(joint.is_corner);
    EXPECT_NEAR(std::abs(pi - joint.interior_angle), half_pi, 1e-14);
  }
}

TEST(LoadFace, every_shipped_shape_is_consistent) {
  for (const char* name : {"annulus", "cylinder_channel", "eccentric_annulus", "geometry_1", "half_disc", "l_shape",
                           "plate_hole", "quarter_annulus", "s_bend", "square", "stadium"}) {
    SCOPED_TRACE(name);
    expect_consistent(load(std::string(name) + ".step").face);
  }
}

TEST(LoadFace, numbers_are_those_of_the_file_whatever_its_unit) {
  const Loaded inches = load("bad/inches.step");
  expect_consistent(inches.face);
  EXPECT_EQ(inches.face.length_unit, "inch");
  EXPECT_NEAR(inches.face.metres_per_unit, 0.0254, 1e-17);
  EXPECT_EQ(inches.face.joints[2].position, (Vec2{2.1, 0.7}));
  EXPECT_NEAR(inches.area(), 2.1 * 0.7 - pi * 0.01, 1e-14);
  const Loaded metres = load("bad/metres.step");
  EXPECT_EQ(metres.face.length_unit, "metre");
  EXPECT_EQ(metres.face.metres_per_unit, 1);
  EXPECT_EQ(metres.face.joints[2].position, (Vec2{2, 1}));
  const Loaded brep = load("bad/rectangle.brep");
  EXPECT_EQ(brep.face.length_unit, "unknown");
  EXPECT_EQ(brep.face.metres_per_unit, 0);
  EXPECT_NEAR(brep.area(), 2, 1e-15);
}

TEST(LoadFace, iges_is_read_in_its_own_unit) {
  // A half disc of radius 1 millimetre, written in inches.
  const Loaded l = load("bad/half_disc_inches.iges");
  expect_consistent(l.face);
  EXPECT_EQ(l.face.length_unit, "inch");
  EXPECT_NEAR(l.face.metres_per_unit, 0.0254, 1e-17);
  EXPECT_NEAR(l.face.diameter, 2 / 25.4, 1e-11);
  EXPECT_NEAR(l.area(), pi / 2 / 25.4 / 25.4, 1e-12);
  EXPECT_EQ(l.face.num_curves(), 2);
  const std::string bytes = test_bytes("bad/half_disc_inches.iges");
  Report report;
  EXPECT_THROW(load_face_guarded(bytes.substr(0, 810), "a.iges", {}, report), FormatError);
}

TEST(LoadFace, any_plane_and_its_frame) {
  const CadFace tilted = load("bad/tilted.step").face;
  expect_consistent(tilted);
  const Vec2 far = tilted.joints[2].position;
  const std::array<double, 3> expected{3, 2.8, 3.6};
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(tilted.plane_origin[k] + far.x * tilted.plane_x[k] + far.y * tilted.plane_y[k], expected[k], 1e-14);

  const CadFace upright = load("bad/upright.step").face;
  EXPECT_EQ(upright.plane_origin, (std::array<double, 3>{4, 0, 0}));
  EXPECT_EQ(upright.plane_x, (std::array<double, 3>{0, 1, 0}));
  EXPECT_EQ(upright.plane_y, (std::array<double, 3>{0, 0, 1}));

  const Loaded down = load("bad/downwards.step");
  expect_consistent(down.face);
  EXPECT_EQ(down.face.plane_origin, (std::array<double, 3>{0, 0, -5}));
  EXPECT_EQ(down.face.plane_x, (std::array<double, 3>{1, 0, 0}));
  EXPECT_EQ(down.face.plane_y, (std::array<double, 3>{0, 1, 0}));
  EXPECT_NEAR(down.area(), 2, 1e-15);
}

TEST(LoadFace, far_from_the_origin_positions_are_relative) {
  const Loaded l = load("bad/far_away.step");
  expect_consistent(l.face);
  EXPECT_NEAR(l.face.diameter, std::sqrt(5.0), 1e-15);
  EXPECT_EQ(l.face.joints[0].position + l.face.origin, (Vec2{1e6, 2e6}));
  EXPECT_LT(norm(l.face.joints[0].position), 10);
}

TEST(LoadFace, names_come_from_the_file_and_may_be_shared) {
  const CadFace face = load("bad/names.step").face;
  EXPECT_EQ(face.name, "channel");
  EXPECT_EQ(face.curve_names, (std::vector<std::string>{"wall", "outlet", "wall", "inlet", "cylinder"}));
  EXPECT_EQ(face.curve_cad_edges, (std::vector<int>{0, 1, 2, 3, 4}));
}

// The file with `from` replaced by `to` wherever it stands.
CadFace load_changed(const std::string& file, const std::string& from, const std::string& to) {
  std::string bytes = test_bytes(file);
  if (bytes.find(from) == std::string::npos) throw std::runtime_error("no " + from + " in " + file);
  for (size_t at = 0; (at = bytes.find(from, at)) != std::string::npos; at += to.size())
    bytes.replace(at, from.size(), to);
  Report report;
  return load_face_guarded(bytes, file, LoadOptions{radians(1)}, report).face;
}

TEST(LoadFace, layers_and_colours_name_edges_without_name) {
  const CadFace face = load("labels.step").face;
  EXPECT_EQ(face.curve_names,
            (std::vector<std::string>{"Zuflu\xC3\x9F", "outlet", "walls", "colour_ff8000", "colour_0000ff"}));
  EXPECT_EQ(face.name, "") << "its layer holds an edge too";
  const CadFace apart = load_changed("labels.step", "'part','',(#46,#38)", "'part','',(#46)");
  EXPECT_EQ(apart.name, "part");
  const CadFace plain = load_changed("labels.step", "(#8,#19)", "(#9)");
  EXPECT_EQ(plain.curve_names[2], "curve_2") << "off its layer";
}

TEST(LoadFace, layers_and_colours_that_refer_to_nothing_of_use_are_passed_over) {
  const auto names = load("labels.step").face.curve_names;
  for (const char* reference : {"#999", "$", "#1", "#52"})
    EXPECT_EQ(load_changed("labels.step", ",#38,#68)", std::string(",#38,") + reference + ")").curve_names, names)
        << reference;
  for (const auto& [from, to] : {std::pair{"(#50)", "(#999)"},
                                 {"(#50)", "($)"},
                                 {"(#50)", "()"},
                                 {"(#50)", "$"},
                                 {"(#51),#15", "$,#15"},
                                 {"'walls'", "$"},
                                 {"(#8,#19)", "$"},
                                 {"(#8,#19)", "(#999,#1)"}})
    EXPECT_EQ(load_changed("labels.step", from, to).num_curves(), 5) << from << " -> " << to;
}

TEST(LoadFace, names_levels_and_colours_of_iges) {
  const CadFace face = load("labels.iges").face;
  EXPECT_EQ(face.curve_names,
            (std::vector<std::string>{"the wall", "level_5", "colour_ff0000", "curve_3", "colour_ff8000"}));
  EXPECT_EQ(face.name, "") << "its level is that of an edge too";
  // With a level of its own the face is called by it, and edges by what was that of the part.
  const CadFace apart = load_changed("labels.iges", "       1       0       0       000000000D",
                                     "       3       0       0       000000000D");
  EXPECT_EQ(apart.name, "level_3");
  EXPECT_EQ(apart.curve_names[3], "level_1");
}

TEST(LoadFace, names_in_the_encodings_of_step_become_utf8) {
  const auto decoded = [](const std::string& name) {
    return load_changed("bad/names.step", "'inlet'", "'" + name + "'").curve_names[3];
  };
  EXPECT_EQ(decoded("W\\X2\\00E4\\X0\\nde"), "W\xC3\xA4nde");
  EXPECT_EQ(decoded("W\\X\\E4nde"), "W\xC3\xA4nde");
  EXPECT_EQ(decoded("\\X4\\0001F600\\X0\\"), "\xF0\x9F\x98\x80");
  EXPECT_EQ(decoded("W\xC3\xA4nde"), "W\xC3\xA4nde") << "UTF-8 as it is, against the standard but common";
  EXPECT_EQ(decoded("W\xE4nde"), "W\xC3\xA4nde") << "Latin 1, likewise";
  EXPECT_EQ(decoded("it''s"), "it's");
  EXPECT_EQ(decoded("two\\X\\0Alines"), "two lines");
  EXPECT_EQ(decoded(" \\X\\09 "), "curve_3");
  EXPECT_EQ(decoded("NONE"), "curve_3");
}

TEST(LoadFace, pieces_of_a_split_edge_keep_its_name) {
  const CadFace face = load_changed("bad/kinked_spline.step", "EDGE_CURVE('',", "EDGE_CURVE('hull',");
  ASSERT_GT(face.num_curves(), *std::max_element(face.curve_cad_edges.begin(), face.curve_cad_edges.end()) + 1);
  for (const std::string& name : face.curve_names) EXPECT_EQ(name, "hull");
}

TEST(LoadFace, curves_are_exact) {
  const Loaded arc = load("bad/ellipse_arc.step");
  expect_consistent(arc.face);
  for (int i = 0; i <= 50; ++i) {
    const Nurbs& ellipse = arc.face.curves[0];
    const Vec2 x = curve::point(ellipse, ellipse.begin() + (ellipse.end() - ellipse.begin()) * i / 50);
    EXPECT_NEAR(x.x * x.x / 4 + x.y * x.y, 1, 1e-14);
  }
  EXPECT_NEAR(load("bad/bezier.step").area(), 1.0 / 3, 1e-15);
  const Loaded half = load("bad/against_the_curve.step");
  expect_consistent(half.face);
  EXPECT_NEAR(half.area(), pi / 2, 1e-14);
}

TEST(LoadFace, periodic_splines_may_begin_anywhere_and_run_across_their_seam) {
  const Loaded whole = load("bad/periodic_spline.brep"), pieces = load("bad/periodic_pieces.brep");
  expect_consistent(whole.face);
  expect_consistent(pieces.face);
  ASSERT_EQ(whole.face.num_curves(), 1);
  ASSERT_EQ(pieces.face.num_curves(), 2);
  EXPECT_EQ(whole.face.joints[0].interior_angle, pi);
  EXPECT_EQ(pieces.face.joints[1].interior_angle, pi);
  EXPECT_NEAR(whole.area(), 6.348241559181, 1e-11) << "from the extrapolated areas of inscribed polygons";
  EXPECT_NEAR(pieces.area(), whole.area(), 1e-13);
  EXPECT_NEAR(pieces.perimeter(), whole.perimeter(), 1e-12);
}

TEST(LoadFace, other_curves_are_converted) {
  EXPECT_NEAR(load("bad/parabola.brep").area(), 8.0 / 3, 1e-14);
  // Offset of the parabola (u^2 / 4, u) by 1/2 to its right, approximated to a hundredth of the tolerance.
  const CadFace face = load("bad/offset.brep").face;
  expect_consistent(face);
  for (int i = 1; i < 50; ++i) {
    const Vec2 x =
        curve::point(face.curves[0], face.curves[0].begin() + i * (face.curves[0].end() - face.curves[0].begin()) / 50);
    // The nearest point of the parabola: u^3 / 8 + u (1 - x / 2) - y = 0.
    double u = x.y;
    for (int k = 0; k < 50; ++k) u -= (u * u * u / 8 + u * (1 - x.x / 2) - x.y) / (3 * u * u / 8 + 1 - x.x / 2);
    EXPECT_NEAR(distance(x, {u * u / 4, u}), 0.5, 2e-9);
  }
}

TEST(LoadFace, curves_are_split_at_inner_kinks) {
  const CadFace kinked = load("bad/kinked_spline.step").face;
  expect_consistent(kinked);
  EXPECT_EQ(kinked.curve_cad_edges, (std::vector<int>{0, 0, 1}));
  EXPECT_EQ(kinked.joints[1].position, (Vec2{1, 0.8}));
  const Loaded closed = load("bad/closed_spline.step");
  expect_consistent(closed.face);
  EXPECT_EQ(closed.face.curve_cad_edges, (std::vector<int>{0, 0}));
  EXPECT_NEAR(closed.area(), 3, 1e-14);
}

TEST(LoadFace, construction_geometry_is_ignored_with_warnings) {
  const Loaded l = load("bad/construction.step");
  EXPECT_EQ(l.face.num_curves(), 4);
  ASSERT_EQ(l.report.warnings().size(), 2U);
  EXPECT_EQ(l.report.warnings()[0].code, "W-CAD-001");
  EXPECT_EQ(l.report.warnings()[1].code, "W-CAD-002");
}

TEST(LoadFace, refuses_what_is_no_cad_file) {
  expect_refused("bad/empty.step", "the file is empty");
  expect_refused("bad/truncated.step", "truncated");
  expect_refused("bad/garbage.step", "not a CAD file");
  expect_refused("bad/garbage.txt", "not a CAD file");
  expect_refused("bad/wrong_extension.iges", "the extension .iges says IGES, the content is STEP");
  expect_refused("bad/wrong_extension.txt", "wrong extension .txt");
}

TEST(LoadFace, survives_files_on_which_the_kernel_crashes) {
  expect_refused("bad/unknown_entity.step", "malformed: #4 LINE refers to #1, which is of type CARTESIAN_PIONT");
  expect_refused("bad/unknown_point.step", "malformed: #4 LINE refers to #1, which is of type CARTESIAN_PIONT");
  expect_refused("bad/points_are_directions.step", "which is of type DIRECTION, not CARTESIAN_POINT");
  expect_refused("bad/broken_reference.step", "names 4 edges of the face, of which 3 can be built");
}

TEST(LoadFace, refuses_what_is_not_one_planar_face) {
  expect_refused("bad/solid.step", "a solid");
  expect_refused("bad/sphere.step", "not planar (a sphere): cad2chart --face 0");
  expect_refused("bad/two_faces.step", "several faces (2)");
  expect_refused("regions/bad/two_planes.step", "several faces (2) that are not in one plane");
  expect_refused("bad/mixed_units.step", "mixes length units (inch and millimetre)");
}

TEST(LoadFace, refuses_bad_wires_and_says_where) {
  expect_refused("bad/open_wire.step", "the wire is open: it begins at (0, 0) and ends at (0, 1)");
  expect_refused("bad/self_intersecting.step", "the wire intersects itself: edges 3 and 1 of the outline at (0.952");
  expect_refused("bad/self_intersecting_curve.step", "intersects itself: edge 0 of the outline at (1, 0.857143)");
  expect_refused("bad/zero_area.step", "no area");
  expect_refused("bad/swapped_coordinates.step", "edge 1: its vertex at (1, 2) lies 1 off its curve");
}

TEST(LoadFace, refuses_holes_out_of_place) {
  expect_refused("bad/hole_outside.step", "hole 1 at (3, 0) lies outside the outline");
  expect_refused("bad/hole_across.step", "hole 1 crosses or touches the outline");
  expect_refused("bad/hole_touching.step",
                 "the boundary touches itself at (2, 0.5), where edges 1 and 6 meet: the face has a width of zero");
  expect_refused("bad/hole_in_hole.step", "hole 2 at (3, 3) lies inside hole 1");
}

FaceList two_faces() {
  FaceList list;
  list.length_unit = "inch";
  list.faces = {{{"lid", "plane", 10, {1, 1e-16, 3}},
                 "rig/box",
                 "steel",
                 {{"", "line", 2.5, {0.125, 0, 3}}, {"rim", "circle", 7.5, {4, 0, 3}}}},
                {{"", "cylinder", 100.0 / 3, {0, 0, 0}}, "", "wet", {}}};
  return list;
}

TEST(FaceTable, has_a_line_for_each_face_and_each_edge_in_columns) {
  EXPECT_EQ(face_table(two_faces()),
            "face  edge  kind      length   place          name  part     layer\n"
            "0           plane     10       (1, 0, 3)      lid   rig/box  steel\n"
            "      0     line      2.5      (0.125, 0, 3)\n"
            "      1     circle    7.5      (4, 0, 3)      rim\n"
            "1           cylinder  33.3333  (0, 0, 0)                     wet\n");
}

TEST(FaceTable, the_report_has_the_same_with_all_digits) {
  Report report;
  report_faces(two_faces(), report);
  const auto value = [&](const std::string& key) {
    const auto found = std::find_if(report.entries().begin(), report.entries().end(),
                                    [&](const auto& entry) { return entry.first == key; });
    return found == report.entries().end() ? Report::Value("none") : found->second;
  };
  EXPECT_EQ(std::get<long long>(value("list.faces")), 2);
  EXPECT_EQ(std::get<long long>(value("list.face.0.edges")), 2);
  EXPECT_EQ(std::get<std::string>(value("list.face.0.edge.1.name")), "rim");
  EXPECT_EQ(std::get<std::string>(value("list.face.0.part")), "rig/box");
  EXPECT_EQ(std::get<std::string>(value("list.face.1.layer")), "wet");
  EXPECT_EQ(std::get<double>(value("list.face.1.length")), 100.0 / 3);
  EXPECT_EQ(std::get<std::vector<double>>(value("list.face.0.place")), (std::vector<double>{1, 1e-16, 3}));
}

TEST(FaceTable, faces_that_could_not_be_built_are_named_in_a_warning) {
  FaceList list = two_faces();
  Report complete, incomplete;
  report_faces(list, complete);
  EXPECT_TRUE(complete.warnings().empty());
  list.not_built = {"#40 'lid'", "#52"};
  report_faces(list, incomplete);
  ASSERT_EQ(incomplete.warnings().size(), 1U);
  EXPECT_EQ(incomplete.warnings()[0].code, "W-CAD-007");
  EXPECT_EQ(
      incomplete.warnings()[0].message,
      "2 faces are not listed, because the CAD kernel could not build them: #40 'lid', #52: repair or export them "
      "again");
  Report long_list;
  list.not_built.assign(23, "#7");
  report_faces(list, long_list);
  EXPECT_NE(long_list.warnings()[0].message.find("#7 and 3 more: repair"), std::string::npos);
}

}  // namespace

}  // namespace quadrille::cad
