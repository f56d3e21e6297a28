#include "cad/face_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace quadrille::cad {
namespace {

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
