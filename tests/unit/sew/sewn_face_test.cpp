#include "sew/sewn_face.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "regions.hpp"

namespace quadrille::sew {

namespace {

using namespace testing_regions;

CadFace face_of(const std::vector<Region>& regions) {
  return face_of_regions(sew_regions(regions, 1e-5), heal::RawFace(), radians(1.0));
}

std::vector<Region> t_joint() {
  return regions_of({{rectangle({0, 0}, {2, 1})}, {rectangle({0, 1}, {0.75, 2})}, {rectangle({0.75, 1}, {2, 2})}});
}

TEST(FaceOfRegions, ListsLoopsAndPartnersRegionAfterRegion) {
  const CadFace face = face_of(t_joint());
  EXPECT_EQ(face.region_loops, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(face.loop_offsets, (std::vector<int>{0, 5, 9, 13}));
  EXPECT_EQ(face.partners, (std::vector<int>{-1, -1, 9, 5, -1, 3, 12, -1, -1, 2, -1, -1, 6}));
  EXPECT_NEAR(face.diameter, std::sqrt(8.0), 1e-14);
}

TEST(FaceOfRegions, JointsAreThoseOfEachRegionByItself) {
  const CadFace face = face_of(t_joint());
  EXPECT_DOUBLE_EQ(face.joints[3].interior_angle, pi);
  EXPECT_FALSE(face.joints[3].is_corner) << "the edge of the first region is straight there";
  EXPECT_DOUBLE_EQ(face.joints[6].interior_angle, half_pi);
  EXPECT_TRUE(face.joints[6].is_corner);
  EXPECT_TRUE(face.joints[9].is_corner);
}

TEST(FaceOfRegions, BothSidesOfAnInterfaceHaveOneName) {
  std::vector<Region> regions = t_joint();
  regions[0].curves[0].name = "floor";
  regions[2].curves[0].name = "bond";
  regions[1].curves[1].name = "seam", regions[2].curves[3].name = "other";
  regions[1].name = "";
  const CadFace face = face_of(regions);
  EXPECT_EQ(face.region_names, (std::vector<std::string>{"part0", "region_1", "part2"}));
  EXPECT_EQ(face.curve_names[0], "floor");
  EXPECT_EQ(face.curve_names[2], "bond") << "the second side has the name";
  EXPECT_EQ(face.curve_names[9], "bond");
  EXPECT_EQ(face.curve_names[6], "seam") << "the first side's name counts";
  EXPECT_EQ(face.curve_names[12], "seam");
  EXPECT_EQ(face.unnamed_curves, (std::vector<int>{1, 3, 4, 5, 7, 8, 10, 11}));
  EXPECT_EQ(face.curve_names[4], "curve_4");
}

TEST(FaceOfRegions, TheTipOfASlitHasTheFaceAllAround) {
  std::vector<Region> regions =
      regions_of({{polygon({{0, 0}, {1, 0}, {1, 1}, {0.5, 1}, {0.5, 0.5}, {0.5, 1}, {0, 1}})}});
  regions[0].other_sides[3] = 4, regions[0].other_sides[4] = 3;
  const CadFace face = face_of(regions);
  EXPECT_EQ(face.partners[3], 4);
  EXPECT_EQ(face.partners[4], 3);
  EXPECT_DOUBLE_EQ(face.joints[4].interior_angle, 2 * pi);
  EXPECT_TRUE(face.joints[4].is_corner);
  EXPECT_DOUBLE_EQ(face.joints[3].interior_angle, half_pi);
}

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

TEST(SewnFace, WithoutHealingCurvesAreEmbedded) {
  SewOptions options;
  options.heal_tolerance = 0;
  const Nurbs inner = curve::segment({0.5, 0}, {0.7, 0.5});
  const heal::RawEdge edge{inner, inner.poles.front(), inner.poles.back(), 0};
  std::vector<Repair> repairs;
  Report report;
  const CadFace face = sewn_face({raw_face("a", rectangle({0, 0}, {1, 1}))}, {edge}, options, repairs, report);
  EXPECT_EQ(face.num_curves(), 7);
  EXPECT_EQ(face.num_loops(), 1);
  EXPECT_TRUE(face.region_loops.empty());
  EXPECT_EQ(face.name, "a");
}

TEST(SewnFace, ASingleFaceWithConstructionLinesHasNoRegions) {
  const Nurbs beside = curve::segment({3, 0}, {4, 0});
  std::vector<Repair> repairs;
  Report report;
  const CadFace face = sewn_face({raw_face("a", rectangle({0, 0}, {1, 1}))},
                                 {{beside, beside.poles.front(), beside.poles.back(), 0}}, {}, repairs, report);
  EXPECT_EQ(report.warnings().size(), 1U);
  EXPECT_TRUE(face.partners.empty());
  EXPECT_TRUE(face.region_names.empty());
}

}  // namespace

}  // namespace quadrille::sew
