#include "occ/occ_step_placements.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "../support/test_data.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"
#include "cad/load_face.hpp"

namespace quadrille::occ {
namespace {

std::string changed(const std::string& file, const std::string& from, const std::string& to) {
  std::ifstream stream(test_data() + "/" + file, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  const std::string text = bytes.str();
  const size_t at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("no " + from + " in " + file);
  return text.substr(0, at) + to + text.substr(at + from.size());
}

// assemblies/mapped.step: a right triangle with sides 4 and 2 along x and y, turned by 90 degrees and moved to (10, 20,
// 30).
const std::string placement = "'',#49,#50,#51,1.,#52)";

std::string with_placement(const std::string& arguments) {
  return changed("assemblies/mapped.step", placement, arguments);
}

void expect_turned(const std::string& bytes) {
  const cad::FaceList list = cad::list_faces_guarded(bytes, "a.step");
  ASSERT_EQ(list.faces.size(), 1U);
  ASSERT_EQ(list.faces[0].edges.size(), 3U);
  const std::array<double, 3> expected{9, 22, 30};  // of the middle of the slanted edge, (2, 1) in the part
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(list.faces[0].edges[1].place[k], expected[k], 1e-12);
}

void expect_refused(const std::string& bytes, const std::string& reason) {
  for (const bool is_listing : {true, false}) {
    const std::string message = message_of<FormatError>([&] {
      Report report;
      if (is_listing)
        cad::list_faces_guarded(bytes, "a.step");
      else
        cad::load_face_guarded(bytes, "a.step", {}, report);
    });
    EXPECT_NE(message.find(reason), std::string::npos) << message;
  }
}

TEST(StepPlacements, rotated_and_moved_parts_are_read_where_they_are) {
  expect_turned(with_placement(placement));
  expect_turned(with_placement("'',#49,#50,#51,$,$)"));
  expect_turned(with_placement("'',#49,#50,#51,1.,$)"));
}

TEST(StepPlacements, mirrors_are_refused_with_their_entities) {
  expect_refused(changed("assemblies/mapped.step", "#50=DIRECTION('',(-1.0", "#50=DIRECTION('',(1.0"),
                 "#54 places a part with #53 CARTESIAN_TRANSFORMATION_OPERATOR_3D, which mirrors it");
  expect_refused(changed("assemblies/mapped.step", "#52=DIRECTION('',(0.0,0.0,1.0", "#52=DIRECTION('',(0.0,0.0,-1.0"),
                 "mirrors it");
}

TEST(StepPlacements, scales_are_refused) {
  expect_refused(with_placement("'',#49,#50,#51,2.5,#52)"), "scales it by 2.5: export the part with its own geometry");
  expect_refused(with_placement("'',#49,#50,#51,-1.,#52)"), "scales it by -1");
}

TEST(StepPlacements, parallel_axes_are_refused) {
  expect_refused(with_placement("'',#52,#50,#51,1.,#52)"), "has parallel axes");
}

TEST(StepPlacements, placements_of_assemblies_are_checked_too) {
  expect_refused(changed("assemblies/parts.step", "ITEM_DEFINED_TRANSFORMATION('','',#12,#220)",
                         "CARTESIAN_TRANSFORMATION_OPERATOR_3D('','','',$,$,#217,3.,$)"),
                 "scales it by 3");
}

}  // namespace
}  // namespace quadrille::occ
