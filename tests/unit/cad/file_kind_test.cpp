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
  EXPECT_NE(refusal("ISO-10303-21;\nHEADER;\n", "a.step").find("truncated"), std::string::npos);
  EXPECT_NE(refusal(iges_line('S', "1") + iges_line('G', "1"), "a.igs").find("truncated"), std::string::npos);
}

TEST(FileKind, HasAName) {
  EXPECT_EQ(format_name(CadFormat::step), "STEP");
  EXPECT_EQ(format_name(CadFormat::iges), "IGES");
  EXPECT_EQ(format_name(CadFormat::brep), "BREP");
}

}  // namespace
}  // namespace quadrille::cad
