#include "sew/sewn_face.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "regions.hpp"

namespace quadrille::sew {
namespace {

using namespace testing_regions;

heal::RawFace raw_face(const std::string& name, const Loop& loop) {
  heal::RawFace raw;
  raw.file = "x.step", raw.name = name;
  raw.wires.emplace_back();
  for (const heal::LoopCurve& c : loop)
    raw.wires.back().push_back({c.curve, c.curve.poles.front(), c.curve.poles.back(), c.cad_edge});
  return raw;
}

Report::Value value_of(const Report& report, const std::string& key) {
  for (const auto& [name, value] : report.entries())
    if (name == key) return value;
  ADD_FAILURE() << key;
  return {};
}

std::string refusal(const std::vector<heal::RawFace>& faces, const SewOptions& options = {}) {
  std::vector<Repair> repairs;
  Report report;
  try {
    sewn_face(faces, {}, options, repairs, report);
  } catch (const FormatError& e) {
    return e.what();
  }
  return {};
}

TEST(SewnFace, HealsEachFaceAndNumbersTheEdgesOfAll) {
  heal::RawFace second = raw_face("b", rectangle({1, 0}, {2, 1}));
  second.wires[0][1].curve = curve::segment({2, 0}, {2, 1 - 3e-6});
  second.wires[0][1].end = {2, 1 - 3e-6};
  std::vector<Repair> repairs;
  Report report;
  const CadFace face = sewn_face({raw_face("a", rectangle({0, 0}, {1, 1})), second}, {}, {}, repairs, report);
  EXPECT_EQ(face.num_regions(), 2);
  EXPECT_EQ(face.curve_cad_edges, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7}));
  ASSERT_EQ(repairs.size(), 1U);
  EXPECT_EQ(repairs[0].cad_edge, 5);
  EXPECT_EQ(std::get<long long>(value_of(report, "sew.interfaces")), 1);
  EXPECT_NEAR(std::get<double>(value_of(report, "face.area")), 2, 1e-5);
}

TEST(SewnFace, FacesInAnotherPlaneAreRefused) {
  heal::RawFace wall = raw_face("wall", rectangle({1, 0}, {2, 1}));
  wall.wires[0][1].height = 0.25;
  const std::string text = refusal({raw_face("floor", rectangle({0, 0}, {1, 1})), wall});
  EXPECT_NE(
      text.find("x.step: the file holds several faces (2) that are not in one plane: face 1 'wall' is up to 0.25 off "
                "the plane of face 0 'floor'"),
      std::string::npos)
      << text;
}

TEST(SewnFace, ErrorsOfAFaceNameIt) {
  heal::RawFace open = raw_face("b", rectangle({1, 0}, {2, 1}));
  open.wires[0].pop_back();
  const std::string text = refusal({raw_face("a", rectangle({0, 0}, {1, 1})), open});
  EXPECT_EQ(text.rfind("x.step: face 1 'b': the wire is open", 0), 0U) << text;
}

TEST(SewnFace, WithoutHealingOnlyRoundingIsSewn) {
  SewOptions options;
  options.heal_tolerance = 0;
  const heal::RawFace left = raw_face("a", rectangle({0, 0}, {1, 1}));
  EXPECT_EQ(refusal({left, raw_face("b", rectangle({1 + 1e-8, 0}, {2, 1}))}, options), "");
  EXPECT_NE(refusal({left, raw_face("b", rectangle({1 + 5e-6, 0}, {2, 1}))}, options), "");
  EXPECT_EQ(refusal({left, raw_face("b", rectangle({1 + 5e-6, 0}, {2, 1}))}), "");
}

}  // namespace
}  // namespace quadrille::sew
