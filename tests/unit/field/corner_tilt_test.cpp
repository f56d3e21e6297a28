#include "field/corner_tilt.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/polygon_field.hpp"
#include "base/angle.hpp"
#include "field/boundary_values.hpp"

namespace quadrille::field {
namespace {

/// A plate with one chamfer of `angle` degrees: joints 2 and 3 have about 135 degrees, the chamfer is curve 2.
TriMesh plate(double angle = 45) {
  const double top = 2 + std::tan(radians(angle));
  TriMesh mesh;
  mesh.face = polygon_face({{0, 0}, {4, 0}, {4, 2}, {3, top}, {0, top}});
  return mesh;
}

/// The data themselves.
Vec2 value(const CadFace& face, const LiftedData& data, int curve, double t) {
  return data.values(curve, t) + liftings_on_boundary(face, data.liftings, curve, t);
}

TEST(CornerTilt, turns_the_phase_at_the_corner_by_40_degrees_backward_before_and_forward_behind) {
  const TriMesh mesh = plate();
  const CadFace& face = mesh.face;
  const LiftedData even = tilt_data(mesh, {2}, TiltPart::even), odd = tilt_data(mesh, {2}, TiltPart::odd);
  for (const double sign : {1.0, -1.0}) {
    const auto tilted = [&](int curve, double t) {
      return boundary_value(face, curve, t) + value(face, even, curve, t) + sign * value(face, odd, curve, t);
    };
    const Vec2 before = tilted(1, face.curves[1].end()), behind = tilted(2, face.curves[2].begin());
    EXPECT_NEAR(degrees(angle_of(before)), -40 * sign, 1e-9);
    EXPECT_NEAR(degrees(wrap_two_pi(angle_of(behind))), 180 + 40 * sign, 1e-9);
    EXPECT_NEAR(norm(before), 1, 1e-12);
  }
}

TEST(CornerTilt, ends_at_half_of_the_shorter_curve) {
  const TriMesh mesh = plate();
  const CadFace& face = mesh.face;
  const LiftedData odd = tilt_data(mesh, {2}, TiltPart::odd);
  const double begin = face.curves[2].begin(), end = face.curves[2].end();
  EXPECT_GT(norm(value(face, odd, 2, begin + 0.4 * (end - begin))), 1e-4);
  for (const double f : {0.5, 0.75, 1.0}) EXPECT_NEAR(norm(value(face, odd, 2, begin + f * (end - begin))), 0, 1e-12);
  EXPECT_NEAR(norm(value(face, odd, 0, face.curves[0].begin())), 0, 1e-12);
}

TEST(CornerTilt, is_continuous_round_the_loop_without_its_liftings) {
  const TriMesh mesh = plate();
  const CadFace& face = mesh.face;
  for (const TiltPart part : {TiltPart::even, TiltPart::odd}) {
    const LiftedData data = tilt_data(mesh, {2, 3}, part);
    EXPECT_EQ(data.liftings.size(), part == TiltPart::even ? 2u : 0u);
    for (int joint = 0; joint < face.num_curves(); ++joint) {
      const int before = face.previous_in_loop(joint);
      const Vec2 in = data.values(before, face.curves[before].end());
      EXPECT_NEAR(norm(in - data.values(joint, face.curves[joint].begin())), 0, 1e-12);
    }
  }
}

TEST(CornerTilt, only_the_even_part_jumps_at_an_exact_tie) {
  const TriMesh mesh = plate();
  EXPECT_GT(norm(tilt_data(mesh, {2}, TiltPart::even).liftings[0].jump), 0.1);
  EXPECT_TRUE(tilt_data(mesh, {2}, TiltPart::odd).liftings.empty());
  const TriMesh beside = plate(44.98);
  EXPECT_GT(norm(tilt_data(beside, {2}, TiltPart::odd).liftings.at(0).jump), 1e-5);
}

}  // namespace
}  // namespace quadrille::field
