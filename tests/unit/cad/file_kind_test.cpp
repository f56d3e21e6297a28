#include "cad/file_kind.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::cad {

namespace {

const std::string step = "ISO-10303-21;\nHEADER;\nENDSEC;\nEND-ISO-10303-21;\n";
const std::string brep = "DBRep_DrawableShape\n\nCASCADE Topology V1\n";

std::string iges_line(char section, const std::string& number) {
  return std::string(72, ' ') + section + std::string(7 - number.size(), ' ') + number + "\n";
}
const std::string iges = iges_line('S', "1") + iges_line('G', "1") + iges_line('T', "1");

std::string refusal(const std::string& bytes, const std::string& name) {
  return message_of<FormatError>([&] { cad_format(bytes, name); });
}

TEST(FileKind, IsThatOfTheContent) {
  EXPECT_EQ(cad_format(step, "a.step"), CadFormat::step);
  EXPECT_EQ(cad_format(step, "folder.iges/A.STP"), CadFormat::step);
  EXPECT_EQ(cad_format("\xEF\xBB\xBF \r\n" + step, "a.p21"), CadFormat::step);
  EXPECT_EQ(cad_format(iges, "a.igs"), CadFormat::iges);
  EXPECT_EQ(cad_format(brep, "a.brep"), CadFormat::brep);
  EXPECT_EQ(cad_format(brep, "/dev/stdin"), CadFormat::brep);
}

TEST(FileKind, ExtensionMustNotContradict) {
  EXPECT_NE(refusal(step, "a.igs").find("the extension .igs says IGES, the content is STEP"), std::string::npos);
  EXPECT_NE(refusal(step, "a.dxf").find("wrong extension .dxf for a STEP file"), std::string::npos);
}

TEST(FileKind, RefusesEmptyOtherAndTruncatedFiles) {
  EXPECT_NE(refusal("", "a.step").find("a.step: the file is empty"), std::string::npos);
  EXPECT_NE(refusal("solid cube\n", "a.stl").find("not a CAD file"), std::string::npos);
  EXPECT_NE(refusal("PK\3\4", "a.FCStd").find("a document of FreeCAD"), std::string::npos);
  EXPECT_NE(refusal("ISO-10303-21;\nHEADER;\n", "a.step").find("truncated"), std::string::npos);
  EXPECT_NE(refusal(iges_line('S', "1") + iges_line('G', "1"), "a.igs").find("truncated"), std::string::npos);
}

TEST(FileKind, HasAName) {
  EXPECT_EQ(format_name(CadFormat::step), "STEP");
  EXPECT_EQ(format_name(CadFormat::iges), "IGES");
  EXPECT_EQ(format_name(CadFormat::brep), "BREP");
}

std::string step_of(const std::string& data) {
  return "ISO-10303-21;\nDATA;\n" + data + "ENDSEC;\nEND-ISO-10303-21;\n";
}

TEST(StepFaults, none_in_a_sound_file) {
  EXPECT_EQ(step_fault(step_of("#1=CARTESIAN_POINT('a;#9''b',(0.,0.,0.));\n#2 = VERTEX_POINT('',\n #1);\n")), "");
  EXPECT_EQ(step_fault(step_of("#1=(A() B());#2=LINE('',#3,#1);#3=CARTESIAN_POINT('',(0.,0.));")), "");
  EXPECT_EQ(step_fault(""), "");
}

TEST(StepFaults, missing_entities_are_named) {
  EXPECT_EQ(step_fault(step_of("#2=VERTEX_POINT('',#1);")), "#2 VERTEX_POINT refers to #1, which is not in the file");
}

TEST(StepFaults, wrong_types_are_named) {
  EXPECT_EQ(step_fault(step_of("#1=DIRECTION('',(1.,0.));#2=VERTEX_POINT('',#1);")),
            "#2 VERTEX_POINT refers to #1, which is of type DIRECTION, not CARTESIAN_POINT");
  EXPECT_EQ(step_fault(step_of("#1=FOO();#2=EDGE_LOOP('',(#1));")),
            "#2 EDGE_LOOP refers to #1, which is of type FOO, not ORIENTED_EDGE");
}

}  // namespace

}  // namespace quadrille::cad
