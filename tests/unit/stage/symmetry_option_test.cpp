#include "stage/symmetry_option.hpp"

#include <gtest/gtest.h>

#include "../samples.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"
#include "base/warning_codes.hpp"

namespace quadrille::stage {
namespace {

using Names = std::vector<std::string>;

/// The unit square, whose curves go round from (0, 0).
CadFace square(const Names& names) {
  CadFace face = samples::face();
  face.curve_names = names;
  return face;
}

TEST(SymmetryNames, AreThoseThatFitThePatternUnlessOthersAreGiven) {
  const CadFace face = square({"symmetry_below", "wall", "wall", "axis"});
  EXPECT_EQ(symmetry_names(face, {}), Names{"symmetry_below"});
  EXPECT_EQ(symmetry_names(face, {"none"}), Names{});
  EXPECT_EQ(symmetry_names(face, {"axis"}), Names{"axis"});
  EXPECT_EQ(symmetry_names(face, {"ax*", "sym*"}), (Names{"axis", "symmetry_below"}));
  EXPECT_EQ(symmetry_names(face, {"3"}), Names{"axis"}) << "the number of a curve";
  expect_contains(message_of<UsageError>([&] { symmetry_names(face, {"axle"}); }), "--symmetry: there is no boundary");
}

TEST(CheckedSymmetry, OfOneLineOrTwoAtRightAngles) {
  Report report;
  EXPECT_EQ(checked_symmetry(square({"symmetry", "a", "b", "c"}), {}, report), Names{"symmetry"});
  EXPECT_EQ(checked_symmetry(square({"symmetry_x", "a", "b", "symmetry_y"}), {}, report),
            (Names{"symmetry_x", "symmetry_y"}));
  EXPECT_TRUE(report.warnings().empty());
}

TEST(CheckedSymmetry, OnOppositeSidesIsRefusedWhereItWasGivenAndElseNone) {
  const CadFace face = square({"symmetry", "a", "symmetry", "c"});
  Report report;
  EXPECT_EQ(checked_symmetry(face, {}, report), Names{});
  EXPECT_TRUE(report.warnings().empty()) << "as both sides of a channel between two planes";
  expect_contains(message_of<UsageError>([&] { checked_symmetry(face, {"symmetry"}, report); }),
                  "--symmetry symmetry: ");
}

}  // namespace
}  // namespace quadrille::stage
