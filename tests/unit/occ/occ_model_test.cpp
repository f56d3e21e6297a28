#include "occ/occ_model.hpp"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <Standard_Failure.hxx>
#include <ios>
#include <stdexcept>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::occ {
namespace {

std::string name(const char* text) { return given_name(new TCollection_HAsciiString(text)); }

TEST(GivenName, what_programs_write_without_a_name_is_none) {
  for (const char* automatic : {"", "NONE", "none", "  ", "=>[0:1:1:2]", "Open CASCADE STEP translator 7.6 4.1"})
    EXPECT_EQ(name(automatic), "") << automatic;
  for (const char* given : {"None", "Open CASCADE plate", "=>", "NONE of them"}) EXPECT_EQ(name(given), given);
  EXPECT_EQ(name(" the\tlid "), "the lid");
  EXPECT_EQ(given_name(nullptr), "");
}

using Reader = OccModel (*)(const std::string& bytes, const std::string& name);

OccModel loaded(Reader reader) { return occ_load({cad::CadFormat::iges, reader, nullptr}, "bytes", "a.iges"); }
std::string refusal(Reader reader) {
  return message_of<FormatError>([&] { loaded(reader); });
}

TEST(OccLoad, failures_of_the_reader_name_the_file) {
  EXPECT_EQ(refusal([](const std::string&, const std::string&) { return OccModel(); }),
            "a.iges: the IGES file holds no shape");
  EXPECT_EQ(refusal([](const std::string&, const std::string&) {
              OccModel model;
              model.not_built = {"D7 'lid'", "D9"};
              return model;
            }),
            "a.iges: no face can be built from what the file says, first: D7 'lid'");
  EXPECT_EQ(refusal([](const std::string&, const std::string&) -> OccModel { throw Standard_Failure("no knots"); }),
            "a.iges: the IGES file cannot be read: no knots");
  EXPECT_EQ(refusal([](const std::string&, const std::string&) -> OccModel { throw std::ios::failure("end"); }),
            "a.iges: the IGES file is broken or truncated");
  EXPECT_EQ(refusal([](const std::string&, const std::string&) -> OccModel { throw std::length_error("size"); }),
            "a.iges: the IGES file is broken: a size in it is absurd");
}

TEST(OccLoad, faces_and_solids_are_at_least_those_that_are_there) {
  const OccModel box = loaded([](const std::string&, const std::string&) {
    OccModel model;
    model.shape = BRepPrimAPI_MakeBox(1., 2., 3.).Shape();
    model.num_faces = 2, model.num_solids = 3;
    return model;
  });
  EXPECT_EQ(box.num_faces, 6);
  EXPECT_EQ(box.num_solids, 3) << "one of which was built";
}

}  // namespace
}  // namespace quadrille::occ
