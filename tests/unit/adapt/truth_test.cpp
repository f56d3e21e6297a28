// The whole way from STEP files to adapted fields, against values from an independent boundary-integral solver
// (tests/data/truth.json, good to 1e-13).

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "../support/test_data.hpp"
#include "adapt/adapt_loop.hpp"
#include "field/evaluate.hpp"
#include "galerkin/solve_laplace.hpp"
#include "occ/read_face.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::adapt {
namespace {

std::string read(const std::string& name) {
  std::ostringstream bytes;
  bytes << std::ifstream(test_data() + "/" + name, std::ios::binary).rdbuf();
  return bytes.str();
}

Field adapted(const std::string& shape, const galerkin::LaplaceOptions& options) {
  Report report;
  const TriMesh mesh = triangulate::triangulate(
      occ::read_face(occ::step_format(), read(shape + ".step"), shape + ".step", {}, report).face, {}, report);
  return adapt_loop(galerkin::solve_laplace(mesh, std::vector<int>(mesh.num_elems(), 8), options, report), {}, report);
}

void expect_truth(const std::string& shape, const Field& field, double field_tol, double zero_tol) {
  const auto truth = nlohmann::json::parse(read("truth.json")).at(shape);
  const field::FieldEvaluator evaluator(field);
  for (const auto& sample : truth.at("field_samples")) {
    Vec2 value;
    ASSERT_TRUE(evaluator.value_at(Vec2{sample[0], sample[1]} - field.mesh.face.origin, value));
    EXPECT_LT(distance(value, {sample[2], sample[3]}), field_tol) << sample;
  }
  for (const auto& point : truth.at("critical_points")) {
    const mesh::Location at = evaluator.locator().find(Vec2{point.at("x"), point.at("y")} - field.mesh.face.origin);
    ASSERT_GE(at.elem, 0);
    const field::FieldSample there = evaluator.sample(at.elem, at.xi);
    const double step = norm(inverse(there.dv_dx) * there.value);  // Newton's, to our zero
    EXPECT_LT(step, zero_tol * field.mesh.face.diameter) << point;
    EXPECT_EQ(det(there.dv_dx) > 0 ? 1 : -1, point.at("index"));
  }
}

class Truth : public testing::TestWithParam<const char*> {};

// Elements of a quarter of the diameter leave a few at the highest order next to curves; interior points see less.
TEST_P(Truth, FieldAndZerosAreMetWithDefaultSettings) { expect_truth(GetParam(), adapted(GetParam(), {}), 1e-7, 1e-9); }

// Their orders end at 12: coarser meshes than those of the paper's shapes would need more, and padapt says so.
TEST(TruthOfDg, IsMetByLiftedDiscontinuousElementsOnThePapersShapes) {
  for (const char* shape : {"half_disc", "geometry_1"})
    expect_truth(shape, adapted(shape, {.method = FieldMethod::dg}), 1e-6, 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Truth,
                         testing::Values("half_disc", "square", "l_shape", "quarter_annulus", "annulus",
                                         "eccentric_annulus", "plate_hole", "cylinder_channel", "s_bend", "stadium",
                                         "geometry_1"),
                         [](const auto& shape) { return std::string(shape.param); });

}  // namespace
}  // namespace quadrille::adapt
