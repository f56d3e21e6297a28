#include "stage/solver_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "../export/two_hexes.hpp"
#include "../export/two_quads.hpp"
#include "../samples.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::stage {
namespace {

using exports::two_hexes;
using exports::two_quads;

template <typename Mesh>
void check_for(const char* solver, const char* format, const Mesh& mesh, Run& run, double scale = 1) {
  check_for_solver(mesh, {*find_solver(solver), *exports::find_export_format(format), {}, scale}, run);
}

template <typename Mesh>
std::string failure(const char* solver, const char* format, const Mesh& mesh, double scale = 1) {
  quadrille::Run run;
  return message_of<ComputeError>([&] { check_for(solver, format, mesh, run, scale); });
}

template <typename Value>
Value reported(Run& run, const std::string& key) {
  for (const auto& [name, value] : run.report().entries())
    if (name == key) return std::get<Value>(value);
  ADD_FAILURE() << key << " is not reported";
  return {};
}

/// Two quads of this width that lean to the right: x grows by `slope` times y.
QuadMesh leaning(double slope, double width) {
  QuadMesh mesh = samples::quad_mesh();
  for (Vec2& x : mesh.nodes) x.x = 2 * width * x.x + slope * x.y;
  return mesh;
}

TEST(SolverTable, MeasuresStandAtTheirNumberAndSolversReadFormatsThatExist) {
  std::set<std::string_view> names;
  for (const SolverRow& solver : solver_rows()) {
    EXPECT_TRUE(names.insert(solver.name).second) << solver.name;
    EXPECT_FALSE(solver.formats.empty());
    for (const std::string_view format : solver.formats)
      EXPECT_NE(exports::find_export_format(format), nullptr) << format;
    ASSERT_FALSE(solver.limits.empty());
    for (const SolverLimit& limit : solver.limits) {
      const SolverMeasureRow& row = solver_measure(limit.measure);
      EXPECT_EQ(row.measure, limit.measure);
      EXPECT_EQ(row.of_cells == nullptr, solver.points != nullptr) << solver.name;
      EXPECT_TRUE(limit.warning || limit.failure) << solver.name;
    }
  }
}

TEST(SolverCheck, AMeshWithinAllLimitsIsReportedWithoutAWarning) {
  quadrille::Run run;
  check_for("openfoam", "polymesh", leaning(1, 0.5), run);
  EXPECT_TRUE(run.report().warnings().empty());
  EXPECT_EQ(reported<std::string>(run, "check_for.solver"), "openfoam");
  EXPECT_EQ(reported<long long>(run, "check_for.elements"), 2);
  EXPECT_NEAR(reported<double>(run, "check_for.non_orthogonality.value"), 45, 1e-10);
  EXPECT_EQ(reported<long long>(run, "check_for.non_orthogonality.element"), 0);
  const auto position = reported<std::vector<double>>(run, "check_for.non_orthogonality.position");
  ASSERT_EQ(position.size(), 2U);
  EXPECT_NEAR(position[0] - samples::face().origin.x, 1, 1e-14);
  EXPECT_NEAR(position[1] - samples::face().origin.y, 0.5, 1e-14);
}

TEST(SolverCheck, ALimitOfWarningIsAWarningWithPlaceValueLimitAndRemedy) {
  quadrille::Run run;
  check_for("openfoam", "polymesh", leaning(3, 4), run);
  ASSERT_EQ(run.report().warnings().size(), 1U);
  EXPECT_EQ(run.report().warnings()[0].code, "W-EXP-004");
  for (const char* const part : {"non-orthogonality 71.57 degrees", "element 0", "limit 70 of OpenFOAM", "--layout"})
    expect_contains(run.report().warnings()[0].message, part);
}

TEST(SolverCheck, ALimitOfFailureIsAnErrorAndTheReportHasTheValue) {
  QuadMesh mesh = samples::quad_mesh();
  for (Vec2& x : mesh.nodes) x.y *= 1e-4;
  quadrille::Run run;
  const std::string text = message_of<ComputeError>([&] { check_for("openfoam", "polymesh", mesh, run); });
  for (const char* const part : {"aspect ratio 5000 of element", "limit 1000", "(2 places do)", "without --check-for"})
    expect_contains(text, part);
  EXPECT_NEAR(reported<double>(run, "check_for.aspect_ratio.value"), 5000, 1e-8);
}

TEST(SolverCheck, FoldedElementsFailWhereTheProgramEvaluatesThem) {
  QuadMesh mesh = two_quads();
  mesh.nodes[8] = {3.9, 1.25};  // the middle of the second quad: det J < 0 between it and the right side
  expect_contains(failure("mfem", "mfem", mesh), "Jacobian ratio -");
  expect_contains(failure("nektar", "nektar", mesh), "of element 1 near");
  // Programs that have the sides alone make another middle of them.
  quadrille::Run run;
  check_for("trixi", "ism-v2", mesh, run);
  EXPECT_GT(reported<double>(run, "check_for.jacobian_ratio.value"), 0);
}

TEST(SolverCheck, PiecesAreMeasuredAndNamedByTheElementThatTheyAreOf) {
  QuadMesh mesh = two_quads();
  mesh.nodes[11] = {1, 1.5};  // the node on the top of the first quad falls below that in its middle
  mesh.nodes[6] = {1, 1.75};
  quadrille::Run run;
  expect_contains(failure("su2", "su2", mesh), "of element 0 near");
}

TEST(SolverCheck, HexahedraAreMeasuredInSpace) {
  const HexMesh mesh = two_hexes({.order = 2, .map = exports::bent});
  quadrille::Run run;
  check_for("code_saturne", "cgns", mesh, run);
  EXPECT_TRUE(run.report().warnings().empty());
  EXPECT_EQ(reported<std::vector<double>>(run, "check_for.face_offset.position").size(), 3U);
  const HexMesh thin = two_hexes({.map = [](Vec3 x) { return Vec3{x.x < 3 ? x.x : 2.001, x.y, x.z}; }});
  quadrille::Run other;
  check_for("code_saturne", "cgns", thin, other);
  ASSERT_FALSE(other.report().warnings().empty());
  expect_contains(other.report().warnings()[0].message, "of code_saturne");
}

TEST(SolverCheck, LimitsOfFlexiAndCalculix) {
  // x = (1 + u)^2 on [-1, 1] of u in steps: det J of the first hexahedron is small at one end.
  const HexMesh mesh = two_hexes({.order = 2, .map = [](Vec3 x) { return Vec3{x.x * (x.x + 0.01), x.y, x.z}; }});
  expect_contains(failure("flexi", "cgns", mesh), "limit 0.01 of FLEXI");
  quadrille::Run run;
  check_for("nekrs", "re2", mesh, run);
  EXPECT_NO_THROW(check_for("calculix", "abaqus", samples::quad_mesh(), run));
  expect_contains(failure("calculix", "abaqus", samples::quad_mesh(), 1e-10), "limit 1e-20 of CalculiX");
}

TEST(SolverCheck, DealIIMeasuresDetJAtTheCornersByTheDiagonal) {
  const auto relative = [](const auto& mesh, double scale) {
    quadrille::Run run;
    check_for("dealii", "msh", mesh, run, scale);
    return reported<double>(run, "check_for.relative_jacobian.value");
  };
  const auto flat = [](double height) {  // 0.5 wide
    QuadMesh mesh = samples::quad_mesh();
    for (Vec2& x : mesh.nodes) x.y *= height;
    return mesh;
  };
  EXPECT_NEAR(relative(flat(1), 1), 0.5 / 1.25, 1e-12);
  EXPECT_NEAR(relative(flat(1e-8), 1e-3), 2e-8, 1e-14) << "in any unit";
  EXPECT_NEAR(relative(two_hexes({}), 1), 4 / 27.0, 1e-12) << "2 x 2 x 1";
  expect_contains(failure("dealii", "msh", flat(1e-10)), "limit 1e-09 of deal.II");
}

TEST(SolverCheck, OrdersAndFormatsThatTheProgramDoesNotReadAreRefused) {
  expect_contains(failure("code_saturne", "cgns", two_quads()), "hexsweep");
  expect_contains(failure("dealii", "msh", two_quads()), "up to order 1, these have order 2");
  EXPECT_EQ(order_refusal(*find_solver("dolfinx"), ElementKind::quads, 3), "");
  expect_contains(order_refusal(*find_solver("dolfinx"), ElementKind::hexahedra, 3), "lower --order");
  expect_contains(message_of<UsageError>([] { require_format_of_solver(*find_solver("openfoam"), "msh"); }),
                  "choose blockmesh, polymesh");
  EXPECT_NO_THROW(require_format_of_solver(*find_solver("mfem"), "mfem13"));
  EXPECT_EQ(find_solver("unheard-of"), nullptr);
}

}  // namespace
}  // namespace quadrille::stage
