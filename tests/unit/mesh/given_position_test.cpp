#include "mesh/given_position.hpp"

#include <gtest/gtest.h>

#include "../chart_samples.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::mesh {
namespace {

std::vector<double> coordinates(Vec3 x) { return {x.x, x.y, x.z}; }

TEST(GivenPosition, OnACurvedFaceItIsThatInSpace) {
  const CadFace face = samples::sphere_face(2, 10);
  const Vec2 x{0.2, 0.3};
  EXPECT_LE(distance(given_position(face, coordinates(1.0005 * samples::on_sphere(x)), "--name"), x), 1e-6);
}

TEST(GivenPosition, OffTheFaceOrWithTwoCoordinatesItIsRefused) {
  const CadFace face = samples::sphere_face();
  const auto refusal = [&](const std::vector<double>& x) {
    return message_of<FormatError>([&] { given_position(face, x, "--name a"); });
  };
  expect_contains(refusal({0.1, 0.1}), "--name a: (0.1, 0.1) has two coordinates, and this face is curved");
  expect_contains(refusal(coordinates(1.1 * samples::on_sphere({0.2, 0.3}))), "0.1 off the face");
  expect_contains(refusal(coordinates(samples::on_sphere({-0.2, 0.3}))), "off the face");
}

TEST(GivenPosition, OnAPlanarFaceItIsThatInThePlane) {
  EXPECT_EQ(given_position(samples::face(), {0.25, 0.5}, ""), (Vec2{0.25, 0.5}) - samples::face().origin);
}

}  // namespace
}  // namespace quadrille::mesh
