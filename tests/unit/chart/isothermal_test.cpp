#include "chart/isothermal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "surface_samples.hpp"

namespace quadrille::chart {
namespace {

TEST(Isothermal, ACylinderIsUnrolled) {
  const SurfaceSample sample(cylinder_patch());
  SurfaceMesh mesh = sample.lifted(4);
  const IsothermalFit fit = make_isothermal(mesh, sample.face.face.loop_offsets);
  EXPECT_LT(fit.closedness, 1e-7);
  const auto flat = [](Vec3 x) { return Vec2{2 * std::atan2(x.y, x.x), x.z}; };
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    EXPECT_NEAR(mesh.scale[i], 0, 1e-7);
    EXPECT_NEAR(distance(mesh.image[i], mesh.image[0]), distance(flat(mesh.nodes[i]), flat(mesh.nodes[0])), 1e-7);
  }
}

/// Stereographic from the south pole: 1.6 tan(theta / 2) from the north pole, 0.8 at the rim, so that lengths at the
/// pole are 0.8 times those in space.
TEST(Isothermal, ACapIsStereographic) {
  const SurfaceSample sample(cap());
  SurfaceMesh mesh = sample.lifted(4);
  const IsothermalFit fit = make_isothermal(mesh, sample.face.face.loop_offsets);
  EXPECT_LT(fit.closedness, 1e-4);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    EXPECT_NEAR(mesh.scale[i], std::log(1.6 / (1 + mesh.nodes[i].z)), 1e-4);
}

TEST(Isothermal, PartsOfTheErrorSumToItsSquare) {
  const SurfaceSample sample(cap());
  SurfaceMesh mesh = sample.lifted(2);
  const IsothermalFit fit = make_isothermal(mesh, sample.face.face.loop_offsets);
  EXPECT_EQ(std::ssize(fit.elem_squares), mesh.num_elems());
  EXPECT_NEAR(std::accumulate(fit.elem_squares.begin(), fit.elem_squares.end(), 0.0), fit.closedness * fit.closedness,
              1e-12 * fit.closedness * fit.closedness);
  SurfaceMesh finer = sample.lifted(4);
  EXPECT_LT(make_isothermal(finer, sample.face.face.loop_offsets).closedness, fit.closedness / 10);
}

/// The image of the hole closes: a ring with the radii 1 and 1 / e.
TEST(Isothermal, ATubeIsARing) {
  const SurfaceSample sample(tube());
  SurfaceMesh mesh = sample.lifted(4);
  EXPECT_LT(make_isothermal(mesh, sample.face.face.loop_offsets).closedness, 1e-5);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) EXPECT_NEAR(mesh.scale[i], -mesh.nodes[i].z, 1e-4);
}

}  // namespace
}  // namespace quadrille::chart
