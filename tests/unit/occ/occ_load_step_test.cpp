#include <gtest/gtest.h>

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>

#include "../support/test_data.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"
#include "occ/occ_model.hpp"

namespace quadrille::occ {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

OccModel loaded(const std::string& bytes) { return occ_load(step_format(), bytes, "a.step"); }

double width(const OccModel& model) {
  Bnd_Box box;
  BRepBndLib::Add(model.shape, box);
  return box.CornerMax().X() - box.CornerMin().X() - 2 * box.GetGap();
}

/// A reader has one unit for the whole process, which no file may leave to the next one.
TEST(OccLoadStep, lengths_stay_in_the_unit_of_the_file) {
  const OccModel inches = loaded(test_bytes("bad/inches.step")), metres = loaded(test_bytes("bad/metres.step")),
                 millimetres = loaded(test_bytes("bad/rectangle.step"));
  EXPECT_EQ(inches.length_unit, "inch");
  EXPECT_NEAR(inches.metres_per_unit, 0.0254, 1e-15);
  EXPECT_EQ(metres.length_unit, "metre");
  EXPECT_EQ(metres.metres_per_unit, 1);
  EXPECT_EQ(millimetres.length_unit, "millimetre");
  for (const OccModel* model : {&inches, &metres, &millimetres}) {
    EXPECT_GT(width(*model), 1);
    EXPECT_LT(width(*model), 10);
  }
}

TEST(OccLoadStep, units_have_their_usual_names) {
  const std::string metres = test_bytes("bad/metres.step"), inches = test_bytes("bad/inches.step");
  const auto si = [&](const std::string& prefix) {
    return loaded(replaced(metres, "SI_UNIT($,.METRE.)", "SI_UNIT(" + prefix + ",.METRE.)"));
  };
  EXPECT_EQ(si(".CENTI.").length_unit, "centimetre");
  EXPECT_EQ(si(".MICRO.").length_unit, "micrometre");
  EXPECT_NEAR(si(".MICRO.").metres_per_unit, 1e-6, 1e-20);
  const auto other = [&](const std::string& name, const std::string& millimetres) {
    return loaded(
               replaced(replaced(inches, "'INCH'", "'" + name + "'"), "MEASURE(25.4)", "MEASURE(" + millimetres + ")"))
        .length_unit;
  };
  EXPECT_EQ(other("Zoll", "25.4"), "inch");
  EXPECT_EQ(other("Elle", "571.4"), "elle");
}

TEST(OccLoadStep, several_units_are_refused) {
  EXPECT_EQ(message_of<FormatError>([] { loaded(test_bytes("bad/mixed_units.step")); }),
            "a.step: the file mixes length units (inch and millimetre)");
}

TEST(OccLoadStep, the_tolerance_is_the_uncertainty_of_the_file) {
  const std::string bytes = test_bytes("bad/inches.step");
  EXPECT_EQ(loaded(replaced(bytes, "LENGTH_MEASURE(1.E-07)", "LENGTH_MEASURE(2.E-05)")).tolerance, 2e-5);
}

TEST(OccLoadStep, edges_of_a_face_are_counted_as_the_file_has_them) {
  const OccModel model = loaded(test_bytes("bad/rectangle.step"));
  EXPECT_EQ(model.num_faces, 1);
  ASSERT_EQ(model.num_edges.size(), 1U);
  EXPECT_EQ(model.num_edges.begin()->second, 4);
}

TEST(OccLoadStep, what_is_no_step_file_is_refused) {
  EXPECT_THROW(loaded("ISO-10303-21;"), FormatError);
  EXPECT_THROW(loaded("no STEP"), FormatError);
  EXPECT_THROW(loaded(""), FormatError);
}

}  // namespace
}  // namespace quadrille::occ
