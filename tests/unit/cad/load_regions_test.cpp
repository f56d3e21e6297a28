// Files of several faces and of faces with curves inside (tests/data/regions), read as one face.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "../support/test_data.hpp"
#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/warning_codes.hpp"
#include "cad/load_face.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::cad {
namespace {

CadFace load(const std::string& file, const LoadOptions& options = {}) {
  Report report;
  return load_face_guarded(test_bytes("regions/" + file), file, options, report).face;
}

/// Twice the area inside a chain of curves, by the trapezoidal rule on its points.
double area_of(const CadFace& face, int region) {
  const bool is_single = face.region_loops.empty();
  const int first = is_single ? 0 : face.region_loops[region];
  const int last = is_single ? face.num_loops() : face.region_loops[region + 1];
  double area = 0;
  for (int c = face.loop_offsets[first]; c < face.loop_offsets[last]; ++c) {
    const Nurbs& curve = face.curves[c];
    constexpr int steps = 4000;
    Vec2 before = curve.poles.front();
    for (int i = 1; i <= steps; ++i) {
      const Vec2 x = curve::point(curve, curve.begin() + (curve.end() - curve.begin()) * i / steps);
      area += cross(before, x) / 2;
      before = x;
    }
  }
  return area;
}

/// That both sides of common curves agree bit for bit, and have one name.
void expect_mirrored(const CadFace& face) {
  for (int c = 0; c < face.num_curves(); ++c) {
    EXPECT_EQ(face.curves[c].poles.back(), face.curves[face.next_in_loop(c)].poles.front());
    if (!face.is_interface(c)) continue;
    const int partner = face.partners[c];
    EXPECT_EQ(face.partners[partner], c);
    EXPECT_EQ(face.curve_names[partner], face.curve_names[c]);
    const Nurbs &own = face.curves[c], &other = face.curves[partner];
    EXPECT_TRUE(std::equal(own.poles.begin(), own.poles.end(), other.poles.rbegin(), other.poles.rend()));
    EXPECT_TRUE(std::equal(own.weights.begin(), own.weights.end(), other.weights.rbegin(), other.weights.rend()));
  }
}

struct Expected {
  const char* file;
  int regions, loops, interfaces, slits;
  std::vector<double> areas;  ///< of the first regions
};

std::ostream& operator<<(std::ostream& stream, const Expected& expected) { return stream << expected.file; }

class Regions : public testing::TestWithParam<Expected> {};

TEST_P(Regions, AreThoseOfTheFile) {
  const Expected& expected = GetParam();
  const CadFace face = load(expected.file);
  EXPECT_EQ(face.num_regions(), expected.regions);
  EXPECT_EQ(face.num_loops(), expected.loops);
  expect_mirrored(face);
  int interfaces = 0, slits = 0;
  for (int c = 0; c < face.num_curves(); ++c) {
    if (!face.is_interface(c) || face.partners[c] < c) continue;
    const bool is_slit = face.region_of_loop(face.loop_of(c)) == face.region_of_loop(face.loop_of(face.partners[c]));
    ++(is_slit ? slits : interfaces);
  }
  EXPECT_EQ(interfaces, expected.interfaces);
  EXPECT_EQ(slits, expected.slits);
  for (std::size_t r = 0; r < expected.areas.size(); ++r)
    EXPECT_NEAR(area_of(face, static_cast<int>(r)), expected.areas[r], 1e-6 * expected.areas[r]) << r;
}

INSTANTIATE_TEST_SUITE_P(
    All, Regions,
    testing::Values(
        Expected{"disc_in_square.step", 2, 3, 1, 0, {4 - 0.16 * pi, 0.16 * pi}},
        Expected{"nested_rings.step", 3, 5, 2, 0, {pi, 1.25 * pi, 1.75 * pi}},
        Expected{"chequerboard_2_hole.step", 4, 4, 4, 0, {1 - 0.04 * pi, 1 - 0.04 * pi}},
        Expected{"chequerboard_4_hole.step", 16, 16, 24, 0, {1, 1, 1, 1, 1, 1 - 0.04 * pi}},
        Expected{"t_joint.step", 3, 3, 3, 0, {2, 0.8, 1.2}}, Expected{"t_joint_open.step", 3, 3, 3, 0, {}},
        Expected{"coated_gear.step", 2, 4, 48, 0, {}}, Expected{"pipe_wall.step", 2, 3, 1, 0, {0.51 * pi, 0.49 * pi}},
        Expected{"voronoi_20.step", 20, 20, 44, 0, {}}, Expected{"half_disc_cut.step", 2, 2, 1, 0, {half_pi, half_pi}},
        Expected{"aerofoil_wake.step", 1, 1, 0, 1, {}}, Expected{"plate_curve.step", 1, 2, 0, 1, {6}},
        Expected{"plate_circle.step", 2, 3, 1, 0, {6 - 0.36 * pi, 0.36 * pi}},
        Expected{"plate_crack.step", 1, 1, 0, 1, {6}}, Expected{"coated_cam.step", 3, 6, 5, 0, {}},
        Expected{"layered_cable.step", 8, 15, 7, 0, {(144 - 110.25) * pi}},
        Expected{"layered_seal.step", 3, 5, 24, 0, {}}, Expected{"layered_beam.step", 4, 4, 3, 0, {600, 60, 60, 33}},
        Expected{"pins.step", 6, 11, 5, 0, {800 - 31.25 * pi, 6.25 * pi}},
        Expected{"pin_in_channel.step", 2, 3, 1, 0, {90.2 - 0.25 * pi, 0.25 * pi}},
        Expected{"slit.step", 1, 1, 0, 1, {2}}, Expected{"inner_curve.step", 1, 2, 0, 1, {2}}));

TEST(LoadRegions, CommonCurvesHaveTheNameOfTheFileOrOfBothRegions) {
  const CadFace pin = load("pin_in_channel.step");
  EXPECT_EQ(pin.region_names, (std::vector<std::string>{"fluid", "pin"}));
  EXPECT_EQ(pin.curve_names,
            (std::vector<std::string>{"wall", "outlet", "wall", "inlet", "pin surface", "pin surface"}));
  const CadFace disc = load("disc_in_square.step");
  EXPECT_EQ(disc.curve_names[4], "matrix-fibre");
  EXPECT_EQ(disc.curve_names[5], "matrix-fibre");
  EXPECT_EQ(load("plate_circle.step").region_names, (std::vector<std::string>{"plate", "plate"}));
}

TEST(LoadRegions, OfIgesFilesAreNamedByTheirLevels) {
  const CadFace face = load("disc_in_square.iges");
  expect_mirrored(face);
  EXPECT_EQ(face.region_names, (std::vector<std::string>{"level_1", "level_2"}));
  EXPECT_EQ(face.curve_names[4], "level_1-level_2");
}

TEST(LoadRegions, AChosenFaceIsReadWithTheCurvesInside) {
  LoadOptions options;
  options.face = "fibre";
  const CadFace face = load("disc_in_square.step", options);
  EXPECT_EQ(face.num_curves(), 1);
  EXPECT_TRUE(face.partners.empty());
  options.face = "0";
  EXPECT_EQ(load("plate_crack.step", options).num_curves(), load("plate_crack.step").num_curves());
}

TEST(LoadRegions, TheWakeStartsAtTheTrailingEdge) {
  const CadFace face = load("aerofoil_wake.step");
  const auto wake = std::find_if(face.partners.begin(), face.partners.end(), [](int p) { return p >= 0; });
  const Nurbs& curve = face.curves[wake - face.partners.begin()];
  const double least = std::min(curve.poles.front().x, curve.poles.back().x);
  EXPECT_EQ(least, 1);
  EXPECT_EQ(std::max(curve.poles.front().x, curve.poles.back().x), 2.5);
}

void expect_refused(const std::string& file, const std::string& reason) {
  const std::string message = message_of<FormatError>([&] { load("bad/" + file); });
  EXPECT_NE(message.find(reason), std::string::npos) << file << ": " << message;
  EXPECT_EQ(message.find("bad/" + file + ": "), 0U) << message;
}

TEST(LoadRegions, FacesThatDoNotFitAreRefusedWithPlaceSizeAndRemedy) {
  expect_refused("overlap.step", "face 0 'one' and face 1 'two' overlap at (1.5, 0.515625), by 0.484 or more");
  expect_refused("disc_on_square.step", "face 0 'plate' and face 1 'disc' overlap");
  expect_refused("twice.step", "face 0 'one' and face 1 'two' overlap");
  expect_refused("gap.step", "do not meet: they are up to 0.0002 apart at (1.0001, ");
  expect_refused("gap.step", "give --heal-tolerance 9e-05");
  expect_refused("gap_around.step", "do not meet: they are up to 0.0005 apart");
  expect_refused("crevice.step",
                 "face 0 'base' and face 1 'left' do not meet: they are up to 0.0004 apart at (1, 1.0002)");
  expect_refused("disjoint.step", "several faces (2) that do not touch: face 0 'one' and face 1 'two' are 0.5 apart");
  expect_refused("corner_contact.step", "touch at (1, 1) in a point only");
  expect_refused("two_planes.step", "not in one plane: face 1 'wall' is up to 1 off the plane of face 0 'floor'");
}

TEST(LoadRegions, TheToleranceOfTheRemedyClosesTheGap) {
  LoadOptions options;
  options.heal_tolerance = 9e-5;
  EXPECT_EQ(load("bad/gap.step", options).num_regions(), 2);
  options.heal_tolerance = 1.8e-4;
  EXPECT_EQ(load("bad/gap_around.step", options).num_regions(), 2);
}

}  // namespace
}  // namespace quadrille::cad
