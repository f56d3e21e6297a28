// Cracks, and faces of one surface, as they are read from files (occ_united_face.cpp and its neighbours).

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "../support/test_data.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"
#include "occ/read_face.hpp"

namespace quadrille::occ {
namespace {

SpaceFace read(const std::string& shape, const std::string& face = "") {
  Report report;
  cad::LoadOptions options;
  options.face = face;
  return read_space_face(step_format(), test_bytes("curved_regions/" + shape + ".step"), shape, options, report);
}

using Faces = std::array<int, 2>;

TEST(UnitedFace, an_edge_that_the_face_has_twice_is_an_inner_curve) {
  for (const char* shape : {"crack", "crack_on_seam", "crack_from_rim", "tube_crack"}) {
    const SpaceFace face = read(shape);
    ASSERT_EQ(face.inner_curves.size(), 1U) << shape;
    EXPECT_EQ(face.inner_curves[0].name, "crack");
    EXPECT_EQ(face.inner_curves[0].faces, (Faces{0, 0}));
  }
  EXPECT_EQ(read("tube_crack").face.loop_offsets, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(read("crack_from_rim").face.loop_offsets, (std::vector<int>{0, 5}));
}

TEST(UnitedFace, faces_of_one_surface_have_their_common_edges_inside) {
  for (const char* shape : {"halves", "halves_own", "halves_turned"}) {
    const SpaceFace face = read(shape);
    EXPECT_EQ(face.face_names, (std::vector<std::string>{"front", "back"})) << shape;
    ASSERT_EQ(face.inner_curves.size(), 2U) << shape;
    for (const InnerSpaceCurve& curve : face.inner_curves) EXPECT_EQ(curve.faces[0] + curve.faces[1], 1) << shape;
    EXPECT_EQ(face.face.loop_offsets, (std::vector<int>{0, 2, 4})) << shape;
    EXPECT_TRUE(face.surface.is_closed_u) << shape;
  }
  EXPECT_EQ(read("spline").inner_curves.size(), 1U);
  EXPECT_EQ(read("window").inner_curves.size(), 4U);
}

TEST(UnitedFace, a_face_chosen_alone_has_no_inner_curves) {
  EXPECT_TRUE(read("halves", "1").inner_curves.empty());
  EXPECT_EQ(read("halves", "1,0").face_names, (std::vector<std::string>{"back", "front"}));
}

std::string refusal(const std::string& shape, const std::string& face = "") {
  return message_of<FormatError>([&] { read(shape, face); });
}

TEST(UnitedFace, other_surfaces_gaps_and_overlaps_are_refused) {
  EXPECT_NE(refusal("bad_surfaces", "0,1").find("different surfaces"), std::string::npos);
  EXPECT_NE(refusal("bad_gap").find("they are 0.2 apart"), std::string::npos);
  EXPECT_NE(refusal("bad_overlap").find("they overlap"), std::string::npos);
}

}  // namespace
}  // namespace quadrille::occ
