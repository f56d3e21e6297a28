#include <gtest/gtest.h>

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <Bnd_Box.hxx>
#include <IGESControl_Writer.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pln.hxx>
#include <sstream>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "occ/occ_model.hpp"
#include "occ/occ_quiet.hpp"

namespace quadrille::occ {
namespace {

/// A rectangle, 254 millimetres wide, in a file of this unit.
OccModel rectangle(const char* unit) {
  quiet_kernel();
  IGESControl_Writer writer(unit, 0);
  writer.AddShape(BRepBuilderAPI_MakeFace(gp_Pln(), 0, 254, 0, 100).Face());
  std::ostringstream stream;
  writer.Write(stream);
  return occ_load(iges_format(), stream.str(), "a.iges");
}

double width(const OccModel& model) {
  Bnd_Box box;
  BRepBndLib::Add(model.shape, box);
  return box.CornerMax().X() - box.CornerMin().X() - 2 * box.GetGap();
}

TEST(OccLoadIges, lengths_stay_in_the_unit_of_the_file) {
  for (const auto& [unit, name, millimetres] : {std::tuple{"MM", "millimetre", 1.0},
                                                {"INCH", "inch", 25.4},
                                                {"FT", "foot", 304.8},
                                                {"M", "metre", 1000.0},
                                                {"CM", "centimetre", 10.0},
                                                {"UM", "micrometre", 1e-3}}) {
    const OccModel model = rectangle(unit);
    EXPECT_EQ(model.length_unit, name);
    EXPECT_NEAR(model.metres_per_unit / (millimetres / 1000), 1, 1e-12) << unit;
    EXPECT_NEAR(width(model) * millimetres / 254, 1, 1e-5) << unit;
  }
}

TEST(OccLoadIges, what_is_no_iges_file_is_refused) {
  for (const char* bytes : {"", "no IGES", "S      1\nG      2\n"})
    EXPECT_THROW(occ_load(iges_format(), bytes, "a.iges"), FormatError) << bytes;
}

}  // namespace
}  // namespace quadrille::occ
