#include "outline/assemble_face.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::outline {
namespace {

heal::RawEdge edge(const Nurbs& curve, int cad_edge, const std::string& name = {}) {
  return {curve, curve.poles.front(), curve.poles.back(), cad_edge, name};
}

heal::RawFace polygon(const std::vector<Vec2>& p) {
  heal::RawFace raw;
  raw.file = "f.step";
  raw.wires.emplace_back();
  for (size_t i = 0; i < p.size(); ++i)
    raw.wires[0].push_back(edge(curve::segment(p[i], p[(i + 1) % p.size()]), static_cast<int>(i)));
  return raw;
}

CadFace assembled(const heal::RawFace& raw, double corner_angle = radians(1)) {
  Report report;
  std::vector<Repair> repairs;
  return assemble_face(raw, {corner_angle}, repairs, report);
}

const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST(AssembleFace, turns_clockwise_wires_but_keeps_their_first_edge) {
  const CadFace face = assembled(polygon({{0, 0}, {0, 1}, {1, 1}, {1, 0}}));
  EXPECT_EQ(face.curve_cad_edges, (std::vector<int>{0, 3, 2, 1}));
  EXPECT_EQ(face.joints[0].position, (Vec2{0, 1}));
  for (const Joint& joint : face.joints) EXPECT_NEAR(joint.interior_angle, half_pi, 1e-15);
}

TEST(AssembleFace, puts_the_outline_first_whatever_the_file_does) {
  heal::RawFace raw = polygon(square);
  raw.wires.insert(raw.wires.begin(), {edge(curve::circular_arc({0.5, 0.5}, 0.1, 0, 2 * pi), 4)});
  const CadFace face = assembled(raw);
  EXPECT_EQ(face.loop_offsets, (std::vector<int>{0, 4, 5}));
  EXPECT_LT(curve::curvature(face.curves[4], 1), 0);
}

TEST(AssembleFace, chains_edges_that_come_in_any_sequence) {
  heal::RawFace raw = polygon(square);
  std::swap(raw.wires[0][1], raw.wires[0][3]);
  EXPECT_EQ(assembled(raw).curve_cad_edges, (std::vector<int>{0, 1, 2, 3}));
}

TEST(AssembleFace, closes_gaps_below_the_tolerance_bit_for_bit_and_no_others) {
  heal::RawFace raw = polygon(square);
  raw.wires[0][1] = edge(curve::segment({1 + 1e-8, 1e-8}, {1, 1}), 1);
  const CadFace face = assembled(raw);
  EXPECT_EQ(face.curves[0].poles.back(), face.curves[1].poles.front());
  raw.wires[0][1] = edge(curve::segment({1 + 1e-4, 0}, {1, 1}), 1);
  EXPECT_THROW(assembled(raw), FormatError);
}

TEST(AssembleFace, drops_edges_without_length_with_a_warning) {
  heal::RawFace raw = polygon(square);
  raw.wires[0].insert(raw.wires[0].begin() + 1, edge(curve::segment({1, 0}, {1, 1e-9}), 4));
  Report report;
  std::vector<Repair> repairs;
  EXPECT_EQ(assemble_face(raw, {0.01}, repairs, report).num_curves(), 4);
  ASSERT_EQ(report.warnings().size(), 1U);
  EXPECT_EQ(report.warnings()[0].code, "W-CAD-005");
}

TEST(AssembleFace, knows_angles_close_to_zero_and_to_a_full_turn) {
  const double h = 1e-5;
  const CadFace slit = assembled(polygon({{0, 0}, {2, 0}, {2, 2}, {1 + h, 2}, {1, 1}, {1 - h, 2}, {0, 2}}));
  EXPECT_NEAR(slit.joints[4].interior_angle, 2 * pi - 2 * std::atan(h), 1e-15);
  EXPECT_TRUE(slit.joints[4].is_corner);
  const CadFace spike = assembled(polygon({{0, 0}, {1, -1}, {1, -h}, {3, 0}, {1, h}, {1, 1}}));
  EXPECT_NEAR(spike.joints[3].interior_angle, 2 * std::atan(h / 2), 1e-15);
}

TEST(AssembleFace, knows_cusps) {
  heal::RawFace raw = polygon(square);
  // Interior angle 2 pi: the face goes round the tip (2, 2) of a notch between the edge and a quarter circle.
  raw.wires[0] = {edge(curve::segment({0, 0}, {6, 0}), 0), edge(curve::segment({6, 0}, {6, 2}), 1),
                  edge(curve::segment({6, 2}, {2, 2}), 2), edge(curve::circular_arc({2, 4}, 2, -half_pi, 0), 3),
                  edge(curve::segment({4, 4}, {0, 4}), 4), edge(curve::segment({0, 4}, {0, 0}), 5)};
  const CadFace face = assembled(raw);
  EXPECT_NEAR(face.joints[3].interior_angle, 2 * pi, 1e-6);
  EXPECT_TRUE(face.joints[3].is_corner);
  // Interior angle 0: the notch itself.
  raw.wires[0] = {edge(curve::segment({2, 2}, {6, 2}), 0), edge(curve::segment({6, 2}, {4, 4}), 1),
                  edge(curve::circular_arc({2, 4}, 2, 0, -half_pi), 2)};
  try {
    assembled(raw);
    FAIL();
  } catch (const FormatError& error) {
    EXPECT_NE(std::string(error.what()).find("edges 2 and 0 meet in a cusp at (2, 2), an angle of zero"),
              std::string::npos)
        << error.what();
  }
}

TEST(AssembleFace, small_tangent_jumps_are_kept_but_are_no_corners) {
  const double h = 1e-3;
  const CadFace face = assembled(polygon({{0, 0}, {1, -h}, {2, 0}, {2, 1}, {0, 1}}));
  EXPECT_FALSE(face.joints[1].is_corner);
  EXPECT_NEAR(face.joints[1].interior_angle, pi - 2 * std::atan(h), 1e-15);
  EXPECT_NEAR(face.joints[1].tangent_out - face.joints[1].tangent_in, 2 * std::atan(h), 1e-15);
}

TEST(AssembleFace, default_names_avoid_those_of_the_file) {
  heal::RawFace raw = polygon(square);
  raw.wires[0][3].name = "curve_1";
  const CadFace face = assembled(raw);
  EXPECT_EQ(face.curve_names, (std::vector<std::string>{"curve_0", "curve_1_", "curve_2", "curve_1"}));
  EXPECT_EQ(face.unnamed_curves, (std::vector<int>{0, 1, 2}));
  EXPECT_TRUE(face.has_given_name(3));
}

TEST(AssembleFace, is_the_same_at_any_scale) {
  for (const double scale : {1e-9, 1.0, 1e9}) {
    std::vector<Vec2> p = square;
    for (Vec2& x : p) x *= scale;
    heal::RawFace raw = polygon(p);
    raw.tolerance = 1e-7;
    const CadFace face = assembled(raw);
    EXPECT_EQ(face.num_curves(), 4);
    EXPECT_NEAR(face.diameter / scale, std::sqrt(2.0), 1e-15);
  }
}

// A plate of 4 x 3 with a hole from its lower to its upper edge: two pieces, the right one larger.
heal::RawFace pinched_plate() {
  heal::RawFace raw = polygon({{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  const heal::RawFace hole = polygon({{1.5, 0}, {2, 1}, {1.5, 3}, {1, 1}});
  raw.wires.push_back(hole.wires[0]);
  for (heal::RawEdge& e : raw.wires[1]) e.cad_edge += 4;
  return raw;
}

TEST(AssembleFace, chooses_a_piece_of_a_face_that_touches_itself) {
  Report report;
  std::vector<Repair> repairs;
  const auto piece = [&](int number) {
    return assemble_face(pinched_plate(), {radians(1), 0, {"cover", number}}, repairs, report);
  };
  EXPECT_EQ(piece(0).curve_cad_edges, (std::vector<int>{0, 1, 2, 5, 4}));
  EXPECT_EQ(piece(1).curve_cad_edges, (std::vector<int>{0, 7, 6, 2, 3}));
  for (const int number : {-1, 2})
    EXPECT_EQ(message_of<FormatError>([&] { piece(number); }),
              "f.step: the boundary of the face touches itself, with no width in between, at (1.5, 0), and separates 2 "
              "pieces: choose one with --face cover.0 to cover.1, the largest first");
  EXPECT_EQ(message_of<FormatError>([&] {
              assemble_face(polygon(square), {radians(1), 0, {"cover", 1}}, repairs, report);
            }),
            "f.step: --face cover.1: the face has one piece, number 0");
}

TEST(AssembleFace, refuses_contacts_with_place_size_and_remedy) {
  EXPECT_EQ(
      message_of<FormatError>([] {
        assembled(polygon({{0, 0}, {4, 0}, {4, 2}, {3, -0.5}, {1, 4}, {0, 4}}));
      }),
      "f.step: the wire intersects itself: edges 0 and 3 of the outline at (2.77778, 0), 0.547 (0.097 diameters) from "
      "the nearest of their ends: trim them, or draw them apart");
  heal::RawFace corner = polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  corner.wires.push_back(polygon({{2, 0}, {1, 2}, {3, 2}}).wires[0]);
  for (heal::RawEdge& e : corner.wires[1]) e.cad_edge += 4;
  const std::string message = message_of<FormatError>([&] { assembled(corner); });
  EXPECT_EQ(message,
            "f.step: the boundary touches itself at (2, 0), where edges 0 and 4 meet: the face has a width of zero "
            "there: give --blunt 0.0056 to cut the corners off at that width, or draw them apart");
  Report report;
  std::vector<Repair> repairs;
  EXPECT_EQ(assemble_face(corner, {radians(1), 0.0056}, repairs, report).num_curves(), 10);
  EXPECT_EQ(repairs.size(), 2U);
}

TEST(AssembleFace, refuses_coordinates_that_are_not_numbers) {
  heal::RawFace raw = polygon(square);
  raw.wires[0][2].curve.poles[0].x = std::nan("");
  EXPECT_THROW(assembled(raw), FormatError);
}

}  // namespace
}  // namespace quadrille::outline
