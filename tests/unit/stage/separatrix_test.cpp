#include "stage/separatrix.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "graph/candidate_layout.hpp"
#include "graph/subdivision.hpp"
#include "stage/fieldsolve.hpp"
#include "triangulate/triangulate.hpp"
#include "two_squares.hpp"

namespace quadrille::stage {
namespace {

using namespace testing_stages;

struct Separatrix : testing::Test {
  TriMesh mesh = two_squares();
  quadrille::Run run;  // a fixture has a member Run
  Field field = fieldsolve({as_input(mesh, "x.tri.h5"), {}, {}, {}}, {}, run);
  CriticalPoints points = corners_of(mesh.face, "digest of x.field.h5");
  SeparatrixOptions options;

  SeparatrixGraph graph() {
    return separatrix(as_input(field, "x.field.h5"), as_input(points, "x.crit.json"), options, run);
  }
  std::string reason() { return reason_to_solve_for(as_input(points, "x.crit.json"), as_input(field, "x.field.h5")); }
};

TEST_F(Separatrix, RegionsHaveOneGraph) {
  const SeparatrixGraph made = graph();
  EXPECT_EQ(graph::require_four_corners(graph::Subdivision(made)), 2);
  EXPECT_EQ(made.face.num_regions(), 2);
  const ProvenanceStep& step = made.provenance.back();
  EXPECT_EQ(step.tool, "separatrix");
  ASSERT_EQ(step.inputs.size(), 2u);
  EXPECT_EQ(step.inputs[0].sha256, "digest of x.field.h5");
  EXPECT_EQ(step.inputs[1].format, "critical-points");
  EXPECT_NE(step.options.find("\"layout\":\"auto\""), std::string::npos) << step.options;
}

TEST_F(Separatrix, AnOpenInterfaceHasNodesOnBothSides) {
  options.interfaces = {"curve_1=nonconforming"};
  EXPECT_EQ(graph().nodes.size(), 8u);
  options.interfaces = {"nowhere=nonconforming"};
  EXPECT_THROW(graph(), UsageError);
}

TEST_F(Separatrix, OptionsOutsideTheirIntervalsAreUsageErrors) {
  options.max_deviation = 46;
  EXPECT_THROW(graph(), UsageError);
  options = {};
  options.max_lines = 0;
  EXPECT_THROW(graph(), UsageError);
  EXPECT_THROW(separatrix(as_input(mesh, "x.tri.h5"), options, run), UsageError);
}

TEST_F(Separatrix, AFieldIsSolvedForNodesThatItDoesNotHave) {
  EXPECT_EQ(reason(), "");
  points.corners[0].valence = 2;
  points.corners[1].valence = 0;
  points.form = NodeForm::phase;
  EXPECT_NE(reason().find("run fieldsolve --nodes"), std::string::npos) << reason();
  EXPECT_THROW(graph(), FormatError);
  points = corners_of(mesh.face, "digest of another field");
  EXPECT_NE(reason().find("was not made from"), std::string::npos) << reason();
  points.corners[0].joint = 99;
  points.provenance = corners_of(mesh.face, "digest of x.field.h5").provenance;
  EXPECT_THROW(reason(), FormatError);
}

TEST_F(Separatrix, TrianglesAloneAreDividedByAMesher) {
  EXPECT_THROW(separatrix(as_input(mesh, "x.tri.h5"), options, run), ComputeError);
  options.coarse_mesher = triangulate::coarse_triangles;
  const SeparatrixGraph of_triangles = separatrix(as_input(mesh, "x.tri.h5"), options, run);
  EXPECT_EQ(of_triangles.certificate.method, LayoutMethod::midpoint);
  EXPECT_EQ(of_triangles.provenance.back().inputs.front().format, "tri-mesh");
  options.layout = layout::LayoutChoice::midpoint;
  const SeparatrixGraph of_field = separatrix(as_input(field, "x.field.h5"), {}, options, run);
  EXPECT_EQ(of_field.nodes.size(), of_triangles.nodes.size());
  options.layout = layout::LayoutChoice::traced;
  EXPECT_THROW(separatrix(as_input(mesh, "x.tri.h5"), options, run), UsageError);
  EXPECT_THROW(separatrix(as_input(field, "x.field.h5"), {}, options, run), UsageError) << "no nodes";
}

}  // namespace
}  // namespace quadrille::stage
