// The whole way from STEP files to adapted fields, against values from an independent boundary-integral solver
// (tests/data/truth.json, good to 1e-13).

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "adapt/adapt_loop.hpp"
#include "cad/load_face.hpp"
#include "field/evaluate.hpp"
#include "galerkin/solve_laplace.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille {
namespace {

std::string read(const std::string& name) {
  std::ostringstream bytes;
  bytes << std::ifstream(std::string(TEST_DATA) + "/" + name, std::ios::binary).rdbuf();
  return bytes.str();
}

Field adapted(const std::string& shape) {
  Report report;
  const TriMesh mesh = triangulate(load_face(read(shape + ".step"), shape + ".step", {}, report), {}, report);
  return adapt_loop(solve_laplace(mesh, std::vector<int>(mesh.num_elems(), 8), report), {}, report);
}

class Truth : public testing::TestWithParam<const char*> {};

TEST_P(Truth, FieldAndZerosAreMetWithDefaultSettings) {
  const auto truth = nlohmann::json::parse(read("truth.json")).at(GetParam());
  const Field field = adapted(GetParam());
  const FieldEvaluator evaluator(field);
  // Elements of a quarter of the diameter leave a few at the highest order next to curves; interior points see less.
  const double field_tol = 1e-7, zero_tol = 1e-8 * field.mesh.face.diameter;
  for (const auto& sample : truth.at("field_samples")) {
    Vec2 value;
    ASSERT_TRUE(evaluator.value_at(Vec2{sample[0], sample[1]} - field.mesh.face.origin, value));
    EXPECT_LT(distance(value, {sample[2], sample[3]}), field_tol) << sample;
  }
  for (const auto& point : truth.at("critical_points")) {
    const Location at = evaluator.locator().find(Vec2{point.at("x"), point.at("y")} - field.mesh.face.origin);
    ASSERT_GE(at.elem, 0);
    const FieldSample there = evaluator.sample(at.elem, at.xi);
    EXPECT_LT(norm(inverse(there.dv_dx) * there.value), zero_tol) << point;  // Newton's step to our zero
    EXPECT_EQ(det(there.dv_dx) > 0 ? 1 : -1, point.at("index"));
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Truth,
                         testing::Values("half_disc", "square", "l_shape", "quarter_annulus", "annulus",
                                         "eccentric_annulus", "plate_hole", "cylinder_channel", "s_bend", "stadium",
                                         "geometry_1"),
                         [](const auto& shape) { return std::string(shape.param); });

}  // namespace
}  // namespace quadrille
